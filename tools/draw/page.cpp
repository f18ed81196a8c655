#include "tools/draw/page.h"

#include <algorithm>
#include <cmath>

#include "tools/draw/colours.h"

namespace lasius::tool {
namespace {

constexpr double kMargin = 24;
constexpr double kGap = 20;
constexpr double kCaption = 30;  // below a panel
constexpr double kTitle = 44;
constexpr double kLeastWidth = 420, kLeastHeight = 210;  // of a panel's place

/// The text, its middle left out where it is wider than `width`.
std::string fitted(Canvas& canvas, const std::string& text, double size, double width, bool bold) {
  std::string shown = text;
  for (std::size_t kept = text.size(); kept > 8 && canvas.text_width(shown, size, bold) > width;
       kept -= 2)
    shown = text.substr(0, kept / 2) + "..." + text.substr(text.size() - kept / 2);
  return shown;
}

}  // namespace

Layout map_layout(int panels, int cells_wide, int cells_high) {
  Layout best;
  double best_scale = 0;  // pixels a cell
  for (int columns = 1; columns <= panels; ++columns) {
    const int rows = (panels + columns - 1) / columns;
    const double wide = (kMostSide - 2 * kMargin - (columns - 1) * kGap) / columns;
    const double high = (kMostSide - 2 * kMargin - kTitle - (rows - 1) * kGap) / rows - kCaption;
    if (wide < kLeastWidth || high < kLeastHeight) continue;
    double scale = std::min(wide / cells_wide, high / cells_high);
    if (scale > 1) scale = std::floor(scale);
    if (scale <= best_scale) continue;
    best_scale = scale;
    best.columns = columns;
  }
  const auto side = [&](int cells) { return std::max(1.0, std::floor(cells * best_scale)); };
  best.map_width = side(cells_wide);
  best.map_height = side(cells_high);
  best.place_width = std::max(best.map_width, kLeastWidth);
  best.place_height = std::max(best.map_height, kLeastHeight);
  return best;
}

void write_page(const std::string& file, const std::string& title, const Layout& layout,
                const std::vector<Panel>& panels) {
  const int count = static_cast<int>(panels.size());
  const int rows = (count + layout.columns - 1) / layout.columns;
  const double step_x = layout.place_width + kGap;
  const double step_y = layout.place_height + kCaption + kGap;
  const double width = 2 * kMargin + layout.columns * step_x - kGap;
  const double height = 2 * kMargin + kTitle + rows * step_y - kGap;
  Canvas canvas(static_cast<int>(width), static_cast<int>(height));
  canvas.text({width / 2, kMargin + 22}, fitted(canvas, title, 20, width - 2 * kMargin, true), 20,
              Align::centre, kInk, true);
  for (int i = 0; i < count; ++i) {
    const Panel& panel = panels[static_cast<std::size_t>(i)];
    const int column = i % layout.columns, row = i / layout.columns;
    const Box place{kMargin + column * step_x, kMargin + kTitle + row * step_y, layout.place_width,
                    layout.place_height};
    Box box = place;
    if (!panel.chart) {
      box = {place.x + std::floor((place.width - layout.map_width) / 2),
             place.y + std::floor((place.height - layout.map_height) / 2), layout.map_width,
             layout.map_height};
    }
    panel.draw(canvas, box);
    std::string caption;
    if (count > 1) caption.append("(").append(1, static_cast<char>('a' + i)).append(") ");
    caption.append(panel.caption);
    canvas.text({place.x + place.width / 2, place.y + place.height + 23},
                fitted(canvas, caption, 17, place.width, false), 17, Align::centre, kInk);
  }
  canvas.save(file);
}

}  // namespace lasius::tool
