// How near a colony comes to the exact optimum, over many seeds.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "bench/colony_figures.h"

namespace lasius::bench {

/// One plan.
struct QualityRun {
  double gap = 0;            ///< (length - optimum) / optimum; infinite without a path
  int last_improvement = 0;  ///< iteration, from 1, that found the answer; 0 without one
  int last_as_walked = 0;    ///< that found the shortest of all tours, before any polish
  double arrived = 0;        ///< share of all ants of all iterations
};

/// One course under one set of parameters, a run a seed.
struct Quality {
  std::string course;
  double optimum = 0;
  std::vector<QualityRun> runs;

  double median_gap() const;
  double worst_gap() const;
  double median_last_improvement() const;
  double median_last_as_walked() const;
  double least_arrived() const;
};

/// Plans the course with seeds 1 .. `seeds`, one thread a plan and as many plans at a time as there
/// are cores. The optimum is that of the exact search.
Quality measure_quality(const Course& course, const Params& params, int seeds);

/// The same parameters with pheromone switched off: the rule that reads distances only, as in the
/// first iteration. What is left is random walks that know the way, and straightening.
Params without_pheromone(Params params);

/// `count` generated blobs maps with a query from corner to corner, seeds from `seed`.
std::vector<Course> blobs_courses(int count, std::uint64_t seed, int width = 400, int height = 200);

}  // namespace lasius::bench
