#include "tools/tour/tour_picture.h"

#include <algorithm>

#include "tools/bitmap/sheet.h"
#include "tools/console/values.h"
#include "tools/draw/colours.h"
#include "tools/draw/page.h"
#include "tools/draw/text.h"

namespace lasius::tool {
namespace {

constexpr Colour kStop{0.1, 0.32, 0.62};
constexpr Colour kLeftOut{0.45, 0.47, 0.5};
constexpr std::size_t kMostNumbered = 150;

std::string caption(const Sheet& sheet, const TourAnswer& answer) {
  const TourResult& tour = answer.tour;
  if (tour.order.empty()) return no_path_text(tour.status);
  std::string text = "tour of " + counted(static_cast<std::int64_t>(tour.order.size()), "stop") +
                     ", length " + sheet.length(tour.length);
  if (tour.optimal)
    text += ", proven shortest";
  else if (tour.lower_bound)
    text += against(tour.length, *tour.lower_bound, "lower bound", sheet.length(*tour.lower_bound));
  if (!tour.left_out.empty())
    text += "; " + counted(static_cast<std::int64_t>(tour.left_out.size()), "stop") + " left out";
  return text;
}

void draw_stops(Canvas& canvas, const Box& box, const Sheet& sheet, const TourAnswer& answer) {
  const Axes axes = sheet.axes(box);
  const auto at = [&](int stop) {
    const Point p = answer.stops[static_cast<std::size_t>(stop)].at();
    return axes.at(p.x, p.y);
  };
  for (const LeftOut& out : answer.tour.left_out)
    if (sheet.grid.contains(answer.stops[static_cast<std::size_t>(out.stop)].cell))
      canvas.disc(at(out.stop), 4, kLeftOut);
  const auto& order = answer.tour.order;
  for (const int stop : order) canvas.disc(at(stop), 4, kStop);
  if (order.size() > kMostNumbered) return;
  for (std::size_t i = 0; i < order.size(); ++i) {
    const Point p = at(order[i]);
    canvas.text({p.x + 6, p.y - 5}, std::to_string(i + 1), 11, Align::left, kInk, true);
  }
}

}  // namespace

void write_tour_picture(const std::string& file, const RunOptions& run, const TourAnswer& answer) {
  std::vector<Cell> cells;
  for (const Place& stop : answer.stops) cells.push_back(stop.cell);
  const Sheet sheet{answer.map, answer.map.grid(), run, shown_of(answer.map, cells)};
  const auto marked = [&](const std::optional<int>& end) {
    return end ? cells[static_cast<std::size_t>(*end)] : Cell{-1, -1};
  };
  const auto draw = [&](Canvas& canvas, const Box& box) {
    paint_map(canvas, box, sheet, free_ground);
    for (const TourLeg& leg : answer.tour.legs) draw_path(canvas, box, sheet, leg.path, 2.5, 1);
    draw_marks(canvas, box, sheet, marked(answer.start), marked(answer.goal), false);
    draw_stops(canvas, box, sheet, answer);
  };
  Page page = sheet.page("tour, " + map_title(answer.map, run));
  if (!answer.goal) page.legend.erase(page.legend.begin() + 1);
  if (!answer.start) page.legend.erase(page.legend.begin());
  if (!answer.tour.order.empty()) {
    const bool numbered = answer.tour.order.size() <= kMostNumbered;
    page.legend.push_back(line_key("tour", kPath, 2.5));
    page.legend.push_back(disc_key(numbered ? "stop, by its place in the tour" : "stop", kStop));
  }
  if (!answer.tour.left_out.empty()) page.legend.push_back(disc_key("stop left out", kLeftOut));
  page.bands = {{{{{caption(sheet, answer), draw}}}}};
  write_page(file, page);
}

}  // namespace lasius::tool
