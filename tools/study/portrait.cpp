#include "tools/study/portrait.h"

#include <algorithm>

#include "lasius/error.h"
#include "tools/bitmap/answer.h"
#include "tools/bitmap/picture.h"
#include "tools/bitmap/picture_recorder.h"
#include "tools/draw/legend.h"
#include "tools/draw/line_chart.h"
#include "tools/draw/map_panel.h"
#include "tools/study/bitmaps.h"
#include "tools/study/map_source.h"

namespace lasius::study {
namespace {

namespace fs = std::filesystem;

/// Where a run is drawn.
struct Place {
  const Experiment& experiment;
  const Question& question;
  const Params& params;
  fs::path folder, maps;
  std::string stem() const { return "pictures/" + experiment.name + "-" + question.name + "-run"; }
  const std::string& label() const { return experiment.contenders.front().label; }
};

Figure draw_run(const Place& place, const StopCondition& stop) {
  tool::RunOptions run;
  run.map.file = (place.maps / place.question.map).string();
  run.params = place.params;
  const tool::LoadedMap map = tool::load_map(run.map);
  tool::PictureRecorder recorder(map.grid(), run.track_iterations, run.params);
  const auto at = [&](Cell c) { return tool::to_place(map, {1.0 * c.x, 1.0 * c.y}, run.frame); };
  const tool::Answer found =
      tool::answer(map, run, at(place.question.start), at(place.question.goal), stop,
                   [&](const GridProgress& progress) { recorder.observe(progress); });
  for (const char* ending : {".svg", ".png"})
    tool::write_plan_picture((place.folder / (place.stem() + ending)).string(), map, run, found,
                             &recorder);
  return {&place.experiment, place.stem(),
          "One run of " + place.label() +
              " (seed 1): tracks of single iterations and of all up to them, pheromone, path and "
              "convergence"};
}

/// What is kept of the ants of a run, one an iteration.
struct Ants {
  std::vector<double> number, tour;  ///< of those that arrived
  std::vector<Cell> dead, arrived;   ///< the longest walk into a dead end, and the last success
  int dead_ant = 0, arrived_ant = 0;

  void observe(const GridProgress& progress) {
    const int ant = progress.iteration + 1;
    auto walk = progress.walk(0);
    if (progress.arrived > 0) {
      number.push_back(ant);
      tour.push_back(progress.mean_length);
      arrived = std::move(walk);
      arrived_ant = ant;
    } else if (walk.size() > dead.size()) {
      dead = std::move(walk);
      dead_ant = ant;
    }
  }
};

void draw_walk(Canvas& canvas, const Box& box, const Grid& grid, const Question& question,
               const std::vector<Cell>& walk, Colour colour, const std::string& caption) {
  const double scale = box.width / grid.width();
  paint_walls(canvas, box, grid);
  std::vector<Point> points;
  for (const Cell c : walk)
    points.push_back({box.x + (c.x + 0.5) * scale, box.y + (c.y + 0.5) * scale});
  mark_ends(canvas, box, scale, question.start, question.goal);
  canvas.polyline(points, colour, 3);
  canvas.text({box.x + box.width / 2, box.y + box.height + tool::kAxisBottom + 18}, caption, 15,
              Align::centre, kInk);
}

Figure draw_ants(const Place& place, const StopCondition& stop) {
  const Planner planner(load_map(place.question.map, place.maps));
  Ants ants;
  (void)planner.plan({place.question.start, place.question.goal, stop}, place.params, nullptr,
                     [&](const GridProgress& progress) { ants.observe(progress); });
  constexpr double kEdge = 20, kSide = 420, kChart = 420, kPlace = tool::kAxisLeft + kSide;
  const Grid& grid = planner.grid();
  const double high = kSide * grid.height() / grid.width();
  const double below = high + 2 * kEdge + tool::kAxisBottom + 28;
  Canvas canvas;
  draw_walk(canvas, {kEdge + tool::kAxisLeft, kEdge, kSide, high}, grid, place.question, ants.dead,
            palette(1), "ant " + std::to_string(ants.dead_ant) + " dies in a dead end");
  draw_walk(canvas, {2 * kEdge + kPlace + tool::kAxisLeft, kEdge, kSide, high}, grid,
            place.question, ants.arrived, palette(0),
            "ant " + std::to_string(ants.arrived_ant) + " arrives");
  const double keys =
      tool::draw_legend(canvas, {kEdge + tool::kAxisLeft, below}, kPlace,
                        {tool::start_key(), tool::goal_key(), tool::area_key("blocked", kMapWall)});
  canvas.resize(2 * kPlace + 3 * kEdge, below + keys + kChart + 2 * kEdge);
  LineChart chart{.title = "Tours of " + place.label() + " on " + place.question.name,
                  .x_label = "ant",
                  .y_label = "length, cells"};
  chart.curves.push_back(
      {.label = "ants that arrive", .colour = palette(0), .x = ants.number, .y = ants.tour});
  chart.curves.back().dots = true;
  draw(canvas, {kEdge, below + keys + kEdge, 2 * kPlace + kEdge, kChart}, chart);
  save(canvas, place.folder / place.stem());
  return {
      &place.experiment, place.stem(),
      "One run of " + place.label() + " (seed 1): a dead end, a success, and the tours ant by ant"};
}

}  // namespace

std::vector<Figure> draw_portraits(const Study& study, const fs::path& folder, const fs::path& maps,
                                   const StopCondition& stop) {
  std::vector<Figure> figures;
  for (const Experiment& experiment : study.experiments) {
    if (!experiment.portrait && !experiment.by_ant) continue;
    Params params;
    try {
      params = params_of(experiment.contenders.front());
    } catch (const Error&) {
      continue;  // the report names it among those not run
    }
    for (const Question& question : experiment.questions) {
      const Place place{experiment, question, params, folder, maps};
      figures.push_back(experiment.by_ant ? draw_ants(place, stop) : draw_run(place, stop));
    }
  }
  return figures;
}

}  // namespace lasius::study
