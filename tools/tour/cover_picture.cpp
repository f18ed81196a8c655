#include "tools/tour/cover_picture.h"

#include "tools/bitmap/sheet.h"
#include "tools/console/values.h"
#include "tools/draw/colours.h"
#include "tools/draw/page.h"
#include "tools/draw/text.h"

namespace lasius::tool {
namespace {

constexpr Colour kSwath{0.1, 0.32, 0.62};
constexpr Colour kWorkedOn{0.8, 0.88, 0.97};
constexpr double kSwathLine = 2, kWayLine = 1.5;

std::string caption(const Sheet& sheet, const CoverResult& cover) {
  if (cover.tour.order.empty()) return no_path_text(cover.tour.status);
  return counted(cover.swaths(), "swath") + ", length " + sheet.length(cover.tour.length) +
         printed(", %.2f%% covered", 100 * cover.covered);
}

}  // namespace

void write_cover_picture(const std::string& file, const RunOptions& run, const TourAnswer& answer,
                         const CoverResult& cover, double width) {
  std::vector<Cell> ends;
  if (answer.start) ends.push_back(answer.stops[static_cast<std::size_t>(*answer.start)].cell);
  const Sheet sheet{answer.map, answer.map.grid(), run, shown_of(answer.map, ends)};
  const Point start =
      answer.start ? answer.stops[static_cast<std::size_t>(*answer.start)].at() : Point{-1, -1};
  const auto is_swath = [&](const TourLeg& leg) {
    return leg.from / 2 == leg.to / 2 && leg.from / 2 < cover.swaths() && leg.path.size() == 2;
  };
  const auto draw = [&](Canvas& canvas, const Box& box) {
    paint_map(canvas, box, sheet, free_ground);
    const Axes axes = sheet.axes(box);
    const double wide = axes.at(width, 0).x - axes.at(0, 0).x;
    canvas.clip(box);
    for (const TourLeg& leg : cover.tour.legs) canvas.stroke(axes.at(leg.path), kSwath, wide, 0.12);
    canvas.unclip();
    for (const bool swaths : {true, false})
      for (const TourLeg& leg : cover.tour.legs)
        if (is_swath(leg) == swaths)
          canvas.polyline(axes.at(leg.path), swaths ? kSwath : kPath,
                          swaths ? kSwathLine : kWayLine);
    draw_marks(canvas, box, sheet, start, {-1, -1}, false);
  };
  Page page = sheet.page("coverage, " + map_title(answer.map, run));
  page.legend.erase(page.legend.begin() + 1);
  if (!answer.start) page.legend.erase(page.legend.begin());
  if (!cover.tour.order.empty()) {
    page.legend.push_back(line_key("swath", kSwath, kSwathLine));
    page.legend.push_back(line_key("what it works on", kWorkedOn, 9));
    page.legend.push_back(line_key("way between", kPath, kWayLine));
  }
  page.bands = {{{{{caption(sheet, cover), draw}}}}};
  write_page(file, page);
}

}  // namespace lasius::tool
