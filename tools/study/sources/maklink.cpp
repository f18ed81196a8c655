#include "tools/study/sources/maklink.h"

#include <algorithm>

namespace lasius::study {
namespace {

constexpr const char* kGenes = "real-ga";
constexpr int kCrossed = 9;  // lines, for the estimate of work

}  // namespace

MaklinkWorld::MaklinkWorld(const Study& study, const std::filesystem::path& maps)
    : planner_(
          polygon::read_world((maps / study.experiments.front().questions.front().map).string())) {}

PreparedRun MaklinkWorld::prepare(const Question& question, const Contender& contender) const {
  const auto params = configured(polygon::Params(contender.algorithm), contender);
  PreparedRun prepared = run_of(question.map + ' ' + contender.algorithm, params,
                                polygon::find_algorithm(contender.algorithm).parameters, kCrossed);
  prepared.run = [this, params](std::uint64_t seed, bool pilot, const std::stop_token& stop,
                                Workspace&) {
    auto seeded = params;
    seeded.seed = seed;
    if (pilot) seeded.iterations = pilot_part(params.iterations);
    const auto timed = [&] {
      const double begin = thread_seconds();
      auto result = planner_.plan({.start = {}, .goal = {}, .stop = {.token = stop}}, seeded);
      return std::pair{thread_seconds() - begin, std::move(result)};
    };
    const auto [seconds, result] = timed();
    seeded.iterations = 0;
    const double rest = timed().first;  // graph search and optima
    const auto& limit =
        params.algorithm() == kGenes ? result.sequence_optimum : result.discrete_optimum;
    return Run{.status = result.status,
               .length = result.length,
               .iterations = result.curves.iterations,
               .seconds = std::max(0.0, seconds - rest),
               .best = result.curves.best,
               .limit = limit ? limit->length : kUnknown,
               .reference = result.dijkstra ? result.dijkstra->length : kUnknown};
  };
  return prepared;
}

std::optional<double> MaklinkWorld::optimum(const Question&, const Optimum&,
                                            const StopCondition&) const {
  return planner_.plan().length;
}

}  // namespace lasius::study
