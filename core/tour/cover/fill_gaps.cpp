#include <algorithm>
#include <cmath>
#include <numeric>
#include <queue>

#include "core/tour/cover/swaths.h"

namespace lasius::tour {

namespace {

constexpr double kLinesOfWidth = 4;
constexpr double kWorth = 0.1;

struct Piece {
  double worth;
  std::size_t number;  // that tells apart what is worth the same
  bool across;
  double c;
  Stretch stretch;
  bool operator<(const Piece& o) const {
    return worth != o.worth ? worth < o.worth : number > o.number;
  }
};

class GapFiller {
 public:
  GapFiller(const ToolLines& lines, const CoverGround& ground, const Heading& heading,
            SwathCounts& counts, Poller& poller)
      : lines_(lines), ground_(ground), heading_(heading), counts_(counts), poller_(poller) {}

  // The parts of a stretch that have something open beside them, less than a width apart.
  void offer(bool across, double c, const Stretch& stretch) {
    const Heading way = across ? heading_.across() : heading_;
    at_.clear();
    ground_.each_row_near(
        way.at(stretch.from, c), way.at(stretch.to, c), [&](std::int64_t first, std::int64_t last) {
          if (poller_.stop_after(last - first + 1)) return;
          for (std::int64_t i = first; i <= last; ++i)
            if (counts_.open(i))
              at_.push_back(std::clamp(way.along(ground_.at(i)), stretch.from, stretch.to));
        });
    if (poller_.stop_after(4 * static_cast<std::int64_t>(at_.size()))) return;
    std::sort(at_.begin(), at_.end());
    const double beside = ground_.spacing() / 2, width = 2 * ground_.half_width();
    for (std::size_t from = 0, to; from < at_.size(); from = to) {
      for (to = from + 1; to < at_.size() && at_[to] - at_[to - 1] <= width;) ++to;
      const Stretch part{std::max(stretch.from, at_[from] - beside),
                         std::min(stretch.to, at_[to - 1] + beside)};
      const double worth = worth_of(part, static_cast<std::int64_t>(to - from));
      if (worth >= kWorth) pieces_.push({worth, number_++, across, c, part});
    }
  }

  void take(const std::function<bool(const Swath&)>& reached, std::vector<Swath>& swaths) {
    while (!pieces_.empty() &&
           !poller_.stop_after(ground_.samples_near(pieces_.top().stretch.length()))) {
      const Piece piece = pieces_.top();
      pieces_.pop();
      const Heading way = piece.across ? heading_.across() : heading_;
      const Swath swath{lines_.settled(way.at(piece.stretch.from, piece.c)),
                        lines_.settled(way.at(piece.stretch.to, piece.c))};
      if (worth_of(piece.stretch, counts_.gain(swath)) < piece.worth) {
        offer(piece.across, piece.c, piece.stretch);
      } else if (reached(swath)) {
        counts_.add(swath);
        swaths.push_back(swath);
      }
    }
  }

 private:
  double worth_of(const Stretch& part, std::int64_t gain) const {
    const double width = 2 * ground_.half_width();
    return ground_.area(gain) / (width * (part.length() + width));
  }

  const ToolLines& lines_;
  const CoverGround& ground_;
  const Heading heading_;
  SwathCounts& counts_;
  Poller& poller_;
  std::vector<double> at_;
  std::priority_queue<Piece> pieces_;
  std::size_t number_ = 0;
};

}  // namespace

void fill_gaps(const ToolLines& lines, const CoverGround& ground, const Heading& heading,
               const std::function<bool(const Swath&)>& reached, SwathCounts& counts,
               std::vector<Swath>& swaths, Poller& poller) {
  GapFiller filler(lines, ground, heading, counts, poller);
  std::vector<Stretch> places;
  const double step = 2 * ground.half_width() / kLinesOfWidth;
  for (const bool across : {false, true}) {
    const Heading way = across ? heading.across() : heading;
    const Stretch extent = lines.extent(way);
    const auto offer = [&](double c) {
      lines.on_line(way, c, places);
      if (poller.stop_after(lines.work_of_line(places))) return;
      for (const Stretch& place : places) filler.offer(across, c, place);
    };
    for (double c = extent.from + step / 2; c < extent.to && !poller.stopped(); c += step) offer(c);
    // The middles of corridors just as wide as the tool.
    if (!lines.tight() || !way.straight()) continue;
    for (double c = std::round(extent.from); c < extent.to && !poller.stopped(); c += 0.5) offer(c);
  }
  filler.take(reached, swaths);
}

void cut_back(const ToolLines& lines, const CoverGround& ground, SwathCounts& counts,
              std::vector<Swath>& swaths, Poller& poller) {
  std::vector<std::size_t> order(swaths.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return swaths[a].length() < swaths[b].length();
  });
  std::vector<char> dropped(swaths.size(), 0);
  for (const std::size_t i : order) {
    Swath& swath = swaths[i];
    const double length = swath.length();
    const Point way{(swath.to.x - swath.from.x) / length, (swath.to.y - swath.from.y) / length};
    bool alone = false;
    double least = length, most = 0;  // of what it alone covers
    ground.each_row_near(swath.from, swath.to, [&](std::int64_t first, std::int64_t last) {
      if (poller.stop_after(4 * (last - first + 1))) return;
      for (std::int64_t s = first; s <= last; ++s) {
        if (counts.of(s) != 1 || !ground.wanted(s)) continue;
        const Point p = ground.at(s);
        const double t = (p.x - swath.from.x) * way.x + (p.y - swath.from.y) * way.y;
        alone = true;
        least = std::min(least, t);
        most = std::max(most, t);
      }
    });
    if (poller.stopped()) break;
    dropped[i] = !alone;
    if (alone) {
      const double beside = ground.spacing() / 2;
      least = std::clamp(least - beside, 0.0, length);
      most = std::clamp(most + beside, 0.0, length);
      if (least == 0 && most == length) continue;
      // Never to a point: a swath has two ends.
      if (most - least < beside) least = std::max(0.0, most - beside);
      if (most - least < beside) most = std::min(length, least + beside);
    }
    counts.add(swath, -1);
    if (dropped[i]) continue;
    const Point from = swath.from;
    if (most < length) swath.to = lines.settled({from.x + most * way.x, from.y + most * way.y});
    if (least > 0) swath.from = lines.settled({from.x + least * way.x, from.y + least * way.y});
    counts.add(swath);
  }
  std::size_t kept = 0;
  for (std::size_t i = 0; i < swaths.size(); ++i)
    if (!dropped[i]) swaths[kept++] = swaths[i];
  swaths.resize(kept);
}

}  // namespace lasius::tour
