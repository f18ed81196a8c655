// What a run gives: data on standard output, then files.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "options.h"
#include "outcome.h"

namespace lasius::tool {

/// The forms of one result, each made when it is asked for.
struct Forms {
  std::function<std::string()> text;
  std::function<std::string()> json;  ///< one line
  std::function<std::string()> csv;
  std::function<void(const std::string& file)> write_picture;
};

/// Says on standard error how a run ended, where that is worth a word or it has no path.
void report(const Outcome& outcome, const Messages& messages);

/// Prints text, or JSON where `json`, and writes the files by their endings. What standard output
/// refuses the files still get. @throws Error(output_failed).
void deliver(const Forms& forms, bool json, const std::vector<std::string>& files,
             const Messages& messages);

}  // namespace lasius::tool
