#include "tools/drive/drive_picture.h"

#include <algorithm>

#include "tools/bitmap/cost_ground.h"
#include "tools/bitmap/sheet.h"
#include "tools/console/values.h"
#include "tools/draw/colours.h"
#include "tools/draw/page.h"
#include "tools/draw/text.h"
#include "tools/vehicle/vehicle_picture.h"

namespace lasius::tool {
namespace {

constexpr Colour kTimes[] = {
    {0.05, 0.2, 0.55}, {0.1, 0.5, 0.6}, {0.25, 0.68, 0.4}, {0.75, 0.75, 0.1}};
constexpr Colour kNotLearned{0.94, 0.6, 0.62};
constexpr Colour kOnlyOnMap{0.98, 0.86, 0.7};
constexpr Colour kMoving{0.55, 0.2, 0.65};
constexpr double kPale = 0.22;  ///< share of a tick's colour on free cells seen then

/// The cells for which `both` is so of the words of two maps.
template <class Both>
Grid combined(const Grid& a, const Grid& b, const Both& both) {
  Grid result(a.width(), a.height());
  std::vector<std::uint64_t> words(static_cast<std::size_t>(a.words()));
  for (int y = 0; y < a.height(); ++y) {
    std::transform(a.row(y), a.row(y) + a.words(), b.row(y), words.begin(), both);
    result.set_row(y, words.data());
  }
  return result;
}

/// What was there at last against the map.
struct Walls {
  Grid both, learnable, only_on_map;

  Walls(const Grid& map, const Grid& there)
      : both(combined(map, there, std::bit_and<>())),
        learnable(combined(there, map, [](auto t, auto m) { return t & ~m; })),
        only_on_map(combined(map, there, [](auto m, auto t) { return m & ~t; })) {}
};

ColourScale time_scale(const DriveAnswer& answer) {
  return {{0, std::max(1.0, static_cast<double>(answer.result.ticks))}, false, kTimes};
}

/// What lies below the walls that are on the map, over `free` ground.
Colour ground(const Walls& walls, const DriveRecorder& recorder, const ColourScale& times,
              Colour free, Span columns, Span rows) {
  const Window part{columns, rows};
  const auto strength = [&](const Grid& grid) {
    return wall_strength(blocked_share(grid, part, 1, 1).at(0, 0));
  };
  const auto seen = recorder.latest(recorder.seen(), columns, rows);
  const auto learned = recorder.latest(recorder.learned(), columns, rows);
  Colour colour = seen < 0 ? free : blend(free, times.at(seen), kPale);
  colour = blend(colour, kOnlyOnMap, strength(walls.only_on_map));
  return blend(colour, learned < 0 ? kNotLearned : times.at(learned), strength(walls.learnable));
}

void draw_obstacles(Canvas& canvas, const Axes& axes, const DriveAnswer& answer,
                    const std::vector<Rectangle>& last) {
  for (const MovingObstacle& obstacle : answer.changes.obstacles) {
    if (obstacle.tick > answer.result.ticks) continue;
    for (std::size_t i = 1; i < obstacle.track.size(); ++i) {
      const auto middle = [&](const Cell& c) {
        return axes.at(c.x + 0.5 * obstacle.width, c.y + 0.5 * obstacle.height);
      };
      canvas.dashed(middle(obstacle.track[i - 1]), middle(obstacle.track[i]), kMoving, 1.5);
    }
  }
  for (const Rectangle& r : last) {
    const Point low = axes.at(r.x, r.y), high = axes.at(r.x + r.width, r.y + r.height);
    canvas.fill({low.x, low.y, high.x - low.x, high.y - low.y}, kMoving);
  }
}

void draw_track(Canvas& canvas, const Axes& axes, const Sheet& sheet, const DriveAnswer& answer) {
  const DriveResult& result = answer.result;
  std::vector<Point> track;
  if (const auto& driven = answer.vehicle) {
    for (const vehicle::Pose& pose : driven->poses) track.push_back({pose.x, pose.y});
    canvas.clip(axes.box);
    draw_sweep(canvas, axes, driven->vehicle.vehicle, driven->poses, driven->start.pose,
               driven->goal().pose);
    canvas.unclip();
  } else {
    for (const Cell c : result.track) track.push_back(centre(c));
  }
  draw_path(canvas, axes.box, sheet, track, 2.5, 1);
  const double cell = axes.box.width / sheet.window.width();
  for (const Replan& replan : result.replans) {
    if (!(replan.length >= 0)) continue;  // no way was found
    const Point at = track[static_cast<std::size_t>(replan.tick)];
    const Point dot = axes.at(at.x, at.y);  // without a rim: the next may be beside it
    canvas.line(dot, dot, kInk, std::clamp(0.7 * cell, 5.0, 9.0));
  }
}

std::string caption(const Sheet& sheet, const DriveAnswer& answer) {
  const DriveResult& result = answer.result;
  std::string text = std::string(to_string(result.status)) + " after " +
                     counted(result.ticks, "tick") + ", " + counted(result.waits, "wait") +
                     " among them, length " + sheet.length(result.length);
  if (answer.layers) text += ", cost " + decimal_text(result.cost, 2);
  if (answer.ratio())
    text +=
        against(answer.layers ? result.cost : result.length, *answer.optimum,
                "optimum of the robot's moves through the world at the start",
                answer.layers ? decimal_text(*answer.optimum, 2) : sheet.length(*answer.optimum));
  return text + "; " + counted(result.replans.size(), "plan") + ", " +
         counted(result.seen, "cell") + " learned, sight " + sheet.length(answer.sense);
}

std::vector<Key> keys(const DriveAnswer& answer, const Walls& walls) {
  std::vector<Key> keys{start_key(),
                        goal_key(),
                        line_key("track", kPath, 2.5),
                        {"a way was planned", [](Canvas& canvas, Point left) {
                           canvas.line({left.x + 13, left.y}, {left.x + 13, left.y}, kInk, 7);
                         }}};
  const auto any = [](const Grid& grid) {
    return grid.count_free() < std::int64_t{1} * grid.width() * grid.height();
  };
  if (answer.vehicle) keys.push_back(sweep_key());
  keys.push_back(area_key("blocked, as on the map", kWall));
  if (any(walls.only_on_map)) keys.push_back(area_key("blocked on the map only", kOnlyOnMap));
  if (any(walls.learnable)) {
    keys.push_back(area_key("blocked, never learned", kNotLearned));
    keys.push_back(scale_key("blocked, by the tick when that was learned", time_scale(answer)));
  }
  if (!answer.changes.obstacles.empty())
    keys.push_back(dashed_key("moving obstacle: track, and last place", kMoving));
  return keys;
}

}  // namespace

std::string drive_title(const DriveAnswer& answer, const RunOptions& run) {
  const LoadedMap& map = answer.map;
  if (!answer.vehicle) return "drive, " + map_title(map, run);
  return "drive of a vehicle on " + file_name(map.file) + ", " + std::to_string(map.width) + " x " +
         std::to_string(map.height) + " cells";
}

void write_drive_picture(const std::string& file, const RunOptions& run, const DriveAnswer& answer,
                         const DriveRecorder& recorder) {
  const LoadedMap& truth = answer.truth();
  const Walls walls(answer.map.grid(), world_at(answer, answer.result.ticks));
  const Sheet sheet{answer.map, walls.both, run,
                    shown_of(truth, {answer.start.cell, answer.goal.cell}), nullptr};
  const ColourScale times = time_scale(answer);
  const LoadedCosts* const costs = answer.map.costs ? &*answer.map.costs : nullptr;
  const ColourScale weights =
      costs != nullptr ? cost_scale(costs->field, answer.map.as_read()) : ColourScale{};
  const auto draw = [&](Canvas& canvas, const Box& box) {
    paint_map(canvas, box, sheet, [&](Span columns, Span rows) {
      const Colour free =
          costs != nullptr ? cost_ground(costs->field, answer.map.as_read(), weights, columns, rows)
                           : kFree;
      return ground(walls, recorder, times, free, columns, rows);
    });
    const Axes axes = sheet.axes(box);
    draw_obstacles(canvas, axes, answer, recorder.obstacles());
    if (answer.result.status != Status::invalid) draw_track(canvas, axes, sheet, answer);
    draw_marks(canvas, box, sheet, answer.start.at(), answer.goal.at(), false);
  };
  std::string title = drive_title(answer, run);
  if (answer.world) title += ", through " + file_name(truth.file);
  Page page = sheet.page(std::move(title));
  page.legend = keys(answer, walls);
  std::vector<Colour> pale;
  for (const Colour c : kTimes) pale.push_back(blend(kFree, c, kPale));
  ColourScale seen = times;
  seen.colours = pale;
  page.legend.push_back(scale_key("free, by the tick when it was in sight first", seen));
  if (costs != nullptr)
    page.legend.push_back(scale_key("weight of cells at the start, with inflation", weights));
  page.bands = {{{{{caption(sheet, answer), draw}}}}};
  write_page(file, page);
}

}  // namespace lasius::tool
