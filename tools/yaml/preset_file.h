// Presets as files: an algorithm's parameters, as `lasius tune` writes them.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "lasius/params/params.h"
#include "tools/yaml/document.h"

namespace lasius::tool {

/// A map of parameters, each a text, over the defaults of an algorithm or of its textbook.
struct PresetFile {
  std::string algorithm;
  Preset preset = Preset::usual;  ///< what the others stand over
  std::vector<std::pair<std::string, std::string>> settings = {};
};

/// Reads {algorithm, preset: usual or book, set: {PARAMETER: VALUE}}, and tries the values.
/// @throws Error(file_missing), Error(file_broken) naming line and key, with the nearest known
/// algorithm or parameter.
PresetFile read_preset_file(const std::string& file);

/// @throws Error(file_broken) where settings hold evaporation and persistence.
void refuse_both_words(const Node& set);

/// Tries one value. @throws Error(file_broken) at `place`, saying what the library says.
void try_setting(Params& params, const std::string& name, const std::string& value,
                 const Node& place);

/// The defaults of an algorithm on bitmaps. @throws Error(file_broken) at `place`.
Params known_params(const std::string& algorithm, Preset preset, const Node& place);

}  // namespace lasius::tool
