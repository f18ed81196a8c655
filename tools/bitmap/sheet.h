// The map as all panels of a picture of a run on a bitmap show it.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "tools/bitmap/answer.h"
#include "tools/bitmap/map_file.h"
#include "tools/draw/canvas.h"
#include "tools/draw/colours.h"
#include "tools/draw/page.h"
#include "tools/options/options.h"

namespace lasius::tool {

/// The cells that are shown: all around free ones, start and goal, where that leaves out a tenth
/// of the map or more.
Window shown_of(const LoadedMap& map, const std::vector<Cell>& ends);

struct Sheet {
  const LoadedMap& map;
  const Grid& grid;  ///< whose walls are painted
  const RunOptions& run;
  Window window;
  /// Painted in a tone of its own; null: none, or as blocked.
  const Grid* unknown = map.unknown ? &*map.unknown : nullptr;

  Axes axes(const Box& box) const;  ///< in cells
  bool metres() const { return run.frame == Frame::world; }
  const char* unit() const { return metres() ? "m" : "cells"; }
  std::string length(double cells, int decimals = 2) const;
  /// In cells; in metres of the world where the map is not turned in it.
  void frame(Canvas& canvas, const Box& box) const;
  /// A path on the page: its curve, or its polyline as straight pieces.
  std::vector<CurvePiece> on_page(const Box& box, const Result& result) const;
  std::string note() const;            ///< what the window leaves out
  Page page(std::string title) const;  ///< its legend has start, goal, blocked cells
};

/// What is drawn on: "on" a map of so many cells, and the seed.
std::string map_title(const LoadedMap& map, const RunOptions& run);
/// The same of another algorithm than that of paths.
std::string map_title(const LoadedMap& map, const RunOptions& run, std::string_view algorithm);

/// Paints walls over what `ground` says of the cells under a pixel. Walls never get so thin that
/// they vanish.
void paint_map(Canvas& canvas, const Box& box, const Sheet& sheet,
               const std::function<Colour(Span columns, Span rows)>& ground);
/// How strongly a share of blocked cells under a pixel is shown, 0 .. 1.
double wall_strength(double blocked);

inline Colour free_ground(Span, Span) { return kFree; }

/// Of a point outside of the map there is none.
void draw_marks(Canvas& canvas, const Box& box, const Sheet& sheet, Point start, Point goal,
                bool small);
/// A plan's path with its marks, and under it what the robot's disc sweeps.
void draw_plan(Canvas& canvas, const Box& box, const Sheet& sheet, const Answer& answer);
/// What draw_plan draws beside start and goal.
std::vector<Key> keys_of_plan(const Sheet& sheet, const Answer& answer);
void draw_path(Canvas& canvas, const Box& box, const Sheet& sheet, const std::vector<Point>& path,
               double width, double rim, Colour colour = kPath);

}  // namespace lasius::tool
