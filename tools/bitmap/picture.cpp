#include "tools/bitmap/picture.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>

#include "tools/draw/canvas.h"
#include "tools/draw/chart.h"
#include "tools/draw/colours.h"
#include "tools/draw/page.h"
#include "tools/draw/text.h"
#include "tools/record/json_values.h"

namespace lasius::tool {
namespace {

constexpr Colour kWall{0.2, 0.23, 0.27};
constexpr Colour kTintedWall{0.98, 0.87, 0.68};  // under grey pheromone
constexpr Colour kTrackFew{0.8, 0.88, 0.96};
constexpr Colour kTrackSome{0.26, 0.57, 0.78};
constexpr Colour kTrackMany{0.03, 0.19, 0.42};

/// One panel's map part: from cells to the page.
class MapView {
 public:
  MapView(const Grid& grid, const Box& box) : grid_(grid), box_(box) {}
  Point at(Point p) const {
    return {box_.x + p.x * box_.width / grid_.width(), box_.y + p.y * box_.height / grid_.height()};
  }
  /// Pixels of the image behind: one a cell, or one a pixel of the page where cells are smaller.
  int pixels_wide() const { return std::min(grid_.width(), static_cast<int>(box_.width)); }
  int pixels_high() const { return std::min(grid_.height(), static_cast<int>(box_.height)); }

 private:
  const Grid& grid_;
  Box box_;
};

/// Paints walls over what `ground` says of the cells under a pixel. Walls never get so thin that
/// they vanish.
void paint_map(Canvas& canvas, const Box& box, const Grid& grid, Colour wall,
               const std::function<Colour(Span columns, Span rows)>& ground) {
  const MapView view(grid, box);
  const auto share = blocked_share(grid, view.pixels_wide(), view.pixels_high());
  Raster<Colour> pixels(share.width, share.height);
  for (int y = 0; y < share.height; ++y) {
    const Span rows = cells_under(y, share.height, grid.height());
    for (int x = 0; x < share.width; ++x) {
      const double blocked = share.at(x, y);
      const double shown = blocked > 0 ? std::max(0.35, std::sqrt(blocked)) : 0;
      const Span columns = cells_under(x, share.width, grid.width());
      pixels.at(x, y) = blend(ground(columns, rows), wall, shown);
    }
  }
  canvas.image(pixels, box);
  canvas.frame(box, kInk, 1);
}

Colour free_ground(Span, Span) { return kFree; }

/// The largest value of a recorder's raster over some cells.
template <class T>
T largest(const Raster<T>& raster, int cells_a_pixel, Span columns, Span rows) {
  T most{};
  for (int y = rows.from / cells_a_pixel; y <= (rows.to - 1) / cells_a_pixel; ++y)
    for (int x = columns.from / cells_a_pixel; x <= (columns.to - 1) / cells_a_pixel; ++x)
      most = std::max(most, raster.at(x, y));
  return most;
}

void draw_tracks(Canvas& canvas, const Box& box, const Grid& grid,
                 const Raster<std::uint32_t>& visits, int cells_a_pixel) {
  const auto most = *std::max_element(visits.values.begin(), visits.values.end());
  const double scale = 1 / std::log1p(std::max(1.0, static_cast<double>(most)));
  paint_map(canvas, box, grid, kPaleWall, [&](Span columns, Span rows) {
    const auto count = largest(visits, cells_a_pixel, columns, rows);
    if (count == 0) return kFree;
    const double share = std::log1p(static_cast<double>(count)) * scale;
    return share < 0.5 ? blend(kTrackFew, kTrackSome, 2 * share)
                       : blend(kTrackSome, kTrackMany, 2 * share - 1);
  });
}

/// White where there is least, black where there is most; four decades of grey between.
void draw_pheromone(Canvas& canvas, const Box& box, const Grid& grid, const Raster<float>& values,
                    int cells_a_pixel) {
  constexpr double kDecades = 4;
  const double most = *std::max_element(values.values.begin(), values.values.end());
  paint_map(canvas, box, grid, kTintedWall, [&](Span columns, Span rows) {
    const double value = largest(values, cells_a_pixel, columns, rows);
    if (!(value > 0)) return kFree;
    const double share = 1 + std::log10(value / most) / kDecades;
    return blend(kFree, Colour{0, 0, 0}, std::clamp(share, 0.0, 1.0));
  });
}

void draw_path(Canvas& canvas, const MapView& view, const std::vector<Point>& path, double width,
               double rim) {
  std::vector<Point> points;
  points.reserve(path.size());
  for (const Point p : path) points.push_back(view.at(p));
  if (rim > 0) canvas.polyline(points, {1, 1, 1}, width + 2 * rim);
  canvas.polyline(points, kPath, width);
}

void draw_marks(Canvas& canvas, const MapView& view, const Grid& grid, const Answer& answer) {
  if (grid.contains(answer.start.cell)) canvas.disc(view.at(centre(answer.start.cell)), 7, kStart);
  if (grid.contains(answer.goal.cell)) canvas.diamond(view.at(centre(answer.goal.cell)), 9, kGoal);
}

std::string plan_title(const LoadedMap& map, const RunOptions& run) {
  return run.params.algorithm() + " on " + std::filesystem::path(map.file).filename().string() +
         ", " + std::to_string(map.width) + " x " + std::to_string(map.height) + " cells, seed " +
         std::to_string(run.params.seed);
}

std::string path_caption(const LoadedMap& map, Frame frame, const Answer& answer) {
  const Result& result = answer.result;
  if (result.path.empty()) return std::string(to_string(result.status)) + ": no path";
  std::string text = "path, length ";
  text += study::fixed(map.length_in(frame, result.length), 2);
  if (frame == Frame::world) text += " m";
  if (result.optimal) return text + ", proven shortest";
  if (answer.optimum && *answer.optimum > 0)
    text += ", " + study::fixed(100 * *gap_to(answer.optimum, result.length), 2) +
            "% above the optimum";
  return text;
}

}  // namespace

void write_plan_picture(const std::string& file, const LoadedMap& map, const RunOptions& run,
                        const Answer& answer, const PictureRecorder* recorder) {
  const Grid& grid = map.grid();
  const auto tracks =
      recorder != nullptr ? recorder->tracks() : std::vector<PictureRecorder::Tracks>{};
  std::vector<Panel> panels;
  panels.reserve(tracks.size() + 3);
  for (const auto& kept : tracks)
    panels.push_back({"tracks of all ants up to iteration " + std::to_string(kept.iterations),
                      [&](Canvas& canvas, const Box& box) {
                        draw_tracks(canvas, box, grid, kept.visits, recorder->cells_a_pixel());
                        draw_marks(canvas, MapView(grid, box), grid, answer);
                      }});
  if (recorder != nullptr && recorder->pheromone().iterations > 0)
    panels.push_back(
        {"pheromone after iteration " + std::to_string(recorder->pheromone().iterations),
         [&](Canvas& canvas, const Box& box) {
           draw_pheromone(canvas, box, grid, recorder->pheromone().values,
                          recorder->cells_a_pixel());
           draw_marks(canvas, MapView(grid, box), grid, answer);
         }});
  panels.push_back({path_caption(map, run.frame, answer), [&](Canvas& canvas, const Box& box) {
                      const MapView view(grid, box);
                      paint_map(canvas, box, grid, kWall, free_ground);
                      draw_path(canvas, view, answer.result.path, 3, 1);
                      draw_marks(canvas, view, grid, answer);
                    }});
  if (!answer.result.best.empty())
    panels.push_back({"convergence",
                      [&](Canvas& canvas, const Box& box) {
                        Convergence curves{answer.result.best, answer.result.mean, answer.optimum};
                        const auto show = [&](double& cells) {
                          cells = map.length_in(run.frame, cells);
                        };
                        std::ranges::for_each(curves.best, show);
                        std::ranges::for_each(curves.mean, show);
                        if (curves.optimum) show(*curves.optimum);
                        if (run.frame == Frame::world) curves.unit = "metres";
                        draw_convergence(canvas, box, curves);
                      },
                      true});
  write_page(file, plan_title(map, run),
             map_layout(static_cast<int>(panels.size()), grid.width(), grid.height()), panels);
}

void write_batch_picture(const std::string& file, const LoadedMap& map, const RunOptions& run,
                         const std::vector<std::vector<Point>>& paths) {
  const Grid& grid = map.grid();
  const Panel panel{std::to_string(paths.size()) + " paths", [&](Canvas& canvas, const Box& box) {
                      const MapView view(grid, box);
                      paint_map(canvas, box, grid, kWall, free_ground);
                      for (const auto& path : paths) draw_path(canvas, view, path, 1.5, 0);
                    }};
  write_page(file, plan_title(map, run), map_layout(1, grid.width(), grid.height()), {panel});
}

}  // namespace lasius::tool
