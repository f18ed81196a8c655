#include "core/vehicle/lattice_flood.h"

#include <algorithm>
#include <bit>
#include <limits>

namespace lasius::vehicle {

bool LatticeFlood::takes(const Lattice& lattice) noexcept {
  return std::ranges::all_of(lattice.edges(), [](const Edge& edge) {
    return static_cast<double>(edge.cost) < (kBuckets - 1) * kUnit;
  });
}

LatticeFlood::LatticeFlood(const EdgePlanes& planes, const Lattice& lattice, int width, int height,
                           Memory& memory)
    : planes_(planes),
      lattice_(lattice),
      width_(width),
      height_(height),
      words_(planes.words()),
      memory_(memory) {
  const std::size_t rows = static_cast<std::size_t>(Lattice::kHeadings) * height_;
  memory_.level.assign(rows * width_, kNever);
  memory_.open.assign(rows * words_, ~std::uint64_t{0});
  const std::uint64_t inside = ~std::uint64_t{0} >> (64 * words_ - width_);
  for (std::size_t row = 1; row <= rows; ++row) memory_.open[row * words_ - 1] = inside;
  for (std::vector<Item>& bucket : memory_.buckets) bucket.clear();
}

int LatticeFlood::run(std::span<const Connector> starts, std::span<const Connector> ends,
                      Poller& poller, int levels) {
  std::vector<std::pair<int, std::uint32_t>> sources;  // level, index
  for (std::uint32_t i = 0; i < starts.size(); ++i)
    if (const int at = units(starts[i]); at < kNever) sources.emplace_back(at, i);
  std::ranges::sort(sources);
  ran_out_ = sources.size() < starts.size();
  double least = std::numeric_limits<double>::infinity();
  for (const Connector& end : ends) least = std::min(least, end.cost);
  std::size_t next_source = 0;
  int best = -1;
  double best_cost = std::numeric_limits<double>::infinity();
  for (int now = 0;; ++now) {
    if (waiting_ == 0 && next_source == sources.size()) break;
    if (best >= 0 && best_cost <= least + now * kUnit) {
      ran_out_ = false;
      break;
    }
    if (now >= levels) {
      ran_out_ = true;
      break;
    }
    std::vector<Item>& bucket = memory_.buckets[now % kBuckets];
    for (; next_source < sources.size() && sources[next_source].first <= now; ++next_source) {
      const Connector& start = starts[sources[next_source].second];
      const auto row = static_cast<std::uint32_t>(start.heading * height_ + start.y);
      bucket.push_back(
          {row * static_cast<std::uint32_t>(words_) + static_cast<std::uint32_t>(start.x >> 6),
           std::uint64_t{1} << (start.x & 63)});
      ++waiting_;
    }
    if (poller.stop_after(static_cast<std::int64_t>(bucket.size()) * 8 + 1)) return -1;
    for (const Item& item : bucket) settle(item, now);
    waiting_ -= static_cast<std::int64_t>(bucket.size());
    bucket.clear();
    for (int i = 0; i < static_cast<int>(ends.size()); ++i) {
      const Connector& end = ends[i];
      const double cost = end.cost + now * kUnit;
      if (level(end.x, end.y, end.heading) != now || cost >= best_cost) continue;
      best = i;
      best_cost = cost;
    }
  }
  return best;
}

void LatticeFlood::settle(const Item& item, int level) {
  const std::uint64_t fresh = item.bits & memory_.open[item.word];
  if (fresh == 0) return;
  memory_.open[item.word] &= ~fresh;
  const int row = static_cast<int>(item.word) / words_;
  const int word = static_cast<int>(item.word) % words_;
  const int heading = row / height_;
  const int y = row % height_;
  const int column = 64 * word;
  std::uint16_t* const levels =
      memory_.level.data() + static_cast<std::size_t>(row) * width_ + column;
  for (std::uint64_t left = fresh; left != 0; left &= left - 1)
    levels[std::countr_zero(left)] = static_cast<std::uint16_t>(level);
  for (const int e : lattice_.from(heading)) {
    const Edge& edge = lattice_.edges()[e];
    const int to_y = y + edge.dy;
    if (to_y < 0 || to_y >= height_) continue;
    const std::uint64_t moved = fresh & planes_.word(e, word, y);
    if (moved == 0) continue;
    const int shift = edge.dx & 63;
    const int first = word + (edge.dx >> 6);
    const std::uint64_t parts[2] = {moved << shift, (moved >> 1) >> (63 - shift)};
    for (int part = 0; part < 2; ++part) {
      const int to = first + part;
      if (parts[part] == 0 || to < 0 || to >= words_) continue;
      const auto index = static_cast<std::uint32_t>((edge.to * height_ + to_y) * words_ + to);
      const std::uint64_t bits = parts[part] & memory_.open[index];
      if (bits == 0) continue;
      memory_.buckets[(level + units(edge)) % kBuckets].push_back({index, bits});
      ++waiting_;
    }
  }
}

int LatticeFlood::last(int x, int y, int heading) const noexcept {
  const int now = level(x, y, heading);
  for (const int e : lattice_.to(heading)) {
    const Edge& edge = lattice_.edges()[e];
    const int from_x = x - edge.dx;
    const int from_y = y - edge.dy;
    if (from_x < 0 || from_y < 0 || from_x >= width_ || from_y >= height_) continue;
    if (level(from_x, from_y, edge.from) + units(edge) == now && planes_.free(e, from_x, from_y))
      return e;
  }
  return -1;
}

void LatticeFlood::append(std::span<const Connector> starts, Cell at, int heading,
                          std::vector<Segment>& to) const {
  std::vector<std::pair<int, Cell>> edges;  // and where they begin
  const auto first = [&] {
    return std::ranges::find_if(starts, [&](const Connector& c) {
      return c.x == at.x && c.y == at.y && c.heading == heading &&
             units(c) == level(at.x, at.y, heading);
    });
  };
  auto start = first();
  for (; start == starts.end(); start = first()) {
    const int e = last(at.x, at.y, heading);
    const Edge& edge = lattice_.edges()[e];
    at = {at.x - edge.dx, at.y - edge.dy};
    heading = edge.from;
    edges.emplace_back(e, at);
  }
  to.insert(to.end(), start->motions.begin(), start->motions.end());
  for (std::size_t i = edges.size(); i-- > 0;) {
    const auto& [e, from] = edges[i];
    lattice_.append(lattice_.edges()[e], from.x, from.y, to);
  }
}

std::vector<LatticeFlood::Try> LatticeFlood::about(const Pose& goal, double far, double most,
                                                   Steering& steering, Poller& poller) const {
  std::vector<Try> tries;
  const int left = std::max(0, floor_of(goal.x - far));
  const int right = std::min(width_ - 1, floor_of(goal.x + far));
  const int top = std::max(0, floor_of(goal.y - far));
  const int bottom = std::min(height_ - 1, floor_of(goal.y + far));
  for (int y = top; y <= bottom && !poller.stop_after(1024); ++y) {
    for (int x = left; x <= right; ++x) {
      for (int h = 0; h < Lattice::kHeadings; ++h) {
        if (level(x, y, h) == kNever) continue;
        const double total = cost(x, y, h) + steering.least(lattice_.pose(x, y, h), goal);
        if (total < most) tries.push_back({total, x, y, h});
      }
    }
  }
  std::ranges::sort(tries);
  return tries;
}

}  // namespace lasius::vehicle
