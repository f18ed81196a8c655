#include "tools/draw/canvas.h"

#include <cairo-svg.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>
#include <stdexcept>

#include "core/base/output.h"
#include "tools/console/values.h"
#include "tools/draw/text.h"

namespace lasius::tool {
namespace {

cairo_status_t to_stream(void* stream, const unsigned char* data, unsigned int size) {
  auto& out = *static_cast<std::ostream*>(stream);
  out.write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
  return out ? CAIRO_STATUS_SUCCESS : CAIRO_STATUS_WRITE_ERROR;
}

void check(cairo_status_t status) {
  if (status == CAIRO_STATUS_NO_MEMORY) throw std::bad_alloc();
  if (status != CAIRO_STATUS_SUCCESS && status != CAIRO_STATUS_WRITE_ERROR)
    throw std::runtime_error(std::string("cairo: ") + cairo_status_to_string(status));
}

std::uint32_t argb(Colour colour) {
  const auto byte = [](double share) {
    return static_cast<std::uint32_t>(std::lround(255 * std::clamp(share, 0.0, 1.0)));
  };
  return byte(colour.red) << 16 | byte(colour.green) << 8 | byte(colour.blue);
}

}  // namespace

Canvas::Canvas() {
  // Bounded, as cairo's SVG wants it: no page is larger.
  const cairo_rectangle_t most{0, 0, 8192, 32767};
  page_.reset(cairo_recording_surface_create(CAIRO_CONTENT_COLOR_ALPHA, &most));
  context_.reset(cairo_create(page_.get()));
  cairo_set_line_join(context_.get(), CAIRO_LINE_JOIN_ROUND);
  cairo_set_line_cap(context_.get(), CAIRO_LINE_CAP_ROUND);
}

void Canvas::resize(double width, double height) {
  width_ = std::floor(width);
  height_ = std::floor(height);
}

void Canvas::ink(Colour colour) {
  cairo_set_source_rgb(context_.get(), colour.red, colour.green, colour.blue);
}

void Canvas::line(Point from, Point to, Colour colour, double width) {
  const Point points[] = {from, to};
  polyline(points, colour, width);
}

void Canvas::polyline(std::span<const Point> points, Colour colour, double width) {
  if (points.empty()) return;
  stroke(points, colour, width, 1);
}

void Canvas::dashed(Point from, Point to, Colour colour, double width) {
  const double dashes[] = {6, 4};
  cairo_set_dash(context_.get(), dashes, 2, 0);
  line(from, to, colour, width);
  cairo_set_dash(context_.get(), nullptr, 0, 0);
}

void Canvas::frame(const Box& box, Colour colour, double width) {
  cairo_rectangle(context_.get(), box.x, box.y, box.width, box.height);
  ink(colour);
  cairo_set_line_width(context_.get(), width);
  cairo_stroke(context_.get());
}

void Canvas::fill(const Box& box, Colour colour) {
  cairo_rectangle(context_.get(), box.x, box.y, box.width, box.height);
  ink(colour);
  cairo_fill(context_.get());
}

void Canvas::area(std::span<const Point> points, Colour colour, double opacity, bool rim) {
  cairo_t* const c = context_.get();
  cairo_new_path(c);
  for (const Point p : points) cairo_line_to(c, p.x, p.y);
  cairo_close_path(c);
  cairo_set_source_rgba(c, colour.red, colour.green, colour.blue, opacity);
  if (!rim) return cairo_fill(c);
  cairo_fill_preserve(c);
  ink(colour);
  cairo_set_line_width(c, 1);
  cairo_stroke(c);
}

void Canvas::stroke(std::span<const Point> points, Colour colour, double width, double opacity) {
  cairo_t* const c = context_.get();
  cairo_new_path(c);
  for (const Point p : points) cairo_line_to(c, p.x, p.y);
  stroke_path(colour, width, opacity);
}

void Canvas::curve(std::span<const CurvePiece> pieces, Colour colour, double width,
                   double opacity) {
  cairo_t* const c = context_.get();
  cairo_new_path(c);
  for (const CurvePiece& piece : pieces) {
    cairo_line_to(c, piece.from.x, piece.from.y);
    const auto [x, y] = piece.centre;
    const double from = std::atan2(piece.from.y - y, piece.from.x - x);
    if (piece.turn > 0) cairo_arc(c, x, y, piece.radius, from, from + piece.angle);
    if (piece.turn < 0) cairo_arc_negative(c, x, y, piece.radius, from, from - piece.angle);
    cairo_line_to(c, piece.to.x, piece.to.y);
  }
  stroke_path(colour, width, opacity);
}

void Canvas::stroke_path(Colour colour, double width, double opacity) {
  cairo_set_source_rgba(context_.get(), colour.red, colour.green, colour.blue, opacity);
  cairo_set_line_width(context_.get(), width);
  cairo_stroke(context_.get());
}

void Canvas::clip(const Box& box) {
  cairo_save(context_.get());
  cairo_rectangle(context_.get(), box.x - 0.5, box.y - 0.5, box.width + 1, box.height + 1);
  cairo_clip(context_.get());
}

void Canvas::unclip() { cairo_restore(context_.get()); }

void Canvas::rimmed(Colour colour) {
  ink(colour);
  cairo_fill_preserve(context_.get());
  ink({1, 1, 1});
  cairo_set_line_width(context_.get(), 1.5);
  cairo_stroke(context_.get());
}

void Canvas::disc(Point at, double radius, Colour colour) {
  cairo_new_path(context_.get());
  cairo_arc(context_.get(), at.x, at.y, radius, 0, 2 * std::numbers::pi);
  rimmed(colour);
}

void Canvas::outlined(Colour colour) {
  for (const auto& [line, width] : {std::pair(Colour{1, 1, 1}, 4.5), std::pair(colour, 2.25)}) {
    ink(line);
    cairo_set_line_width(context_.get(), width);
    cairo_stroke_preserve(context_.get());
  }
  cairo_new_path(context_.get());
}

void Canvas::ring(Point at, double radius, Colour colour) {
  cairo_new_path(context_.get());
  cairo_arc(context_.get(), at.x, at.y, radius, 0, 2 * std::numbers::pi);
  outlined(colour);
}

void Canvas::diamond(Point at, double radius, Colour colour) {
  cairo_t* const c = context_.get();
  cairo_new_path(c);
  cairo_move_to(c, at.x, at.y - radius);
  cairo_line_to(c, at.x + radius, at.y);
  cairo_line_to(c, at.x, at.y + radius);
  cairo_line_to(c, at.x - radius, at.y);
  cairo_close_path(c);
  outlined(colour);
}

void Canvas::image(const Raster<Colour>& pixels, const Box& box) {
  // Grown here by whole pixels: viewers of SVG differ in how they enlarge an image.
  const int grow = std::max(1, static_cast<int>(std::floor(box.width / pixels.width)));
  const Surface surface(
      cairo_image_surface_create(CAIRO_FORMAT_RGB24, pixels.width * grow, pixels.height * grow));
  check(cairo_surface_status(surface.get()));
  unsigned char* const data = cairo_image_surface_get_data(surface.get());
  const int stride = cairo_image_surface_get_stride(surface.get());
  for (int y = 0; y < pixels.height * grow; ++y) {
    auto* const row =
        reinterpret_cast<std::uint32_t*>(data + static_cast<std::ptrdiff_t>(y) * stride);
    for (int x = 0; x < pixels.width * grow; ++x) row[x] = argb(pixels.at(x / grow, y / grow));
  }
  cairo_surface_mark_dirty(surface.get());

  cairo_t* const c = context_.get();
  cairo_save(c);
  cairo_translate(c, box.x, box.y);
  cairo_scale(c, box.width / (pixels.width * grow), box.height / (pixels.height * grow));
  cairo_set_source_surface(c, surface.get(), 0, 0);
  cairo_pattern_set_filter(cairo_get_source(c), CAIRO_FILTER_NEAREST);
  cairo_paint(c);
  cairo_restore(c);
}

void Canvas::select_font(double size, bool bold) {
  cairo_select_font_face(context_.get(), "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL,
                         bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(context_.get(), size);
}

double Canvas::text_width(const std::string& text, double size, bool bold) {
  select_font(size, bold);
  cairo_text_extents_t extents;
  cairo_text_extents(context_.get(), drawn(text).c_str(), &extents);
  return extents.x_advance;
}

void Canvas::text(Point at, const std::string& text, double size, Align align, Colour colour,
                  bool bold, bool turned) {
  words_.push_back(drawn(text));
  const double width = text_width(text, size, bold);
  const double shift = align == Align::left ? 0 : align == Align::centre ? -width / 2 : -width;
  cairo_t* const c = context_.get();
  cairo_save(c);
  cairo_translate(c, at.x, at.y);
  if (turned) cairo_rotate(c, -std::numbers::pi / 2);
  ink(colour);
  cairo_move_to(c, shift, 0);
  cairo_show_text(c, drawn(text).c_str());
  cairo_restore(c);
}

std::string Canvas::description() const {
  static constexpr Escape kXml[] = {{'&', "&amp;"}, {'<', "&lt;"}, {'>', "&gt;"}};
  std::string text = "<desc>\n";
  for (const std::string& words : words_) {
    std::string line = words;
    const auto is_control = [](char c) { return static_cast<unsigned char>(c) < 0x20; };
    std::ranges::replace_if(line, is_control, '?');  // XML has none of them
    text += with_escapes(line, kXml) + '\n';
  }
  return text + "</desc>\n";
}

void Canvas::save(const std::string& file) const {
  check(cairo_status(context_.get()));
  write_file(file, [&](std::ostream& stream) {
    const bool svg = has_ending(file, ".svg");
    std::ostringstream whole;
    std::ostream& out = svg ? whole : stream;
    const Surface surface(
        svg ? cairo_svg_surface_create_for_stream(to_stream, &out, width_, height_)
            : cairo_image_surface_create(CAIRO_FORMAT_RGB24, static_cast<int>(width_),
                                         static_cast<int>(height_)));
    check(cairo_surface_status(surface.get()));
    if (svg) cairo_svg_surface_set_document_unit(surface.get(), CAIRO_SVG_UNIT_PX);
    {
      const Context copy(cairo_create(surface.get()));
      cairo_set_source_rgb(copy.get(), 1, 1, 1);
      cairo_paint(copy.get());
      cairo_set_source_surface(copy.get(), page_.get(), 0, 0);
      cairo_paint(copy.get());
      check(cairo_status(copy.get()));
    }
    if (!svg) check(cairo_surface_write_to_png_stream(surface.get(), to_stream, &out));
    cairo_surface_finish(surface.get());
    check(cairo_surface_status(surface.get()));
    if (!svg) return;
    const std::string drawn = whole.str();
    const std::size_t head = drawn.find('>', drawn.find("<svg")) + 1;
    stream << std::string_view(drawn).substr(0, head) << '\n'
           << description() << std::string_view(drawn).substr(head);
  });
}

}  // namespace lasius::tool
