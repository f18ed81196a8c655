// The parts of a study's file. Each throws Error(file_broken) that names file, line and key.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "tools/study/description/sweep.h"
#include "tools/study/study.h"
#include "tools/yaml/document.h"

namespace lasius::study {

using tool::Node;

/// What each $WORD of an experiment's texts and values stands for.
using Words = std::vector<std::pair<std::string, std::string>>;
Words words_of(const Node* where);
std::string filled(std::string text, const Words& words);

/// The maps of a file by the names that its questions call them. A name may stand for several: a
/// family, one map for each size, density and seed.
class MapNames {
 public:
  /// `maps` may be null; `folder` is the file's own: a file that lies there is taken before one of
  /// the program's maps.
  MapNames(const Node* maps, std::filesystem::path folder);

  /// The sources of a question's map (see load_map): of a name, else what the text says itself.
  std::vector<std::string> sources(const Node& map) const;
  /// A file in the study's folder.
  std::string beside(const std::string& name) const;
  /// Every name with the sources of its maps.
  std::vector<std::pair<std::string, std::vector<std::string>>> all() const { return named_; }

 private:
  std::vector<std::string> sources_of(const Node& map) const;
  std::string source_of(const Node& map) const;

  std::filesystem::path folder_;
  std::vector<std::pair<std::string, std::vector<std::string>>> named_;
};

/// A list of {name, map, start, goal, published} or {name, map, draw}. A question of a name that
/// stands for several maps is asked on each; one without a map on all that have a name. On other
/// worlds than bitmaps (`maps` null) the map is taken as it is.
std::vector<Question> questions_of(const Node& list, const MapNames* maps);

/// The contenders of a study's file that `compare` names, all where it is null, each as often as
/// the sweep has points. `checked`: their algorithms are those on bitmaps, and settings are tried.
std::vector<Contender> contenders_of(const Node& study, const Node* compare, const Words& words,
                                     const std::filesystem::path& folder, bool checked);

/// The contender that a map {algorithm, preset, set, budget} describes, as it is at a point of its
/// parameters that stands at `place`; both may be left out. On bitmaps.
Contender described_contender(const Node& map, const std::string& name, const Settings& point,
                              const Node* place, const std::filesystem::path& folder);

/// {NAME: [values]} or {NAME: {from, to, scale, levels}} for parameters of these algorithms.
std::vector<Factor> factors_of(const Node& map, const std::vector<std::string>& algorithms);

/// {iterations, steps, seconds}; with steps or seconds alone, iterations do not end a run.
Budget budget_of(const Node* budget);
/// What a budget says of iterations; empty: nothing.
std::string iterations_of(const Node* budget);

/// "N": 1 to N; "A..B" or "A-B".
Seeds seeds_of(const Node* seeds, Seeds usual);

/// The {value, at, target, best_of, own_limit} of a claim.
Value value_of_claim(const Node& claim);

/// "any-angle", "4 moves", "8 moves"; the first where it is null.
Optimum optimum_of(const Node* optimum);

/// One test, or one for each control of `b` and each experiment of `in_each`.
std::vector<Claim> claims_of(const Node& claim, const std::vector<Experiment>& experiments);

}  // namespace lasius::study
