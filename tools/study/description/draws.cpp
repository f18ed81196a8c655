#include "tools/study/description/draws.h"

#include <Random123/philox.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <set>

#include "lasius/base/error.h"
#include "lasius/plan/planner.h"
#include "tools/console/values.h"
#include "tools/study/map_source.h"

namespace lasius::study {
namespace {

constexpr std::uint32_t kMostAttempts = 1 << 20;

[[noreturn]] void fail(const Study& study, const Question& question, const std::string& problem,
                       const std::string& remedy, ErrorCode code = ErrorCode::file_broken) {
  throw Error(code, {.file = study.file, .line = question.line},
              "question \"" + question.name + "\" on " + question.map + ": " + problem, remedy);
}

/// The map as it is in its file, with what layers block.
Map map_of(const Study& study, const Question& question, const std::filesystem::path& maps) {
  try {
    return load_weighted_map(question, maps).map;
  } catch (const Error& fault) {
    if (fault.code() != ErrorCode::file_missing || !question.layers.empty()) throw;
    fail(study, question, fault.problem(), fault.remedy(), fault.code());
  }
}

/// Start, goal and radius in cells, of a question that has them in metres.
void take_cells(const Study& study, const Map& map, Question& question) {
  if (!question.in_metres) return;
  if (!map.frame)
    fail(study, question, "`frame: world`, but the map gives no frame",
         "name the .yaml file of a ROS map, or leave the frame out", ErrorCode::file_unsupported);
  const auto cell = [&](Point metres) {
    const Point cells = map.frame->to_cells(metres, map.grid.height());
    const auto whole = [](double n) { return static_cast<int>(std::clamp(n, -1e9, 1e9)); };
    return Cell{whole(std::floor(cells.x)), whole(std::ceil(cells.y) - 1)};
  };
  question.start = cell(question.start_m);
  question.goal = cell(question.goal_m);
  question.radius /= map.frame->resolution;
  if (question.inflation) {
    question.inflation->radius /= map.frame->resolution;
    question.inflation->scaling *= map.frame->resolution;
  }
  question.in_metres = false;
}

std::string cell_text(Cell c) { return std::to_string(c.x) + "," + std::to_string(c.y); }

void check_end(const Study& study, const Question& question, const Planner& planner,
               const char* name, Cell cell) {
  const Grid& grid = planner.passable();
  const bool outside = !grid.contains(cell);
  if (!outside && grid.free(cell)) return;
  const auto near = planner.nearest_free(cell);
  const std::string why = outside ? "outside"
                          : planner.grid().blocked(cell)
                              ? "blocked"
                              : "nearer to what is blocked than the radius of " +
                                    tool::rounded_text(question.radius, 6);
  fail(study, question, std::string(name) + ' ' + cell_text(cell) + " is " + why,
       near ? "the nearest free cell is " + cell_text(*near) : "the map has no free cell");
}

/// A start and a goal, the `number`-th of a draw.
void draw_ends(const Study& study, const Planner& planner, const Draw& draw, std::uint32_t number,
               Question& question) {
  const Grid& grid = planner.passable();
  const double apart = draw.apart * std::hypot(grid.width(), grid.height());
  const r123::Philox4x32::key_type key{
      {static_cast<std::uint32_t>(draw.seed), static_cast<std::uint32_t>(draw.seed >> 32)}};
  for (std::uint32_t attempt = 0; attempt < kMostAttempts; ++attempt) {
    const auto bits = r123::Philox4x32()({{attempt, number, 0xD4A3, 0}}, key);
    const auto below = [&](int i, int side) {
      return static_cast<int>(std::uint64_t{bits[static_cast<std::size_t>(i)]} *
                                  static_cast<std::uint64_t>(side) >>
                              32);
    };
    question.start = {below(0, grid.width()), below(1, grid.height())};
    question.goal = {below(2, grid.width()), below(3, grid.height())};
    const double distance =
        std::hypot(question.start.x - question.goal.x, question.start.y - question.goal.y);
    if (distance >= apart && question.start != question.goal && grid.free(question.start) &&
        grid.free(question.goal) && planner.connected(question.start, question.goal))
      return;
  }
  fail(study, question, "no two joined cells that far apart were found", "say a smaller `apart`");
}

}  // namespace

void draw_questions(Study& study, const std::filesystem::path& maps) {
  std::map<std::string, Map> read;
  std::map<std::pair<std::string, double>, Planner> planners;
  for (Experiment& experiment : study.experiments) {
    std::vector<Question> questions;
    for (Question& question : experiment.questions) {
      const std::string source = question.ground().first;
      auto map = read.find(source);
      if (map == read.end()) map = read.emplace(source, map_of(study, question, maps)).first;
      take_cells(study, map->second, question);
      if (question.inflation) question.inflation->inscribed = std::max(1.0, question.radius);
      auto at = planners.find(question.ground());
      if (at == planners.end())
        at = planners
                 .emplace(question.ground(), Planner(Grid(map->second.grid), Disc{question.radius}))
                 .first;
      const Planner& planner = at->second;
      if (!question.draw) {
        check_end(study, question, planner, "start", question.start);
        check_end(study, question, planner, "goal", question.goal);
        questions.push_back(question);
        continue;
      }
      for (int i = 0; i < question.draw->count; ++i) {
        Question& drawn = questions.emplace_back(question);
        drawn.draw.reset();
        if (question.draw->count > 1) drawn.name += '-' + std::to_string(i + 1);
        draw_ends(study, planner, *question.draw, static_cast<std::uint32_t>(i), drawn);
      }
    }
    std::set<std::string> names;
    for (const Question& question : questions)
      if (!names.insert(question.name).second)
        fail(study, question, "another question has this name", "give one another name");
    experiment.questions = std::move(questions);
  }
}

}  // namespace lasius::study
