#include "tools/draw/page.h"

#include <algorithm>
#include <cmath>

namespace lasius::tool {
namespace {

constexpr double kMargin = 24, kGap = 22, kRight = 8;  ///< kRight: of a map, for its last mark
constexpr double kLeastHeight = 60;                    ///< of a map's place
constexpr double kHeader = 90;                         // as expected

/// Sizes of a band's panels.
struct Kind {
  double least_width;  ///< of a place
  double enlarged;     ///< no side of a map is drawn larger, unless it has more cells
  double captions;     ///< height, as expected
  double text;
};
const Kind& kind_of(const Band& band) {
  static constexpr Kind kSmall{250, 440, 46, 14}, kLarge{440, 900, 62, 16};
  return band.small ? kSmall : kLarge;
}

/// How a band is arranged.
struct Arrangement {
  int columns = 1;
  double scale = 1;  ///< pixels a cell
};

int panels_in(const Band& band) { return static_cast<int>(band.rows.front().size()); }

/// Of a panel's place, without its caption; kept wide and high enough for the names of axes.
Box place_of(const Page& page, const Band& band, double scale) {
  double below = 0;
  for (const Panel& panel : band.rows.front()) below = std::max(below, panel.below);
  return {0, 0,
          std::max(kind_of(band).least_width, std::floor(page.wide * scale) + kAxisLeft + kRight),
          std::max(kLeastHeight, std::floor(page.high * scale)) + kAxisBottom + below};
}

/// Of a line of panels without their captions: a chart beside maps may need more than these, and
/// charts alone less.
double line_height(const Band& band, int first, int columns, const Box& place) {
  constexpr double kChart = 250, kCharts = 420;
  const auto from = band.rows.front().begin() + first;
  const int panels = std::min(columns, panels_in(band) - first);
  const auto charts =
      std::count_if(from, from + panels, [](const Panel& panel) { return panel.chart; });
  if (charts == panels) return kCharts;
  return charts > 0 ? std::max(kChart, place.height) : place.height;
}

/// Largest scale at which so many columns fit; 0: none.
double widest_scale(const Page& page, const Band& band, int columns) {
  const Kind& kind = kind_of(band);
  const double place = (kMostSide - 2 * kMargin - (columns - 1) * kGap) / columns;
  if (place < kind.least_width) return 0;
  const double most = kind.enlarged / std::max(page.wide, page.high);
  return std::min((place - kAxisLeft - kRight) / page.wide,
                  page.cells && !band.small ? std::max(1.0, most) : most);
}

/// The arrangement whose product of scales is largest; that of the last band counts twice.
std::vector<Arrangement> arranged(const Page& page) {
  constexpr double kRoom = kMostSide - 2 * kMargin - kHeader;
  std::vector<Arrangement> best, tried(page.bands.size());
  double best_product = 0;
  const auto height = [&](double factor) {
    double sum = 0;
    for (std::size_t b = 0; b < tried.size(); ++b) {
      const Band& band = page.bands[b];
      const Box place = place_of(page, band, factor * tried[b].scale);
      for (int first = 0; first < panels_in(band); first += tried[b].columns)
        sum += static_cast<double>(band.rows.size()) *
               (line_height(band, first, tried[b].columns, place) + kind_of(band).captions + kGap);
    }
    return sum;
  };
  const auto judge = [&] {
    double low = 1e-3, high = 1;
    while (height(high) > kRoom && high - low > 1e-3) {
      const double middle = (low + high) / 2;
      (height(middle) > kRoom ? high : low) = middle;
    }
    double product = 1;
    for (Arrangement& band : tried) {
      band.scale *= height(high) > kRoom ? low : high;
      // Cells of equal pixels, where that makes none much smaller.
      if (page.cells && (band.scale >= 2 || (band.scale > 1 && band.scale < 1.3)))
        band.scale = std::floor(band.scale);
      product *= band.scale;
    }
    product *= tried.back().scale;
    if (product > best_product) {
      best_product = product;
      best = tried;
    }
  };
  const Band &front = page.bands.front(), &back = page.bands.back();
  for (int few = 1; few <= std::max(front.columns, panels_in(front)); ++few)
    for (int many = 1; many <= std::max(back.columns, panels_in(back)); ++many) {
      if (page.bands.size() == 1 && many != few) continue;
      if (front.columns > 0 && few != front.columns) continue;
      if (back.columns > 0 && many != back.columns) continue;
      tried.front() = {few, widest_scale(page, front, few)};
      tried.back() = {many, widest_scale(page, back, many)};
      if (tried.front().scale > 0 && tried.back().scale > 0) judge();
    }
  return best;
}

/// (a) .. (z), (aa), (bb) ..
std::string letters(int panel) {
  return "(" + std::string(1 + panel / 26, static_cast<char>('a' + panel % 26)) + ") ";
}

}  // namespace

void write_page(const std::string& file, const Page& page) {
  const auto arrangement = arranged(page);
  double inner = 0;
  std::size_t panels = 0;
  for (std::size_t b = 0; b < page.bands.size(); ++b) {
    const auto [columns, scale] = arrangement[b];
    inner = std::max(inner, columns * (place_of(page, page.bands[b], scale).width + kGap) - kGap);
    panels += page.bands[b].rows.size() * page.bands[b].rows.front().size();
  }
  Canvas canvas;
  double y = kMargin;
  const Point middle{kMargin + inner / 2, 0};
  y += draw_wrapped(canvas, {middle.x, y}, page.title, 20, inner, Align::centre, true);
  y += draw_wrapped(canvas, {middle.x, y}, page.note, 15, inner, Align::centre) + kGap / 2;
  y += draw_legend(canvas, {kMargin, y}, inner, page.legend) + kGap / 2;
  int number = 0;
  for (std::size_t b = 0; b < page.bands.size(); ++b) {
    const Band& band = page.bands[b];
    const auto [columns, scale] = arrangement[b];
    const Box place = place_of(page, band, scale);
    const double wide = std::max(1.0, std::floor(page.wide * scale));
    const double high = std::max(1.0, std::floor(page.high * scale));
    const double left = middle.x - (columns * (place.width + kGap) - kGap) / 2;
    for (int first = 0; first < panels_in(band); first += columns) {
      const double line = line_height(band, first, columns, place);
      for (const auto& row : band.rows) {
        double captions = 0;
        for (int i = first; i < std::min(first + columns, panels_in(band)); ++i) {
          const Panel& panel = row[static_cast<std::size_t>(i)];
          const double x = left + (i - first) * (place.width + kGap);
          // A chart at the end takes all places that are left.
          const int places = panel.chart && i + 1 == panels_in(band) ? first + columns - i : 1;
          const double width = places * (place.width + kGap) - kGap;
          const double spare = place.width - kAxisLeft - kRight - wide;
          const double above = (line - place.height + std::max(0.0, kLeastHeight - high)) / 2;
          panel.draw(canvas, panel.chart ? Box{x, y, width, line}
                                         : Box{x + kAxisLeft + std::floor(spare / 2),
                                               y + std::floor(above), wide, high});
          const std::string letter = panels > 1 && !panel.caption.empty() ? letters(number++) : "";
          captions = std::max(
              captions, draw_wrapped(canvas, {x + width / 2, y + line + 4}, letter + panel.caption,
                                     kind_of(band).text, width, Align::centre));
        }
        y += line + 4 + captions + kGap;
      }
    }
  }
  canvas.resize(inner + 2 * kMargin, y - kGap + kMargin);
  canvas.save(file);
}

}  // namespace lasius::tool
