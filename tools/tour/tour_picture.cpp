#include "tools/tour/tour_picture.h"

#include <algorithm>

#include "tools/bitmap/sheet.h"
#include "tools/console/values.h"
#include "tools/draw/colours.h"
#include "tools/draw/line_chart.h"
#include "tools/draw/page.h"
#include "tools/draw/text.h"

namespace lasius::tool {
namespace {

constexpr Colour kStop{0.1, 0.32, 0.62};
constexpr Colour kLeftOut{0.45, 0.47, 0.5};
constexpr std::size_t kMostNumbered = 150;
constexpr std::size_t kMostKeys = 8;  // of robots

std::string caption(const TourGround& ground, const TourAnswer& answer) {
  const TourResult& tour = answer.tour;
  if (tour.order.empty()) return no_path_text(tour.status);
  std::string text =
      (tour.tours.empty() ? "tour of "
                          : counted(static_cast<std::int64_t>(tour.tours.size()), "robot") + ", ") +
      counted(static_cast<std::int64_t>(tour.order.size()), "stop") + ", length " +
      ground.length(tour.length);
  if (tour.optimal)
    text += ", proven shortest";
  else if (tour.lower_bound)
    text +=
        against(tour.length, *tour.lower_bound, "lower bound", ground.length(*tour.lower_bound));
  if (!tour.left_out.empty())
    text += "; " + counted(static_cast<std::int64_t>(tour.left_out.size()), "stop") + " left out";
  return text;
}

// As messages, the JSON and pages call it.
std::string name_of(const TourAnswer& answer, int stop) {
  const auto i = static_cast<std::size_t>(stop);
  const bool named = i < answer.names.size() && !answer.names[i].empty();
  return named ? answer.names[i] : std::to_string(stop);
}

void draw_stops(Canvas& canvas, const Axes& axes, const TourGround& ground,
                const TourAnswer& answer) {
  const auto at = [&](int stop) {
    const Point p = answer.stops[static_cast<std::size_t>(stop)].at();
    return axes.at(p.x, p.y);
  };
  for (const LeftOut& out : answer.tour.left_out)
    if (ground.shows(answer.stops[static_cast<std::size_t>(out.stop)]))
      canvas.disc(at(out.stop), 4, kLeftOut);
  for (const int stop : answer.tour.order) canvas.disc(at(stop), 4, kStop);
  if (answer.tour.order.size() > kMostNumbered) return;
  for (const int stop : answer.tour.order) {
    const Point p = at(stop);
    canvas.text({p.x + 6, p.y - 5}, name_of(answer, stop), 11, Align::left, kInk, true);
  }
}

// That of the first robot is the colour of all paths.
Colour colour_of(std::size_t robot) { return robot == 0 ? kPath : palette(robot); }

void draw_legs(Canvas& canvas, const Box& box, const TourGround& ground, const TourResult& tour) {
  const auto draw = [&](int first, int count, Colour colour) {
    for (int i = first; i < first + count; ++i)
      ground.path(canvas, box, tour.legs[static_cast<std::size_t>(i)].path, colour);
  };
  if (tour.tours.empty()) return draw(0, static_cast<int>(tour.legs.size()), kPath);
  for (std::size_t r = 0; r < tour.tours.size(); ++r)
    draw(tour.tours[r].first_leg, tour.tours[r].legs, colour_of(r));
}

}  // namespace

void write_tour_picture(const std::string& file, Page page, const TourGround& ground,
                        const TourAnswer& answer) {
  const auto draw = [&](Canvas& canvas, const Box& box) {
    const Axes axes = ground.paint(canvas, box);
    draw_legs(canvas, box, ground, answer.tour);
    ground.marks(canvas, box, answer.start, answer.goal);
    for (const int robot : answer.robots) ground.marks(canvas, box, robot, {});
    draw_stops(canvas, axes, ground, answer);
  };
  if (!answer.goal) page.legend.erase(page.legend.begin() + 1);
  if (!answer.start && answer.robots.empty()) page.legend.erase(page.legend.begin());
  if (!answer.tour.order.empty()) {
    const bool numbered = answer.tour.order.size() <= kMostNumbered;
    const std::size_t robots = answer.tour.tours.size();
    if (robots == 0) page.legend.push_back(line_key("tour", kPath, 2.5));
    for (std::size_t r = 0; r < std::min(robots, kMostKeys); ++r)
      page.legend.push_back(line_key("robot " + std::to_string(r), colour_of(r), 2.5));
    const std::string by = answer.names.empty() ? "number" : "name";
    page.legend.push_back(disc_key(numbered ? "stop, by its " + by : "stop", kStop));
  }
  if (!answer.tour.left_out.empty()) page.legend.push_back(disc_key("stop left out", kLeftOut));
  page.bands = {{{{{caption(ground, answer), draw}}}}};
  write_page(file, page);
}

void write_tour_picture(const std::string& file, std::string_view algorithm, const RunOptions& run,
                        const TourAnswer& answer,
                        const std::function<void(Canvas&, const Axes&)>& below,
                        const std::vector<Key>& more) {
  std::vector<Cell> cells;
  for (const Place& stop : answer.stops) cells.push_back(stop.cell);
  const Sheet sheet{answer.map, answer.map.grid(), run, shown_of(answer.map, cells)};
  const auto marked = [&](const std::optional<int>& end) {
    return end ? answer.stops[static_cast<std::size_t>(*end)].at() : Point{-1, -1};
  };
  const TourGround ground{
      .paint =
          [&](Canvas& canvas, const Box& box) {
            paint_map(canvas, box, sheet, free_ground);
            const Axes axes = sheet.axes(box);
            canvas.clip(box);
            if (below) below(canvas, axes);
            canvas.unclip();
            return axes;
          },
      .path = [&](Canvas& canvas, const Box& box, const std::vector<Point>& path,
                  Colour colour) { draw_path(canvas, box, sheet, path, 2.5, 1, colour); },
      .marks =
          [&](Canvas& canvas, const Box& box, std::optional<int> start, std::optional<int> goal) {
            draw_marks(canvas, box, sheet, marked(start), marked(goal), false);
          },
      .length = [&](double length) { return sheet.length(length); },
      .shows = [&](const Place& place) { return sheet.grid.contains(place.cell); }};
  Page page = sheet.page("tour, " + map_title(answer.map, run, algorithm));
  page.legend.insert(page.legend.end(), more.begin(), more.end());
  write_tour_picture(file, std::move(page), ground, answer);
}

}  // namespace lasius::tool
