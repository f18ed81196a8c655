#include "bench/hunt/hunt.h"

#include <algorithm>
#include <optional>
#include <sstream>
#include <stdexcept>

#include "bench/hunt/drawing.h"
#include "lasius/grid/generate.h"

namespace lasius::bench {
namespace {

// A map of some kind with places on free cells; where it has too few, another one.
HuntCase draw_case(std::uint64_t seed, int least_side, int most_side, int most_places) {
  constexpr std::array kMaps{MapKind::random, MapKind::random, MapKind::blobs,
                             MapKind::rooms,  MapKind::maze,   MapKind::open};
  HuntDraw draw(seed);
  for (;;) {
    GenerateOptions options{.width = draw.between(least_side, most_side),
                            .height = draw.between(least_side, most_side)};
    const MapKind kind = draw.pick(kMaps);
    if (kind == MapKind::random || kind == MapKind::blobs) options.density = draw.real(0, 0.45);
    options.seed = draw.any();
    HuntCase made{generate(kind, options), {}, draw.any()};
    const int few = std::min(most_places, 6);
    const int wanted = draw.between(2, draw.one_in(8) ? most_places : few);
    for (int tries = 0; tries < 20 * wanted; ++tries) {
      const int x = draw.between(0, options.width - 1);
      const Cell cell{x, draw.between(0, options.height - 1)};
      if (made.grid.blocked(cell) || std::ranges::find(made.places, cell) != made.places.end())
        continue;
      made.places.push_back(cell);
      if (made.places.size() == static_cast<std::size_t>(wanted)) return made;
    }
  }
}

template <int kLeastSide, int kMostSide, int kMostPlaces>
HuntCase make_case(std::uint64_t seed) {
  return draw_case(seed, kLeastSide, kMostSide, kMostPlaces);
}

// The world is drawn from the seed, and so is not cut down.
HuntCase make_seed(std::uint64_t seed) { return {Grid(2, 1), {{0, 0}, {1, 0}}, seed}; }

constexpr std::array kKinds{
    HuntKind{"shortest", "exact, prepared, edited, distances, alternatives: a visibility graph",
             make_case<3, 22, 6>, judge_shortest},
    HuntKind{"disc", "exact for discs: all circles and tangents", make_case<5, 13, 4>, judge_disc},
    HuntKind{"colony", "every colony: valid, no shorter than the optimum, threads alike",
             make_case<4, 24, 3>, judge_colony},
    HuntKind{"costs", "exact and colonies over costs: an integral, bounds by sampled edges",
             make_case<3, 9, 3>, judge_costs},
    HuntKind{"tour", "stops with every option: all orders", make_case<6, 20, 14>, judge_tour},
    HuntKind{"vehicle", "vehicles: separating axes along the sweep", make_case<16, 40, 3>,
             judge_vehicle},
    HuntKind{"drive", "drives through changing worlds: the world simulated anew", make_seed,
             judge_drive},
#ifdef LASIUS_HAVE_POLYGON
    HuntKind{"polygon", "paths among polygons: GEOS", make_seed, judge_polygon},
#endif
};

// Whether all places are on free cells, no two on one, and enough to ask about.
bool well_posed(const HuntCase& problem) {
  for (std::size_t i = 0; i < problem.places.size(); ++i) {
    if (problem.grid.blocked(problem.places[i])) return false;
    for (std::size_t j = 0; j < i; ++j)
      if (problem.places[i] == problem.places[j]) return false;
  }
  return problem.places.size() >= 2;
}

// Without columns [from, from + count); nothing where a place is lost or too little stays.
std::optional<HuntCase> without_columns(const HuntCase& problem, int from, int count) {
  const Grid& grid = problem.grid;
  if (grid.width() - count < 1) return {};
  HuntCase less{Grid(grid.width() - count, grid.height()), problem.places, problem.seed};
  for (Cell& place : less.places) {
    if (place.x >= from && place.x < from + count) return {};
    if (place.x >= from) place.x -= count;
  }
  for (int y = 0; y < grid.height(); ++y)
    for (int x = 0; x < less.grid.width(); ++x)
      less.grid.set_blocked({x, y}, grid.blocked({x < from ? x : x + count, y}));
  return less;
}

HuntCase transposed(const HuntCase& problem) {
  HuntCase turned{Grid(problem.grid.height(), problem.grid.width()), problem.places, problem.seed};
  for (Cell& place : turned.places) std::swap(place.x, place.y);
  for (int y = 0; y < problem.grid.height(); ++y)
    for (int x = 0; x < problem.grid.width(); ++x)
      turned.grid.set_blocked({y, x}, problem.grid.blocked({x, y}));
  return turned;
}

// Takes away what can go; true where something went.
class Reduction {
 public:
  Reduction(HuntCase problem, const std::function<bool(const HuntCase&)>& faulty, int most)
      : problem_(std::move(problem)), faulty_(faulty), left_(most) {}

  HuntCase run() && {
    for (bool smaller = true; smaller && left_ > 0;) {
      smaller = columns(false);
      smaller = columns(true) || smaller;
      smaller = places() || smaller;
      smaller = cells() || smaller;
    }
    return std::move(problem_);
  }

 private:
  bool take(HuntCase&& less) {
    if (left_-- <= 0 || !faulty_(less)) return false;
    problem_ = std::move(less);
    return true;
  }

  bool columns(bool rows) {
    bool smaller = false;
    const int side = rows ? problem_.grid.height() : problem_.grid.width();
    for (int count = side / 2; count > 0; count /= 2)
      for (int from = 0; from + count <= (rows ? problem_.grid.height() : problem_.grid.width());) {
        auto less = without_columns(rows ? transposed(problem_) : problem_, from, count);
        if (less && take(rows ? transposed(*less) : std::move(*less)))
          smaller = true;
        else
          from += count;
      }
    return smaller;
  }

  bool places() {
    bool smaller = false;
    for (std::size_t i = 0; problem_.places.size() > 2 && i < problem_.places.size();) {
      HuntCase less = problem_;
      less.places.erase(less.places.begin() + static_cast<std::ptrdiff_t>(i));
      if (take(std::move(less)))
        smaller = true;
      else
        ++i;
    }
    return smaller;
  }

  bool cells() {
    bool smaller = false;
    for (int y = 0; y < problem_.grid.height(); ++y)
      for (int x = 0; x < problem_.grid.width(); ++x) {
        if (problem_.grid.free({x, y})) continue;
        HuntCase less = problem_;
        less.grid.set_blocked({x, y}, false);
        smaller = take(std::move(less)) || smaller;
      }
    return smaller;
  }

  HuntCase problem_;
  const std::function<bool(const HuntCase&)>& faulty_;
  int left_;
};

}  // namespace

HuntVerdict HuntKind::judge(const HuntCase& problem) const {
  HuntVerdict verdict;
  if (!well_posed(problem)) return verdict;
  HuntDraw draw(problem.seed);
  ask(problem, draw, verdict);
  return verdict;
}

std::span<const HuntKind> hunt_kinds() { return kKinds; }

const HuntKind& hunt_kind(std::string_view name) {
  for (const HuntKind& kind : kKinds)
    if (kind.name == name) return kind;
  throw std::out_of_range("no kind of problem: " + std::string(name));
}

HuntCase reduced(HuntCase problem, const std::function<bool(const HuntCase&)>& faulty, int most) {
  return Reduction(std::move(problem), faulty, most).run();
}

std::string as_test(const HuntKind& kind, const HuntCase& problem) {
  std::ostringstream text;
  text << "TEST(Hunt, Found" << problem.seed << ") {\n  const HuntCase found{drawn({";
  for (int y = 0; y < problem.grid.height(); ++y) {
    text << (y == 0 ? "\"" : ",\n                              \"");
    for (int x = 0; x < problem.grid.width(); ++x)
      text << (problem.grid.blocked({x, y}) ? '@' : '.');
    text << '"';
  }
  text << "}),\n                       {";
  for (std::size_t i = 0; i < problem.places.size(); ++i)
    text << (i == 0 ? "{" : ", {") << problem.places[i].x << ", " << problem.places[i].y << '}';
  text << "},\n                       " << problem.seed << "u};\n  EXPECT_EQ(hunt_kind(\""
       << kind.name << "\").judge(found).fault, \"\");\n}\n";
  return text.str();
}

}  // namespace lasius::bench
