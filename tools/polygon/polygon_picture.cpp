#include "tools/polygon/polygon_picture.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "tools/draw/canvas.h"
#include "tools/draw/chart.h"
#include "tools/draw/colours.h"
#include "tools/draw/text.h"

namespace lasius::tool {
namespace {

constexpr Colour kWall{0.36, 0.39, 0.44};
constexpr Colour kLine{0.26, 0.57, 0.78};
constexpr Colour kMidpoint{0.03, 0.19, 0.42};
constexpr Colour kDijkstra{0.55, 0.3, 0.65};
constexpr double kMargin = 24, kGap = 24, kCaption = 34, kTitle = 44, kLongSide = 620;

/// The world's place on the page, y up.
class View {
 public:
  View(const PreparedWorld& world, const Box& box) : low_(world.low()), box_(box) {
    const Point high = world.high();
    scale_ = std::min(box.width / (high.x - low_.x), box.height / (high.y - low_.y));
  }
  Point at(Point p) const {
    return {box_.x + (p.x - low_.x) * scale_, box_.y + box_.height - (p.y - low_.y) * scale_};
  }
  std::vector<Point> at(const std::vector<Point>& points) const {
    std::vector<Point> result;
    for (const Point p : points) result.push_back(at(p));
    return result;
  }

 private:
  Point low_;
  Box box_;
  double scale_;
};

double area(const polygon::Ring& ring) {
  double sum = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point a = ring[i], b = ring[(i + 1) % ring.size()];
    sum += (a.x - ring[0].x) * (b.y - ring[0].y) - (a.y - ring[0].y) * (b.x - ring[0].x);
  }
  return std::abs(sum);
}

/// Free space in white on the grown obstacles' grey, the obstacles as drawn in a darker one.
void draw_world(Canvas& canvas, const View& view, const PreparedWorld& world, const Box& box) {
  canvas.fill(box, kPaleWall);
  auto pieces = world.planner.maklink().free_space;
  std::ranges::stable_sort(
      pieces, [](const auto& a, const auto& b) { return area(a.outer) > area(b.outer); });
  for (const auto& piece : pieces) {
    canvas.area(view.at(piece.outer), kFree, 1);
    for (const auto& hole : piece.holes) canvas.area(view.at(hole), kPaleWall, 1);
  }
  canvas.clip(box);
  for (const auto& obstacle : world.planner.world().obstacles)
    if (obstacle.holes.empty()) canvas.area(view.at(obstacle.outer), kWall, 1);
  canvas.unclip();
}

void draw_ends(Canvas& canvas, const View& view, const PolygonAnswer& answer) {
  canvas.disc(view.at(answer.start), 7, kStart);
  canvas.diamond(view.at(answer.goal), 9, kGoal);
}

void draw_graph(Canvas& canvas, const View& view, const PreparedWorld& world,
                const PolygonAnswer& answer) {
  for (const auto& line : world.planner.maklink().lines) {
    canvas.dashed(view.at(line.a), view.at(line.b), kLine, 1.2);
    canvas.disc(view.at(line.midpoint()), 3, kMidpoint);
  }
  if (answer.result.dijkstra)
    canvas.polyline(view.at(answer.result.dijkstra->path), kDijkstra, 2.5);
}

std::string path_caption(const PolygonAnswer& answer) {
  const auto& result = answer.result;
  if (result.path.empty()) return std::string(to_string(result.status)) + ": no path";
  std::string text = "path, length " + study::fixed(result.length, 3);
  if (result.optimal) return text + ", proven shortest";
  if (result.gap()) text += ", " + study::fixed(100 * *result.gap(), 3) + "% above the optimum";
  return text;
}

/// Panels in a row, each with its letter and caption below; those of the world keep its shape.
class Page {
 public:
  Page(const PreparedWorld& world, int panels, const std::string& title)
      : world_(world),
        size_(world),
        panels_(panels),
        width_(2 * kMargin + panels * size_.place_width + (panels - 1) * kGap),
        canvas_(static_cast<int>(width_),
                static_cast<int>(2 * kMargin + kTitle + size_.place_height + kCaption)) {
    canvas_.text({width_ / 2, kMargin + 20}, title, 19, Align::centre, kInk, true);
  }

  /// A panel with the world as its ground.
  template <class Draw>
  void world_panel(const std::string& caption, const Draw& draw) {
    const Box place = next_place();
    const Box box{place.x + (place.width - size_.width) / 2,
                  place.y + (place.height - size_.height) / 2, size_.width, size_.height};
    const View view(world_, box);
    draw_world(canvas_, view, world_, box);
    draw(canvas_, view);
    canvas_.frame(box, kInk, 1);
    write_caption(place, caption);
  }

  void convergence_panel(const Convergence& data) {
    const Box place = next_place();
    draw_convergence(canvas_, place, data);
    write_caption(place, "convergence");
  }

  void save(const std::string& file) const { canvas_.save(file); }

 private:
  /// Of the world on the page, and of a panel's place.
  struct Sizes {
    double width, height, place_width, place_height;

    explicit Sizes(const PreparedWorld& world) {
      const Point low = world.low(), high = world.high();
      const double scale = kLongSide / std::max(high.x - low.x, high.y - low.y);
      width = std::max(40.0, scale * (high.x - low.x));
      height = std::max(40.0, scale * (high.y - low.y));
      place_width = std::max(width, 420.0);
      place_height = std::max(height, 320.0);
    }
  };

  Box next_place() {
    return {kMargin + next_++ * (size_.place_width + kGap), kMargin + kTitle, size_.place_width,
            size_.place_height};
  }
  /// Below the panel that was placed last.
  void write_caption(const Box& place, const std::string& caption) {
    std::string text;
    if (panels_ > 1) text.append("(").append(1, static_cast<char>('a' + next_ - 1)).append(") ");
    canvas_.text({place.x + place.width / 2, place.y + place.height + 24}, text + caption, 15,
                 Align::centre, kInk);
  }

  const PreparedWorld& world_;
  Sizes size_;
  int panels_;
  int next_ = 0;
  double width_;
  Canvas canvas_;
};

}  // namespace

void write_polygon_picture(const std::string& file, const PreparedWorld& world,
                           const PolygonAnswer& answer) {
  const auto& result = answer.result;
  const bool graph = result.dijkstra.has_value(), chart = !result.best.empty();
  Page page(world, 1 + (graph ? 1 : 0) + (chart ? 1 : 0),
            answer.parameters.algorithm() + " on " +
                std::filesystem::path(world.file).filename().string() + ", seed " +
                std::to_string(answer.parameters.seed));
  if (graph) {
    page.world_panel("MAKLINK lines, midpoints, Dijkstra's path, length " +
                         study::fixed(result.dijkstra->length, 3),
                     [&](Canvas& canvas, const View& view) {
                       draw_graph(canvas, view, world, answer);
                       draw_ends(canvas, view, answer);
                     });
  }
  page.world_panel(path_caption(answer), [&](Canvas& canvas, const View& view) {
    canvas.polyline(view.at(result.path), kPath, 3);
    draw_ends(canvas, view, answer);
  });
  if (chart) {
    page.convergence_panel({result.best, result.mean, result.lower_bound, "the world's units"});
  }
  page.save(file);
}

}  // namespace lasius::tool
