#include "tools/bitmap/picture.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>

#include "tools/bitmap/cost_ground.h"
#include "tools/bitmap/sheet.h"
#include "tools/console/parameters.h"
#include "tools/draw/canvas.h"
#include "tools/draw/colours.h"
#include "tools/draw/line_chart.h"
#include "tools/draw/page.h"
#include "tools/draw/text.h"

namespace lasius::tool {
namespace {

constexpr Colour kAnts[] = {{0.74, 0.85, 0.95}, {0.26, 0.57, 0.78}, {0.03, 0.16, 0.38}};
constexpr Colour kLevelLine{0.35, 0.45, 0.62};
constexpr Colour kHeat[] = {{1, 0.98, 0.85}, {1, 0.8, 0.35}, {0.87, 0.32, 0.1}, {0.27, 0, 0.1}};
constexpr Colour kFar[] = {
    {0.27, 0, 0.33}, {0.13, 0.45, 0.56}, {0.37, 0.79, 0.38}, {0.99, 0.9, 0.14}};

/// From 1 ant a cell to the most.
ColourScale track_scale(double most) {
  return most > 1 ? ColourScale{{1, most}, true, kAnts} : ColourScale{{0, 1}, false, kAnts};
}

/// What of a trail has colours: values from `least` on.
struct TrailScale {
  ColourScale colours;
  double least = 0;
};

/// The part of the pheromone that tells cells apart: four decades below the most at most, and no
/// more than what 95% of the values in these have, if these differ. So neither a trail that has
/// evaporated nor one that is nearly the same everywhere makes a picture of one colour. Of an index
/// all that is known, the longest 1% as one colour.
TrailScale trail_scale(const Raster<float>& raster, bool index) {
  constexpr double kDecades = 1e-4;
  std::vector<float> values;
  for (const float v : raster.values)
    if (v > 0) values.push_back(v);
  if (values.empty()) return {{{0, 1}, false, kHeat}};
  std::ranges::sort(values, std::greater<>());
  if (index) return {{{0, std::max(1.0F, values[values.size() / 100])}, false, kFar}};
  // All ants meet at the start and goal: the few cells there would take a decade for themselves.
  const double high = values[std::min<std::size_t>(16, values.size() / 100)];
  const auto matter = std::ranges::count_if(values, [&](float v) { return v >= kDecades * high; });
  double low = values[static_cast<std::size_t>(matter * 95 / 100)];
  if (low >= high) low = values[static_cast<std::size_t>(matter - 1)];
  return {{{low, high}, high > 10 * low, kHeat}, low};
}

Panel path_panel(const Sheet& sheet, const Answer& answer, std::string caption) {
  if (!sheet.map.costs)
    return {std::move(caption), [&](Canvas& canvas, const Box& box) {
              paint_map(canvas, box, sheet, free_ground);
              draw_plan(canvas, box, sheet, answer);
            }};
  const CostField& costs = sheet.map.costs->field;
  const ColourScale scale = cost_scale(costs, sheet.map.as_read());
  caption += "; colours: weight of cells";
  const ShownLines lines =
      answer.shown_proof ? shown_lines(*answer.shown_proof, sheet.map.as_read()) : ShownLines();
  if (lines.apart > 0)
    caption += "; lines: cost to the goal, where the proof looked, " + short_number(lines.apart) +
               " apart";
  const auto draw = [&, scale, lines](Canvas& canvas, const Box& box) {
    paint_map(canvas, box, sheet, [&](Span columns, Span rows) {
      return cost_ground(costs, sheet.map.as_read(), scale, columns, rows);
    });
    canvas.clip(box);
    const Axes axes = sheet.axes(box);
    for (const auto& [from, to] : lines.lines)
      canvas.line(axes.at(from.x, from.y), axes.at(to.x, to.y), kLevelLine, 1);
    canvas.unclip();
    draw_bar(canvas, box, scale);
    draw_plan(canvas, box, sheet, answer);
  };
  return {.caption = std::move(caption), .draw = draw, .below = kBarHeight};
}

std::string path_caption(const Sheet& sheet, const Answer& answer) {
  const Result& result = answer.result;
  if (result.path.empty()) return no_path_text(result.status);
  std::string text = "path, length " + sheet.length(result.length);
  const auto place = [&](Point p) { return spot_text(sheet.map, sheet.run.frame, p); };
  const auto apart = [&](Point p, Cell c) {
    return sheet.length(std::hypot(p.x - c.x - 0.5, p.y - c.y - 0.5));
  };
  if (const auto& out = result.way_out)
    text += ", first " + apart(*out, answer.start.cell) + " out to " + place(*out);
  if (const auto end = short_end(answer))
    text += "; goal asked: " + place(centre(answer.goal.cell)) + ", reached: " + place(*end) +
            ", " + apart(*end, answer.goal.cell) + " from it";
  if (answer.over_costs) return text + ", " + cost_text(*answer.over_costs);
  if (result.optimal) return text + ", proven shortest";
  const auto compare = [&](double length, const char* name, const std::optional<double>& optimum) {
    if (optimum) text += against(length, *optimum, name, sheet.length(*optimum));
  };
  compare(result.length, "any-angle optimum", answer.optimum);
  if (const auto gap = grid_gap(answer, sheet.run.params)) {
    text += "; shortest walk";
    compare(*answer.grid_optimum * (1 + *gap), "optimum of the algorithm's own moves",
            answer.grid_optimum);
  }
  return text;
}

/// Tracks of single iterations above those of all up to them.
Band track_band(const Sheet& sheet, const Answer& answer, const PictureRecorder& recorder,
                const std::vector<PictureRecorder::Tracks>& tracks, const ColourScale& now,
                const ColourScale& so_far) {
  Band band{.rows = {{}, {}}, .small = true};
  for (const auto& kept : tracks) {
    const auto add = [&](std::size_t row, std::string caption, const Raster<std::uint32_t>& ants,
                         const ColourScale& scale) {
      const auto draw = [&](Canvas& canvas, const Box& box) {
        paint_map(canvas, box, sheet, [&](Span columns, Span rows) {
          const auto count =
              chosen(ants, recorder.cells_a_pixel(), columns, rows, std::greater<>());
          return count == 0 ? kFree : scale.at(count);
        });
        draw_marks(canvas, box, sheet, answer.start.at(), answer.goal.at(), true);
      };
      band.rows[row].push_back({std::move(caption), draw});
    };
    const std::string number = std::to_string(kept.iterations);
    std::string alone = "iteration " + number + " alone: " + std::to_string(kept.arrived) + " of " +
                        std::to_string(kept.ants) + (kept.ants == 1 ? " ant" : " ants") + " arrive";
    if (kept.arrived > 0) alone += ", mean tour " + sheet.length(kept.mean, sheet.metres() ? 2 : 0);
    add(0, std::move(alone), kept.now, now);
    add(1, "all ants up to iteration " + number, kept.so_far, so_far);
  }
  return band;
}

Panel trail_panel(const Sheet& sheet, const Answer& answer, const PictureRecorder& recorder) {
  const Params& params = sheet.run.params;
  const auto& trail = recorder.pheromone();
  const bool index = params.update == Update::terminal_index;
  const TrailScale scale = trail_scale(trail.values, index);
  const Range& range = scale.colours.range;
  std::string caption = (index ? "terminal index" : "pheromone") +
                        std::string(" after iteration ") + std::to_string(trail.iterations);
  if (index)
    caption +=
        ": best known way to the goal, cells; white: unknown; longest 1% as the end of the scale";
  else
    caption += std::string(scale.colours.logarithmic ? ", logarithmic; " : "; ") +
               (params.trail == Trail::arcs ? "the most on a cell's arcs; " : "") +
               (range.low < range.high ? "white: less than " : "the same on every cell: ") +
               short_number(range.low);
  const auto draw = [&, index, scale](Canvas& canvas, const Box& box) {
    paint_map(canvas, box, sheet, [&](Span columns, Span rows) {
      const int side = recorder.cells_a_pixel();
      const double value = index ? chosen(trail.values, side, columns, rows, std::less<>())
                                 : chosen(trail.values, side, columns, rows, std::greater<>());
      return value >= scale.least ? scale.colours.at(value) : kFree;
    });
    draw_bar(canvas, box, scale.colours);
    draw_marks(canvas, box, sheet, answer.start.at(), answer.goal.at(), false);
  };
  return {.caption = std::move(caption), .draw = draw, .below = kBarHeight};
}

void draw_run(Canvas& canvas, const Box& box, const Sheet& sheet, const Answer& answer) {
  const Result& result = answer.result;
  const bool colony = find_algorithm(sheet.run.params.algorithm()).kind == Algorithm::Kind::colony;
  const bool cut = sheet.run.params.walk_cut != WalkCut::none, several = sheet.run.params.ants > 1;
  static const std::vector<double> kNone;
  Convergence convergence{
      .best = {"best path so far", result.curves.best},
      .tours = {{colony ? "mean tour, as walked" : "mean of the population", result.curves.mean},
                {"mean tour after the cut", cut ? result.curves.cut_mean : kNone},
                {"shortest tour after the cut", cut && several ? result.curves.cut_best : kNone},
                {"shortest tour, as walked", !cut && several ? result.curves.raw_best : kNone}},
      .unit = sheet.unit(),
      .scale = sheet.map.length_in(sheet.run.frame, 1)};
  const auto level = [&](const char* name, const std::optional<double>& cells, Colour colour) {
    if (!cells) return;
    std::string label = name + std::string(" ") + sheet.length(*cells);
    // From there on the curve of the best path lies on the line.
    const auto on_it = [&](double best) { return std::abs(best - *cells) <= 1e-9 * *cells; };
    if (const auto at = std::ranges::find_if(result.curves.best, on_it);
        at != result.curves.best.end())
      label += ", reached in iteration " + std::to_string(at - result.curves.best.begin() + 1);
    convergence.levels.push_back({std::move(label), convergence.scale * *cells, colour});
  };
  level("any-angle optimum", answer.optimum, kInk);
  level("optimum of its own moves", answer.grid_optimum, {0.55, 0.25, 0.6});
  draw_convergence(canvas, box, convergence);
}

}  // namespace

void write_plan_picture(const std::string& file, const LoadedMap& map, const RunOptions& run,
                        const Answer& answer, const PictureRecorder* recorder) {
  const Sheet sheet{map, map.grid(), run, shown_of(map, {answer.start.cell, answer.goal.cell})};
  const auto tracks =
      recorder != nullptr ? recorder->tracks() : std::vector<PictureRecorder::Tracks>{};
  Page page = sheet.page(map_title(map, run));
  std::ranges::copy(keys_of_plan(sheet, answer), std::back_inserter(page.legend));
  std::uint32_t most = 0;
  for (const auto& kept : tracks) most = std::max(most, *std::ranges::max_element(kept.now.values));
  const ColourScale now = track_scale(most);
  const ColourScale so_far =
      track_scale(tracks.empty() ? 1 : *std::ranges::max_element(tracks.back().so_far.values));
  if (!tracks.empty()) {
    page.legend.push_back(scale_key("ants through a cell in one iteration", now));
    page.legend.push_back(scale_key("sum over all iterations so far, both logarithmic", so_far));
    page.bands.push_back(track_band(sheet, answer, *recorder, tracks, now, so_far));
  }
  std::vector<Panel> panels;
  if (recorder != nullptr && recorder->pheromone().iterations > 0)
    panels.push_back(trail_panel(sheet, answer, *recorder));
  panels.push_back(path_panel(sheet, answer, path_caption(sheet, answer)));
  if (!answer.result.curves.best.empty())
    panels.push_back({"convergence: best path so far; tours by iteration",
                      [&](Canvas& canvas, const Box& box) { draw_run(canvas, box, sheet, answer); },
                      true});
  page.bands.push_back({{std::move(panels)}});
  write_page(file, page);
}

void write_batch_picture(const std::string& file, const LoadedMap& map, const RunOptions& run,
                         const std::vector<std::vector<Point>>& paths, const std::string& caption) {
  const Sheet sheet{map, map.grid(), run, shown_of(map, {})};
  Page page = sheet.page(map_title(map, run));
  page.legend.push_back(line_key("path", kPath, 1.5));
  page.bands = {{{{{caption, [&](Canvas& canvas, const Box& box) {
                      paint_map(canvas, box, sheet, free_ground);
                      for (const auto& path : paths)
                        draw_marks(canvas, box, sheet, path.front(), path.back(), true);
                      for (const auto& path : paths) draw_path(canvas, box, sheet, path, 1.5, 0);
                    }}}}}};
  write_page(file, page);
}

}  // namespace lasius::tool
