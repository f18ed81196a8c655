#include "tools/study/portrait.h"

#include "lasius/base/error.h"
#include "tools/bitmap/answer.h"
#include "tools/bitmap/picture.h"
#include "tools/bitmap/picture_recorder.h"
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

Figure draw_run(const Place& place) {
  tool::RunOptions run;
  run.map.file = (place.maps / place.question.map).string();
  run.map.radius = place.question.radius;
  for (const auto& [file, factor] : place.question.layers)
    run.map.costs.layers.push_back({(place.maps / file).string(), factor});
  if (const auto& inflation = place.question.inflation)
    run.map.costs.inflation = {inflation->radius, inflation->scaling, inflation->weight};
  run.params = place.params;
  const tool::LoadedMap map = tool::load_map(run.map);
  tool::PictureRecorder recorder(map.grid(), run.track_iterations, run.params);
  const auto at = [&](Cell c) { return tool::to_place(map, {1.0 * c.x, 1.0 * c.y}, run.frame); };
  const tool::Answer found =
      tool::answer(map, run, at(place.question.start), at(place.question.goal), {},
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

Figure draw_ants(const Place& place) {
  const Planner planner(load_map(place.question, place.maps));
  Ants ants;
  (void)planner.plan({place.question.start, place.question.goal}, place.params,
                     {.observer = [&](const GridProgress& progress) { ants.observe(progress); }});
  const Grid& grid = planner.grid();
  const auto walk = [&](const std::vector<Cell>& cells, std::size_t colour, std::string caption) {
    const auto draw = [&, colour](tool::Canvas& canvas, const tool::Box& box) {
      std::vector<Point> points;
      for (const Cell c : cells) points.push_back(centre(c));
      const auto axes =
          tool::draw_map(canvas, box, grid, place.question.start, place.question.goal);
      canvas.polyline(axes.at(points), tool::palette(colour), 3);
    };
    return tool::Panel{std::move(caption), draw};
  };
  tool::LineChart chart{.title = "Tours of " + place.label() + " on " + place.question.name,
                        .x_label = "ant",
                        .y_label = "length, cells"};
  chart.curves.push_back(
      {.label = "ants that arrive", .colour = tool::palette(0), .x = ants.number, .y = ants.tour});
  chart.curves.back().dots = true;
  const auto tours = [&](tool::Canvas& canvas, const tool::Box& box) { draw(canvas, box, chart); };
  save(
      tool::Page{
          .title = "",
          .legend = tool::map_keys(),
          .wide = 1.0 * grid.width(),
          .high = 1.0 * grid.height(),
          .bands = {{.rows = {{walk(ants.dead, 1,
                                    "ant " + std::to_string(ants.dead_ant) + " dies in a dead end"),
                               walk(ants.arrived, 0,
                                    "ant " + std::to_string(ants.arrived_ant) + " arrives"),
                               {"", tours, true}}},
                     .small = true,
                     .columns = 2}}},
      place.folder / place.stem());
  return {
      &place.experiment, place.stem(),
      "One run of " + place.label() + " (seed 1): a dead end, a success, and the tours ant by ant"};
}

}  // namespace

std::vector<Figure> draw_portraits(const Study& study, const fs::path& folder,
                                   const fs::path& maps) {
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
      figures.push_back(experiment.by_ant ? draw_ants(place) : draw_run(place));
    }
  }
  return figures;
}

}  // namespace lasius::study
