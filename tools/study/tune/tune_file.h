// What is tuned, on which maps, and how it is judged: as a file.
#pragma once

#include <string>
#include <vector>

#include "tools/study/study.h"
#include "tools/study/tune/race.h"

namespace lasius::study {

struct Tuning {
  std::string name, file;
  /// The first is the default: what the others differ from in the tuned parameters, their factors.
  std::vector<Contender> candidates = {};
  Settings fixed = {};  ///< over the algorithm's defaults, in all candidates
  Value value = {};     ///< of a run, the less the better
  Optimum optimum = {};
  RaceRules rules = {};
  int blocks = 40;      ///< at most
  Study training = {};  ///< one experiment, "race", of all candidates
  Study judging = {};   ///< one experiment, "judge", still without candidates
};

/// A tuning from YAML or JSON, a map with
///   name        default the file's
///   algorithm   on bitmaps; preset: book or a preset's file; set: {parameter: value}: what all
///               candidates have
///   parameters  {parameter: [values] or {from, to, scale: linear or log}}
///   candidates  how many, the default among them; the others are a Latin hypercube by `seed`
///   budget      {iterations, steps, seconds} of a run
///   value, at, target  what a run is judged by, as in claims of a study; default its length
///   optimum     as in studies
///   maps        as in studies
///   training    questions as in studies; a race's blocks are these in turn, with seed 1, then 2,
///               and so on
///   judging     questions on other maps; without: the training's on maps of other seeds, which
///               have to be generated, their ends drawn
///   seeds       of the runs that judge; default 1 to 10
///   race        {first_test, blocks, level}
/// @throws Error(file_broken) for anything else, naming line and key, with the nearest known one;
/// Error(file_missing).
Tuning read_tuning(const std::string& file);

}  // namespace lasius::study
