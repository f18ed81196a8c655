#include "tools/draw/page.h"

#include <algorithm>
#include <cmath>

#include "tools/draw/colours.h"

namespace lasius::tool {
namespace {

constexpr double kMargin = 24, kGap = 22;
constexpr double kTitleSize = 20, kNoteSize = 15, kCaptionSize = 16, kSmallCaptionSize = 14;

constexpr double kLeastHeight = 60;  ///< of a map's place, for the names of its axes

/// Sizes of a band's panels.
struct Kind {
  double least_width;  ///< of a place
  double enlarged;     ///< no side of a map is drawn larger, unless it has more cells
  double captions;     ///< height, as expected
};
constexpr Kind kSmall{250, 470, 46}, kLarge{440, 900, 56};

const Kind& kind_of(const Band& band) { return band.small ? kSmall : kLarge; }

/// How a band is arranged.
struct Arrangement {
  int columns = 1;
  double scale = 1;  ///< pixels a cell
};

int panels_in(const Band& band) { return static_cast<int>(band.rows.front().size()); }

double below(const Band& band) {
  double most = 0;
  for (const auto& row : band.rows)
    for (const Panel& panel : row) most = std::max(most, panel.below);
  return most;
}

/// Of a panel's place, without its caption.
Box place_of(const Page& page, const Band& band, double scale) {
  const Kind& kind = kind_of(band);
  return {0, 0, std::max(kind.least_width, std::floor(page.wide * scale) + kPlaneLeft + 8),
          std::max(kLeastHeight, std::floor(page.high * scale)) + kPlaneBottom + below(band)};
}

/// Of a line of panels without their captions: a chart beside maps may need more than these, and
/// charts alone less.
double line_height(const Band& band, int first, int columns, const Box& place) {
  constexpr double kChart = 250, kCharts = 360;
  const auto from = band.rows.front().begin() + first;
  const int panels = std::min(columns, panels_in(band) - first);
  const auto charts =
      std::count_if(from, from + panels, [](const Panel& panel) { return panel.chart; });
  if (charts == panels) return kCharts;
  return charts > 0 ? std::max(kChart, place.height) : place.height;
}

/// Largest scale at which so many columns fit.
double widest_scale(const Page& page, const Band& band, int columns) {
  const double place = (kMostSide - 2 * kMargin - (columns - 1) * kGap) / columns;
  const Kind& kind = kind_of(band);
  if (place < kind.least_width) return 0;
  const double most = kind.enlarged / std::max(page.wide, page.high);
  return std::min((place - kPlaneLeft - 8) / page.wide,
                  page.cells && !band.small ? std::max(1.0, most) : most);
}

double snapped(const Page& page, double scale) {
  return page.cells && (scale >= 2 || (scale > 1 && scale < 1.3)) ? std::floor(scale) : scale;
}

/// The arrangement whose product of scales is largest.
std::vector<Arrangement> arranged(const Page& page, double header) {
  const double room = kMostSide - 2 * kMargin - header;
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
    double factor = 1;
    if (height(1) > room) {
      double low = 0, high = 1;
      while (high - low > 1e-3) {
        const double middle = (low + high) / 2;
        (height(middle) > room ? high : low) = middle;
      }
      factor = std::max(low, 1e-3);
    }
    double product = 1;
    for (Arrangement& band : tried) {
      band.scale = snapped(page, factor * band.scale);
      product *= band.scale;
    }
    product *= tried.back().scale;  // the last band is what matters most
    if (product > best_product) {
      best_product = product;
      best = tried;
    }
  };
  const auto try_columns = [&](auto& self, std::size_t b) -> void {
    if (b == page.bands.size()) {
      const auto before = tried;
      judge();
      tried = before;
      return;
    }
    for (int columns = 1; columns <= panels_in(page.bands[b]); ++columns) {
      tried[b] = {columns, widest_scale(page, page.bands[b], columns)};
      if (tried[b].scale > 0) self(self, b + 1);
    }
  };
  try_columns(try_columns, 0);
  return best;
}

/// a .. z, aa, bb ..
std::string letters(std::size_t panel) {
  return std::string(1 + panel / 26, static_cast<char>('a' + panel % 26));
}

/// A panel where it stands on the page.
struct Placed {
  const Panel* panel;
  const Band* band;
  Box box;  ///< of the map, or the chart
  Point caption;
  double caption_width;
  std::string text;
};

/// All panels; `bottom` becomes the lower edge of the last caption.
std::vector<Placed> placed(Canvas& measure, const Page& page,
                           const std::vector<Arrangement>& arrangement, double width, double top,
                           double& bottom) {
  std::vector<Placed> list;
  int panels = 0;
  for (const Band& band : page.bands)
    panels += panels_in(band) * static_cast<int>(band.rows.size());
  double y = top;
  for (std::size_t b = 0; b < page.bands.size(); ++b) {
    const Band& band = page.bands[b];
    const auto [columns, scale] = arrangement[b];
    const Box place = place_of(page, band, scale);
    const double size = band.small ? kSmallCaptionSize : kCaptionSize;
    const double map_width = std::max(1.0, std::floor(page.wide * scale));
    const double map_height = std::max(1.0, std::floor(page.high * scale));
    const double left = (width - columns * (place.width + kGap) + kGap) / 2;
    for (int first = 0; first < panels_in(band); first += columns) {
      const double high = line_height(band, first, columns, place);
      for (const auto& row : band.rows) {
        double captions = 0;
        for (int i = first; i < std::min(first + columns, panels_in(band)); ++i) {
          const Panel& panel = row[static_cast<std::size_t>(i)];
          const double x = left + (i - first) * (place.width + kGap);
          // A chart at the end takes all places that are left.
          const int places = panel.chart && i + 1 == panels_in(band) ? first + columns - i : 1;
          const double wide = places * (place.width + kGap) - kGap;
          Box box{x, y, wide, high};
          if (!panel.chart)
            box = {x + kPlaneLeft + std::floor((place.width - kPlaneLeft - 8 - map_width) / 2),
                   y + std::floor((high - kPlaneBottom - below(band) - map_height) / 2), map_width,
                   map_height};
          std::string text = panel.caption;
          if (panels > 1) text = "(" + letters(list.size()) + ") " + text;
          captions = std::max(captions, draw_wrapped(measure, {}, text, size, wide, Align::centre));
          list.push_back({&panel, &band, box, {x + wide / 2, y + high + 4}, wide, std::move(text)});
        }
        bottom = y + high + 4 + captions;
        y = bottom + kGap;
      }
    }
  }
  return list;
}

}  // namespace

void write_page(const std::string& file, const Page& page) {
  constexpr double kLegendGap = 10;
  const auto header = [&](Canvas& canvas, double width) {
    const double inner = width - 2 * kMargin;
    double y = kMargin;
    y += draw_wrapped(canvas, {width / 2, y}, page.title, kTitleSize, inner, Align::centre, true);
    y += draw_wrapped(canvas, {width / 2, y}, page.note, kNoteSize, inner, Align::centre);
    const Legend legend(canvas, page.legend, inner);
    legend.draw(canvas, {kMargin, y + kLegendGap});
    return y + legend.height() + (page.legend.empty() ? 1 : 2) * kLegendGap;
  };
  Canvas measure(1, 1);
  const auto arrangement = arranged(page, header(measure, kMostSide));
  double width = 0;
  for (std::size_t b = 0; b < page.bands.size(); ++b)
    width =
        std::max(width, arrangement[b].columns *
                                (place_of(page, page.bands[b], arrangement[b].scale).width + kGap) -
                            kGap);
  width = std::floor(width + 2 * kMargin);
  double bottom = 0;
  const auto panels = placed(measure, page, arrangement, width, header(measure, width), bottom);
  Canvas canvas(static_cast<int>(width), static_cast<int>(bottom + kMargin));
  header(canvas, width);
  for (const Placed& place : panels) {
    place.panel->draw(canvas, place.box);
    draw_wrapped(canvas, place.caption, place.text,
                 place.band->small ? kSmallCaptionSize : kCaptionSize, place.caption_width,
                 Align::centre);
  }
  canvas.save(file);
}

}  // namespace lasius::tool
