// Drawing by cairo on one page, which becomes an SVG or a PNG file.
#pragma once

#include <cairo.h>

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "lasius/grid/geometry.h"
#include "lasius/path/path.h"
#include "tools/draw/raster.h"

namespace lasius::tool {

struct Box {
  double x = 0, y = 0, width = 0, height = 0;
};

enum class Align { left, centre, right };

/// A white page in pixels, y downwards. Everything drawn is recorded, so one drawing serves both
/// kinds of file.
class Canvas {
 public:
  Canvas();
  /// Of the page, once all is drawn and it is known.
  void resize(double width, double height);

  void line(Point from, Point to, Colour colour, double width);
  void polyline(std::span<const Point> points, Colour colour, double width);
  void dashed(Point from, Point to, Colour colour, double width);
  void frame(const Box& box, Colour colour, double width);
  void fill(const Box& box, Colour colour);
  /// A closed area, `opacity` 0 .. 1, with or without a thin rim of the same colour.
  void area(std::span<const Point> points, Colour colour, double opacity, bool rim = true);
  /// The same, `opacity` 0 .. 1. All lines have round ends and corners.
  void stroke(std::span<const Point> points, Colour colour, double width, double opacity);
  /// Straight pieces and arcs, each beginning where the one before ends, likewise.
  void curve(std::span<const CurvePiece> pieces, Colour colour, double width, double opacity);
  /// Until `unclip`, what is drawn outside of the box is left out.
  void clip(const Box& box);
  void unclip();
  /// A filled circle with a white rim.
  void disc(Point at, double radius, Colour colour);
  /// A circle and a square on its corner, as coloured lines with white rims: the inside shows.
  void ring(Point at, double radius, Colour colour);
  void diamond(Point at, double radius, Colour colour);
  /// One colour a pixel, stretched over a box without smoothing where a pixel grows.
  void image(const Raster<Colour>& pixels, const Box& box);
  /// `at.y` is the base line. With `turned` the text runs upwards.
  void text(Point at, const std::string& text, double size, Align align, Colour colour,
            bool bold = false, bool turned = false);
  double text_width(const std::string& text, double size, bool bold = false);

  /// Writes the page by the file's ending, .svg or .png; an SVG holds the words, which are drawn as
  /// shapes, as its description, too. @throws Error(output_failed).
  void save(const std::string& file) const;

 private:
  struct Release {
    void operator()(cairo_t* context) const { cairo_destroy(context); }
    void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
  };
  using Context = std::unique_ptr<cairo_t, Release>;
  using Surface = std::unique_ptr<cairo_surface_t, Release>;

  void ink(Colour colour);
  void stroke_path(Colour colour, double width, double opacity);
  void rimmed(Colour colour);
  void outlined(Colour colour);
  std::string description() const;
  void select_font(double size, bool bold);

  double width_ = 1, height_ = 1;
  std::vector<std::string> words_;  ///< all texts drawn
  Surface page_;
  Context context_;
};

}  // namespace lasius::tool
