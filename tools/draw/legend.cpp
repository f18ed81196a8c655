#include "tools/draw/legend.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "tools/draw/colours.h"
#include "tools/draw/text.h"

namespace lasius::tool {
namespace {

std::vector<std::string> wrapped(Canvas& canvas, const std::string& whole, double size,
                                 double width, bool bold = false) {
  const std::string text = drawn(whole);
  const auto fits = [&](const std::string& s) { return canvas.text_width(s, size, bold) <= width; };
  std::vector<std::string> lines;
  for (std::size_t from = 0; from < text.size();) {
    const std::size_t to = std::min(text.find(' ', from), text.size());
    std::string word = text.substr(from, to - from);
    from = to + 1;
    if (!lines.empty() && fits(lines.back() + " " + word)) {
      lines.back() += " " + word;
      continue;
    }
    for (std::size_t kept = word.size(); kept > 1 && !fits(word); kept = word.size()) {
      // Bytes 10xxxxxx go on with a character of UTF-8.
      do --kept;
      while (kept > 1 && ((word[kept] & 0xc0) == 0x80 || !fits(word.substr(0, kept))));
      lines.push_back(word.substr(0, kept));
      word.erase(0, kept);
    }
    lines.push_back(std::move(word));
  }
  return lines;
}

void fill_bar(Canvas& canvas, const Box& box, const ColourScale& scale) {
  constexpr int kSteps = 60;
  const double step = box.width / kSteps;
  for (int i = 0; i < kSteps; ++i)
    canvas.fill({box.x + i * step, box.y, step + 0.5, box.height}, scale.shade((i + 0.5) / kSteps));
  canvas.frame(box, kInk, 1);
}

}  // namespace

double draw_wrapped(Canvas& canvas, Point top, const std::string& text, double size, double width,
                    Align align, bool bold) {
  const double step = std::ceil(1.3 * size);
  const double y = top.y;
  for (const std::string& line : wrapped(canvas, text, size, width, bold))
    canvas.text({top.x, (top.y += step) - 0.3 * size}, line, size, align, kInk, bold);
  return top.y - y;
}

double ColourScale::share(double value) const {
  return range.high > range.low ? std::clamp(share_of(range, logarithmic, value), 0.0, 1.0) : 0;
}

Colour ColourScale::shade(double share) const {
  const double place = share * static_cast<double>(colours.size() - 1);
  const auto i = std::min(static_cast<std::size_t>(place), colours.size() - 2);
  return blend(colours[i], colours[i + 1], place - static_cast<double>(i));
}

void draw_bar(Canvas& canvas, const Box& map, const ColourScale& scale) {
  const double width = std::max(map.width, 240.0);
  const Box bar{map.x + (map.width - width) / 2, map.y + map.height + kAxisBottom + 4, width, 12};
  fill_bar(canvas, bar, scale);
  double free = -1e9;  // to the right of the last mark's text
  for (const double mark :
       axis_marks(scale.range, scale.logarithmic, static_cast<int>(width / 60))) {
    const double x = bar.x + scale.share(mark) * width;
    canvas.line({x, bar.y + 12}, {x, bar.y + 16}, kInk, 1);
    const std::string text = short_number(mark);
    const double half = canvas.text_width(text, kMarkSize) / 2;
    if (x - half < free) continue;
    canvas.text({x, bar.y + 30}, text, kMarkSize, Align::centre, kInk);
    free = x + half + 6;
  }
}

Key line_key(const std::string& label, Colour colour, double width) {
  return {label, [=](Canvas& canvas, Point p) { canvas.line(p, {p.x + 26, p.y}, colour, width); }};
}

Key dashed_key(const std::string& label, Colour colour) {
  return {label, [=](Canvas& canvas, Point p) { canvas.dashed(p, {p.x + 26, p.y}, colour, 1.5); }};
}

Key area_key(const std::string& label, Colour colour) {
  const auto symbol = [=](Canvas& canvas, Point p) {
    canvas.fill({p.x, p.y - 7, 20, 14}, colour);
    canvas.frame({p.x, p.y - 7, 20, 14}, kInk, 1);
  };
  return {label, symbol, 20};
}

Key disc_key(const std::string& label, Colour colour) {
  return {label, [=](Canvas& canvas, Point p) { canvas.disc({p.x + 9, p.y}, 6, colour); }, 18};
}

Key start_key(const std::string& label) {
  return {label, [](Canvas& canvas, Point p) { canvas.ring({p.x + 9, p.y}, 7, kStart); }, 18};
}

Key goal_key(const std::string& label) {
  return {label, [](Canvas& canvas, Point p) { canvas.diamond({p.x + 9, p.y}, 9, kGoal); }, 18};
}

Key scale_key(const std::string& label, const ColourScale& scale) {
  constexpr double kBar = 110, kDigit = 9;
  const std::string low = fixed(scale.range.low, 0), high = fixed(scale.range.high, 0);
  const double bar = kDigit * static_cast<double>(low.size()) + 5, after = bar + kBar + 5;
  const auto symbol = [=](Canvas& canvas, Point p) {
    canvas.text({p.x, p.y + 5}, low, kLabelSize, Align::left, kInk);
    fill_bar(canvas, {p.x + bar, p.y - 7, kBar, 14}, scale);
    canvas.text({p.x + after, p.y + 5}, high, kLabelSize, Align::left, kInk);
  };
  return {label, symbol, after + kDigit * static_cast<double>(high.size())};
}

double draw_legend(Canvas& canvas, Point top_left, double width, const std::vector<Key>& keys) {
  constexpr double kLine = 19, kAfterSymbol = 8, kBetween = 22;
  double x = 0, y = 0, row = 0;
  for (const Key& key : keys) {
    const double symbol = key.width + kAfterSymbol;
    const auto lines = wrapped(canvas, key.label, kLabelSize, std::max(40.0, width - symbol));
    double widest = 0;
    for (const auto& line : lines) widest = std::max(widest, canvas.text_width(line, kLabelSize));
    if (x > 0 && x + symbol + widest > width) {
      x = 0;
      y += std::exchange(row, 0);
    }
    row = std::max(row, kLine * static_cast<double>(lines.size()) + 3);
    Point p{top_left.x + x, top_left.y + y + kLine / 2};
    key.symbol(canvas, p);
    for (const std::string& line : lines) {
      canvas.text({p.x + symbol, p.y + 5}, line, kLabelSize, Align::left, kInk);
      p.y += kLine;
    }
    x += symbol + widest + kBetween;
  }
  return y + row;
}

}  // namespace lasius::tool
