// The picture of a tour.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tools/draw/axes.h"
#include "tools/draw/canvas.h"
#include "tools/draw/page.h"
#include "tools/options/options.h"
#include "tools/tour/tour_answer.h"

namespace lasius::tool {

/// How a world is drawn, and what on it.
struct TourGround {
  std::function<Axes(Canvas&, const Box&)> paint;
  std::function<void(Canvas&, const Box&, const std::vector<Point>& path, Colour)> path;
  /// Start and goal, stops.
  std::function<void(Canvas&, const Box&, std::optional<int>, std::optional<int>)> marks;
  std::function<std::string(double)> length;
  std::function<bool(const Place&)> shows;  ///< whether the picture holds it
};

/// The map, the tour, by `algorithm`, and its stops, where they are few by their names, or numbers
/// from 0 as in the JSON; each robot has its colour. `below` draws on the map, below the tour, what
/// the keys `more` are of. @throws Error(output_failed)
void write_tour_picture(const std::string& file, std::string_view algorithm, const RunOptions& run,
                        const TourAnswer& answer,
                        const std::function<void(Canvas&, const Axes&)>& below = {},
                        const std::vector<Key>& more = {});
/// The same in any world. The page's legend begins with the keys of start and goal.
void write_tour_picture(const std::string& file, Page page, const TourGround& ground,
                        const TourAnswer& answer);

}  // namespace lasius::tool
