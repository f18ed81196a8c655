#include "tools/study/sources/tours.h"

#include <fstream>
#include <random>
#include <sstream>

#include "lasius/base/error.h"
#include "lasius/tour/tour.h"

namespace lasius::study {
namespace {

constexpr std::string_view kDrawn = "drawn ";

Tsplib drawn_instance(const std::string& map) {
  std::istringstream words(map.substr(kDrawn.size()));
  int count = 0;
  std::uint32_t seed = 0;
  words >> count >> seed;
  std::mt19937 random(seed);
  std::stringstream text;
  text << "TYPE: TSP\nDIMENSION: " << count << "\nEDGE_WEIGHT_TYPE: EUC_2D\nNODE_COORD_SECTION\n";
  for (int i = 1; i <= count; ++i) {
    constexpr std::uint32_t kSide = 10'000;
    const auto x = random() % kSide, y = random() % kSide;
    text << i << ' ' << x << ' ' << y << '\n';
  }
  text << "EOF\n";
  return read_tsplib(text, map);
}

Tsplib instance_of(const std::string& map, const std::filesystem::path& maps) {
  if (map.starts_with(kDrawn)) return drawn_instance(map);
  const std::string file = (maps / map).string();
  std::ifstream in(file);
  if (!in)
    throw Error(ErrorCode::file_missing, {.file = file}, "cannot be opened",
                "name its folder by --maps");
  return read_tsplib(in, file);
}

}  // namespace

StopTours::StopTours(const Study& study, const std::filesystem::path& maps) {
  for (const Experiment& experiment : study.experiments)
    for (const Question& question : experiment.questions)
      if (!instances_.contains(question.map))
        instances_.emplace(question.map, instance_of(question.map, maps));
}

PreparedRun StopTours::prepare(const Question& question, const Contender& contender) const {
  const Tsplib& instance = instances_.at(question.map);
  const auto params = configured(tour::AntParams(contender.algorithm), contender);
  PreparedRun prepared =
      run_of(question.map + ' ' + contender.algorithm, params,
             tour::find_algorithm(contender.algorithm).parameters, instance.size);
  if (prepared.paths_an_iteration == 0) prepared.paths_an_iteration = instance.size;  // one a stop
  prepared.work =
      std::int64_t{prepared.paths_an_iteration} * std::max(params.iterations, 1) * instance.size;
  prepared.run = [&instance, params](std::uint64_t seed, bool pilot, const std::stop_token& stop,
                                     Workspace&) {
    TourRequest request;
    request.seed = seed;
    request.threads = 1;
    request.ants = params;
    request.stop.token = stop;
    if (pilot && params.algorithm() == "exact")
      request.generations = pilot_part(request.generations);
    if (pilot && params.algorithm() != "exact")
      request.ants.iterations = pilot_part(params.iterations);
    const double begin = thread_seconds();
    const TourResult tour = plan_tour(instance, request);
    Run run{.status = tour.status,
            .iterations = tour.curves.iterations,
            .seconds = thread_seconds() - begin,
            .best = tour.curves.best,
            .mean = tour.curves.mean};
    if (!tour.order.empty()) run.length = tour.length;
    return run;
  };
  return prepared;
}

std::vector<std::string> leave_out_absent(Study& study, const std::filesystem::path& maps) {
  std::vector<std::string> absent, emptied;
  for (Experiment& experiment : study.experiments) {
    std::erase_if(experiment.questions, [&](const Question& question) {
      if (question.map.starts_with(kDrawn) || std::filesystem::exists(maps / question.map))
        return false;
      absent.push_back(question.map);
      return true;
    });
    if (experiment.questions.empty()) emptied.push_back(experiment.name);
  }
  const auto is_empty = [&](const std::string& name) {
    return std::ranges::count(emptied, name) > 0;
  };
  std::erase_if(study.experiments, [](const Experiment& one) { return one.questions.empty(); });
  for (Claim& claim : study.claims) {
    if (claim.test == Claim::Test::none) continue;
    std::erase_if(claim.in, is_empty);
    if (!claim.in.empty()) continue;
    claim.test = Claim::Test::none;
    claim.baseline.clear();
    claim.note = "its instances are not among the maps; name their folder by --maps";
  }
  return absent;
}

}  // namespace lasius::study
