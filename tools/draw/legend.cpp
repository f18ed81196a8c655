#include "tools/draw/legend.h"

#include <algorithm>
#include <cmath>

#include "tools/draw/colours.h"
#include "tools/draw/text.h"

namespace lasius::tool {
namespace {

constexpr double kLine = 19;  ///< from line to line
constexpr double kAfterSymbol = 8, kBetween = 22;

void fill_bar(Canvas& canvas, const Box& box, const ColourScale& scale) {
  constexpr int kSteps = 60;
  const double step = box.width / kSteps;
  for (int i = 0; i < kSteps; ++i)
    canvas.fill({box.x + i * step, box.y, std::min(step + 0.5, box.width - i * step), box.height},
                scale.colour((i + 0.5) / kSteps));
  canvas.frame(box, kInk, 1);
}

}  // namespace

std::vector<std::string> wrapped(Canvas& canvas, const std::string& text, double size, double width,
                                 bool bold) {
  const auto fits = [&](const std::string& s) { return canvas.text_width(s, size, bold) <= width; };
  std::vector<std::string> lines;
  std::string line;
  const auto end_line = [&] {
    if (!line.empty()) lines.push_back(std::move(line));
    line.clear();
  };
  for (std::size_t from = 0; from < text.size();) {
    const std::size_t to = std::min(text.find(' ', from), text.size());
    std::string word = text.substr(from, to - from);
    from = to + 1;
    if (const std::string both = line.empty() ? word : line + " " + word; fits(both)) {
      line = both;
      continue;
    }
    end_line();
    while (!fits(word)) {
      std::size_t kept = word.size();
      do --kept;
      while (kept > 1 && ((word[kept] & 0xc0) == 0x80 || !fits(word.substr(0, kept))));
      if (kept <= 1) break;
      lines.push_back(word.substr(0, kept));
      word.erase(0, kept);
    }
    line = word;
  }
  end_line();
  return lines;
}

double draw_wrapped(Canvas& canvas, Point top, const std::string& text, double size, double width,
                    Align align, bool bold) {
  const double step = std::ceil(1.3 * size);
  const auto lines = wrapped(canvas, text, size, width, bold);
  for (const std::string& line : lines)
    canvas.text({top.x, (top.y += step) - 0.3 * size}, line, size, align, kInk, bold);
  return step * static_cast<double>(lines.size());
}

Key line_key(const std::string& label, Colour colour, double width) {
  return {label, [=](Canvas& canvas, Point p) { canvas.line(p, {p.x + 26, p.y}, colour, width); }};
}

Key dashed_key(const std::string& label, Colour colour) {
  return {label, [=](Canvas& canvas, Point p) { canvas.dashed(p, {p.x + 26, p.y}, colour, 1.5); }};
}

Key area_key(const std::string& label, Colour colour) {
  return {label,
          [=](Canvas& canvas, Point p) {
            const Box box{p.x, p.y - 7, 20, 14};
            canvas.fill(box, colour);
            canvas.frame(box, kInk, 1);
          },
          20};
}

Key start_key() {
  return {"start", [](Canvas& canvas, Point p) { canvas.ring({p.x + 9, p.y}, 7, kStart); }, 18};
}

Key goal_key() {
  return {"goal", [](Canvas& canvas, Point p) { canvas.diamond({p.x + 9, p.y}, 9, kGoal); }, 18};
}

Legend::Legend(Canvas& canvas, std::vector<Key> keys, double width) {
  double x = 0, y = 0, row = 0;
  for (Key& key : keys) {
    const double symbol = key.width + kAfterSymbol;
    auto lines = wrapped(canvas, key.label, kLabelSize, std::max(40.0, width - symbol));
    double widest = 0;
    for (const auto& line : lines) widest = std::max(widest, canvas.text_width(line, kLabelSize));
    if (x > 0 && x + symbol + widest > width) {
      x = 0;
      y += row;
      row = 0;
    }
    row = std::max(row, kLine * static_cast<double>(lines.size()) + 3);
    entries_.push_back({std::move(key), {x, y}, std::move(lines)});
    x += symbol + widest + kBetween;
  }
  height_ = y + row;
}

void Legend::draw(Canvas& canvas, Point top_left) const {
  for (const auto& [key, at, lines] : entries_) {
    Point p{top_left.x + at.x, top_left.y + at.y + kLine / 2};
    key.symbol(canvas, p);
    for (const std::string& line : lines) {
      canvas.text({p.x + key.width + kAfterSymbol, p.y + 5}, line, kLabelSize, Align::left, kInk);
      p.y += kLine;
    }
  }
}

double ColourScale::share(double value) const {
  if (!(range.high > range.low)) return 0;
  const double share = logarithmic ? std::log(value / range.low) / std::log(range.high / range.low)
                                   : (value - range.low) / (range.high - range.low);
  return std::clamp(share, 0.0, 1.0);
}

Key scale_key(Canvas& canvas, const std::string& label, const ColourScale& scale) {
  constexpr double kBar = 110;
  const std::string low = study::fixed(scale.range.low, 0),
                    high = study::fixed(scale.range.high, 0);
  const double before = canvas.text_width(low, kLabelSize) + 6;
  const double width = before + kBar + 6 + canvas.text_width(high, kLabelSize);
  return {label,
          [=](Canvas& page, Point p) {
            page.text({p.x, p.y + 5}, low, kLabelSize, Align::left, kInk);
            fill_bar(page, {p.x + before, p.y - 7, kBar, 14}, scale);
            page.text({p.x + width, p.y + 5}, high, kLabelSize, Align::right, kInk);
          },
          width};
}

void draw_bar(Canvas& canvas, const Box& map, const ColourScale& scale) {
  const double width = std::max(map.width, 240.0);
  const Point top_left{map.x + (map.width - width) / 2, map.y + map.height + kPlaneBottom + 6};
  fill_bar(canvas, {top_left.x, top_left.y, width, 12}, scale);
  double free = -1e9;  // to the right of the last mark's text
  for (const double mark :
       axis_marks(scale.range, scale.logarithmic, static_cast<int>(width / 60))) {
    const double x = top_left.x + scale.share(mark) * width;
    canvas.line({x, top_left.y + 12}, {x, top_left.y + 16}, kInk, 1);
    const std::string text = short_number(mark);
    const double half = canvas.text_width(text, 12) / 2;
    if (x - half < free) continue;
    canvas.text({x, top_left.y + 29}, text, 12, Align::centre, kInk);
    free = x + half + 6;
  }
}

}  // namespace lasius::tool
