#include "tools/study/sources/goritov2020.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <mutex>
#include <nlohmann/json.hpp>

#include "core/base/output.h"
#include "lasius/arm_generate.h"
#include "lasius/arm_plan.h"
#include "lasius/version.h"
#include "tools/console/team.h"
#include "tools/study/files.h"

namespace lasius::study {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

constexpr int kSide = 12;  // lattice points a side
constexpr int kObstacles = 12;

struct Case {
  arm::Scene scene;
  arm::Request request;
  arm::Params parameters;
};

Case make_case(const arm::Robot& robot, const ArmQuestion& question) {
  arm::Query query = arm::generate_query(
      robot, {.seed = question.seed, .obstacles = kObstacles, .wall = question.wall});
  Case c{std::move(query.scene),
         {.start = std::move(query.start), .goal = query.goal, .motion = false},
         {}};
  const Eigen::Vector3d from = arm::tip_position(robot, c.request.start), to = c.request.goal;
  const double widest =
      std::max({std::abs(from[0] - to[0]), std::abs(from[1] - to[1]), std::abs(from[2] - to[2])});
  c.parameters.side = kSide;
  c.parameters.pitch = widest / (0.6 * kSide);
  c.parameters.threads = 1;
  return c;
}

ArmGround measure(const arm::Robot& robot, const Case& c) {
  const arm::SceneSensor sensor(robot, c.scene);
  const arm::Result best = arm::shortest_lattice_way(robot, sensor, c.request, c.parameters);
  const arm::Result straight = arm::straight_lattice_way(robot, sensor, c.request, c.parameters);
  const Eigen::Vector3d from = arm::tip_position(robot, c.request.start), to = c.request.goal;
  const auto moves = [&](double a, double b) {
    return std::round(std::abs(a - b) / c.parameters.pitch);
  };
  const double nearest =
      c.parameters.pitch * (moves(from[0], to[0]) + moves(from[1], to[1]) + moves(from[2], to[2]));
  return {best.length, best.length / nearest, straight.status == Status::solved, best.points};
}

/// Numbers that repeat are kept once, with how often: best lengths change rarely.
Json packed(const std::vector<double>& values) {
  Json list = Json::array();
  for (std::size_t i = 0; i < values.size();) {
    std::size_t end = i;
    while (end < values.size() && values[end] == values[i]) ++end;
    list.push_back({values[i], end - i});
    i = end;
  }
  return list;
}

std::vector<double> unpacked(const Json& list) {
  std::vector<double> values;
  for (const Json& entry : list)
    values.insert(values.end(), entry.at(1).get<std::size_t>(),
                  entry.at(0).is_null() ? kUnknown : entry.at(0).get<double>());
  return values;
}

/// All runs of a setting on a question: one file.
struct Batch {
  std::size_t reading, setting, question;
  fs::path file;
  std::string key;
  arm::Params parameters;
};

std::optional<std::vector<ArmRun>> read_batch(const Batch& batch, int seeds) {
  std::ifstream in(batch.file, std::ios::binary);
  if (!in) return std::nullopt;
  try {
    const Json json = Json::parse(in);
    if (json.at("key") != batch.key) return std::nullopt;
    std::vector<ArmRun> runs;
    for (const Json& run : json.at("runs"))
      runs.push_back({unpacked(run.at("best")), unpacked(run.at("mean")), run.at("questions"),
                      run.at("steps")});
    if (static_cast<int>(runs.size()) < seeds) return std::nullopt;
    runs.resize(static_cast<std::size_t>(seeds));
    return runs;
  } catch (const std::exception&) {
    return std::nullopt;  // torn or foreign: the runs are done again
  }
}

void write_batch(const Batch& batch, const std::vector<ArmRun>& runs) {
  Json json = {{"key", batch.key}, {"runs", Json::array()}};
  for (const ArmRun& run : runs)
    json["runs"].push_back({{"best", packed(run.best)},
                            {"mean", packed(run.mean)},
                            {"questions", run.questions},
                            {"steps", run.steps}});
  write_file(batch.file.string(), [&](std::ostream& out) { out << json.dump() << '\n'; });
}

std::string key_of(const ArmQuestion& question, const arm::Params& parameters) {
  std::string key = "lasius " LASIUS_VERSION " question " + std::to_string(question.seed) + " " +
                    std::to_string(question.wall);
  for (const Parameter& p : arm::algorithms().front().parameters)
    key += ' ' + std::string(p.name) + '=' + arm::get_parameter(parameters, p.name);
  return key;
}

/// One for every reading, setting and question, their files in `folder`.
std::vector<Batch> all_batches(const fs::path& folder, const ArmFindings& findings,
                               const std::vector<Case>& cases) {
  std::vector<Batch> list;
  for (std::size_t r = 0; r < kReadings.size(); ++r) {
    for (std::size_t s = 0; s < findings.settings.size(); ++s) {
      for (std::size_t q = 0; q < findings.questions.size(); ++q) {
        const ArmSetting& setting = findings.settings[s];
        Batch batch{r, s, q, {}, {}, cases[q].parameters};
        for (const auto& [name, value] : setting.settings)
          arm::set_parameter(batch.parameters, name, value);
        arm::set_parameter(batch.parameters, "pheromone", kReadings[r]);
        batch.file = folder / (std::string(kReadings[r]) + "-" + setting.name() + "-" +
                               std::to_string(q + 1) + ".json");
        batch.key = key_of(findings.questions[q], batch.parameters);
        list.push_back(std::move(batch));
      }
    }
  }
  return list;
}

/// Nothing when it was stopped.
std::optional<std::vector<ArmRun>> run_batch(const arm::Robot& robot, const Case& c,
                                             const ArmGround& ground, const Batch& batch,
                                             const ArmStudyOptions& options) {
  const arm::SceneSensor sensor(robot, c.scene);
  arm::Request request = c.request;
  request.stop.token = options.stop;
  std::vector<ArmRun> runs;
  for (int seed = 1; seed <= options.seeds; ++seed) {
    arm::Params parameters = batch.parameters;
    parameters.seed = static_cast<std::uint64_t>(seed);
    arm::Result result = arm::plan(robot, sensor, request, parameters);
    if (result.status == Status::interrupted) return std::nullopt;
    ArmRun run{std::move(result.best), std::move(result.mean),
               result.questions.positions + result.questions.motions, result.steps};
    for (auto* curve : {&run.best, &run.mean})
      for (double& length : *curve) length /= ground.optimum;
    runs.push_back(std::move(run));
  }
  return runs;
}

}  // namespace

std::vector<ArmSetting> arm_settings() {
  std::vector<ArmSetting> list{{"base", ""}};
  const auto sweep = [&](const char* name, const char* parameter,
                         std::initializer_list<const char*> values) {
    for (const char* value : values) list.push_back({name, value, {{parameter, value}}});
  };
  sweep("alpha", "alpha", {"0", "2", "3", "4"});
  sweep("beta", "beta", {"0"});
  sweep("gamma", "gamma", {"0", "0.5", "1", "2"});
  sweep("rho", "evaporation", {"0", "0.5", "1"});
  sweep("m", "ants", {"4", "8", "16"});
  // At a fixed number of walks, m T = 6400.
  for (const char* iterations : {"8", "16", "25", "50", "200"})
    list.push_back(
        {"T",
         iterations,
         {{"iterations", iterations}, {"ants", std::to_string(6400 / std::stoi(iterations))}}});
  sweep("e", "elite_weight", {"16", "64", "256"});
  return list;
}

std::vector<ArmQuestion> arm_questions() {
  return {{6, 0},   {7, 0},   {8, 0},   {9, 0},   {11, 0},
          {4, 0.6}, {6, 0.6}, {7, 0.6}, {1, 0.6}, {3, 0.6}};
}

std::vector<ArmGround> arm_grounds(const fs::path& file) {
  const arm::Robot robot = arm::read_robot(file.string());
  std::vector<ArmGround> grounds;
  for (const ArmQuestion& question : arm_questions())
    grounds.push_back(measure(robot, make_case(robot, question)));
  return grounds;
}

const std::vector<std::vector<ArmRun>>& ArmFindings::of(std::size_t reading,
                                                        const std::string& name) const {
  const auto found = std::find_if(settings.begin(), settings.end(),
                                  [&](const ArmSetting& s) { return s.name() == name; });
  return runs[reading].at(static_cast<std::size_t>(found - settings.begin()));
}

std::optional<ArmFindings> run_arm_study(const ArmStudyOptions& options) {
  const arm::Robot robot = arm::read_robot(options.robot.string());
  ArmFindings findings{.seeds = options.seeds,
                       .questions = arm_questions(),
                       .grounds = arm_grounds(options.robot),
                       .settings = arm_settings(),
                       .runs = {}};
  std::vector<Case> cases;
  for (const ArmQuestion& question : findings.questions)
    cases.push_back(make_case(robot, question));
  for (auto& reading : findings.runs)
    reading.assign(findings.settings.size(),
                   std::vector<std::vector<ArmRun>>(findings.questions.size()));
  make_folder(options.folder / "runs");

  std::vector<Batch> todo;
  auto batches = all_batches(options.folder / "runs", findings, cases);
  for (Batch& batch : batches) {
    if (auto kept = read_batch(batch, options.seeds))
      findings.runs[batch.reading][batch.setting][batch.question] = std::move(*kept);
    else
      todo.push_back(std::move(batch));
  }
  const auto total = static_cast<std::int64_t>(batches.size());
  std::int64_t done = total - static_cast<std::int64_t>(todo.size());
  std::mutex telling;
  tool::share_out(todo.size(), options.threads, [&] {
    return [&](std::size_t i) {
      const Batch& b = todo[i];
      auto runs = run_batch(robot, cases[b.question], findings.grounds[b.question], b, options);
      if (!runs) return;
      write_batch(b, *runs);
      findings.runs[b.reading][b.setting][b.question] = std::move(*runs);
      const std::scoped_lock lock(telling);
      if (options.progress) options.progress(++done, total, b.file.stem().string());
    };
  });
  if (options.stop.stop_requested()) return std::nullopt;
  return findings;
}

}  // namespace lasius::study
