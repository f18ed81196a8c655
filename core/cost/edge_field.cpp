#include "core/cost/edge_field.h"

#include <algorithm>
#include <cmath>

#include "core/base/held_bytes.h"

namespace lasius::cost {
namespace {

/// Of an interval's least cost: a smaller improvement of what was spread is not spread again.
constexpr double kImprovement = 1e-3;
constexpr int kFreeTimes = 4, kMost = 240;
// What a chord may be off by: of its weight, and of the greatest value.
constexpr double kAbsolute = 1e-11, kRelative = 1e-15;

}  // namespace

void EdgeField::begin(const CellChords& chords, Cell source, double slack, const EdgeField* before,
                      Point at, double most) {
  chords_ = &chords;
  before_ = before;
  source_ = source;
  source_at_ = at;
  scale_ = 1 / (1 + slack);
  per_block_ = 2 * chords.intervals();
  blocks_.assign(static_cast<std::size_t>(terrain_.width() + 1) * (terrain_.height() + 1),
                 kNoBlock);
  reached_.assign(static_cast<std::size_t>(terrain_.stride()) * (terrain_.height() + 2), 0);
  lattice_.clear();
  split_.clear();
  left_.clear();
  least_gain_.clear();
  value_.clear();
  spread_.clear();
  by_.clear();
  cells_.clear();
  waiting_.clear();
  marched_.clear();
  // Where weights differ by much keys go far: then wider buckets, else most items would wait and be
  // dealt out again and again.
  queue_.reset(0, std::max(terrain_.least() * scale_ / (4 * chords.intervals()), most / (1 << 19)));
  reach(source);
  into_ = static_cast<std::uint32_t>(terrain_.index(source.x, source.y));
  std::uint32_t nodes[kMostPlaces];
  places_of(source, nodes);
  const double weight = terrain_.weight(source.x, source.y) * scale_;
  for (int place = 0; place < chords.places(); ++place)
    offer(nodes[place], weight * distance(source_at_, chords.at(place)));
}

std::int32_t EdgeField::block(int x, int y) {
  std::int32_t& block = blocks_[static_cast<std::size_t>(y) * (terrain_.width() + 1) + x];
  if (block == kNoBlock) {
    block = static_cast<std::int32_t>(lattice_.size());
    lattice_.push_back(static_cast<std::uint32_t>(y) * (terrain_.width() + 1) + x);
    split_.push_back(terrain_.squeeze(x, y));
    left_.push_back(-1);
    const double cheapest = std::min({terrain_.weight(x - 1, y - 1), terrain_.weight(x, y - 1),
                                      terrain_.weight(x - 1, y), terrain_.weight(x, y)});
    least_gain_.push_back(static_cast<float>(kImprovement * cheapest / chords_->intervals()));
    value_.append(static_cast<std::size_t>(per_block_), kInfinity);
    spread_.append(static_cast<std::size_t>(per_block_), 0);
    by_.append(static_cast<std::size_t>(per_block_), 0);
  }
  return block;
}

void EdgeField::reach(Cell cell) {
  std::uint8_t& reached = reached_[terrain_.index(cell.x, cell.y)];
  if (reached != 0) return;
  reached = 1;
  cells_.push_back(static_cast<std::uint32_t>(terrain_.index(cell.x, cell.y)));
  for (int dy = 0; dy < 2; ++dy) {
    for (int dx = 0; dx < 2; ++dx) block(cell.x + dx, cell.y + dy);
  }
}

void EdgeField::places_of(Cell cell, std::uint32_t* nodes) const noexcept {
  const int k = chords_->intervals();
  const std::int32_t* row =
      blocks_.data() + static_cast<std::size_t>(cell.y) * (terrain_.width() + 1) + cell.x;
  const std::int32_t* below = row + terrain_.width() + 1;
  const std::uint32_t nw = row[0] * per_block_, ne = row[1] * per_block_;
  const std::uint32_t sw = below[0] * per_block_, se = below[1] * per_block_;
  for (int i = 1; i < k; ++i) {
    nodes[i] = nw + i;
    nodes[k + i] = ne + k + i;
    nodes[3 * k - i] = sw + i;
    nodes[4 * k - i] = nw + k + i;
  }
  nodes[0] = nw + (split_[row[0]] != 0 ? k : 0);
  nodes[k] = ne;
  nodes[std::ptrdiff_t{2} * k] = se;
  nodes[std::ptrdiff_t{3} * k] = sw + (split_[below[0]] != 0 ? k : 0);
}

void EdgeField::values_of(Cell cell, double* values) const noexcept {
  std::uint32_t nodes[kMostPlaces];
  places_of(cell, nodes);
  for (int place = 0; place < chords_->places(); ++place) values[place] = value_[nodes[place]];
}

// visit(cell, place of the node around it): the cells whose node it is, that can be marched.
template <class Visit>
void EdgeField::each_cell_at(std::uint32_t node, const Visit& visit) const {
  const int k = chords_->intervals();
  const std::uint32_t block = node / per_block_;
  const int slot = static_cast<int>(node % per_block_);
  const int x = static_cast<int>(lattice_[block] % (terrain_.width() + 1));
  const int y = static_cast<int>(lattice_[block] / (terrain_.width() + 1));
  const auto at = [&](int cx, int cy, int place) {
    if (open({cx, cy})) visit(Cell{cx, cy}, place);
  };
  if (slot % k != 0) {
    if (slot < k) {
      at(x, y, slot);
      at(x, y - 1, 3 * k - slot);
    } else {
      at(x - 1, y, slot);
      at(x, y, 5 * k - slot);
    }
    return;
  }
  const bool split = split_[block] != 0;
  if (!split || slot == 0) {
    at(x - 1, y - 1, 2 * k);
    at(x - 1, y, k);
  }
  if (!split || slot == k) {
    at(x, y, 0);
    at(x, y - 1, 3 * k);
  }
}

double EdgeField::value_before(Cell cell, int place) const noexcept {
  std::uint32_t nodes[kMostPlaces];
  before_->places_of(cell, nodes);
  const int step = chords_->intervals() / before_->intervals();
  const int low = place / step, high = (low + 1) % before_->chords_->places();
  const double share = static_cast<double>(place % step) / step;
  const double value = before_->value_[nodes[low]];
  return share == 0 ? value : value + share * (before_->value_[nodes[high]] - value);
}

// Where `rest` tells what is left it is asked at lattice points alone: it is dear, and marching may
// stop a little sooner or later.
double EdgeField::left(std::uint32_t node) noexcept {
  double least = kInfinity;
  const auto of_cell = [&](Cell cell, int place) {
    if (least < kInfinity) return;
    if (before_ != nullptr) {
      least = value_before(cell, place);
    } else {
      const std::uint32_t at = lattice_[node / per_block_], columns = terrain_.width() + 1;
      const std::uint32_t x = at % columns, y = at / columns;
      least = rest_->at({static_cast<double>(x), static_cast<double>(y)}, cell);
    }
  };
  if (before_ == nullptr) {
    double& known = left_[node / per_block_];
    if (known < 0) {
      each_cell_at(node, of_cell);
      known = least;
    }
    return known;
  }
  each_cell_at(node, of_cell);
  return least;
}

bool EdgeField::march(const Bound& rest, double limit, Poller& poller) {
  rest_ = &rest;
  for (std::size_t i = 0; i < marched_.size(); ++i) value_[i] = marched_[i];
  marched_.clear();
  // Values that waited may lie before all buckets: in one bucket they would have no order.
  double least = kInfinity;
  for (const std::uint32_t node : waiting_) least = std::min(least, value_[node]);
  if (least < kInfinity) queue_.reset(least, queue_.width());
  std::size_t kept = 0;
  for (const std::uint32_t node : waiting_) {
    if (poller.stop_after(1)) return false;
    if (is_spread(node)) continue;
    if (value_[node] + left(node) <= limit)
      queue_.push(node, value_[node]);
    else
      waiting_[kept++] = node;
  }
  waiting_.resize(kept);
  // Where weights differ by much most of what is left lies beyond the limit: that is work, too.
  while (queue_.advance(poller)) {
    if (poller.stop_after(1)) return false;
    const std::uint32_t node = queue_.pop();
    if (is_spread(node)) continue;
    if (value_[node] > limit || value_[node] + left(node) > limit) {
      waiting_.push_back(node);
      continue;
    }
    ++spread_[node];
    spread(node);
    if (poller.stop_after(16)) return false;
  }
  return !poller.stopped();
}

void EdgeField::spread(std::uint32_t node) {
  each_cell_at(node, [&](Cell cell, int place) { spread_into(cell, place, node); });
}

void EdgeField::spread_into(Cell cell, int place, std::uint32_t node) {
  reach(cell);
  into_ = static_cast<std::uint32_t>(terrain_.index(cell.x, cell.y));
  const int places = chords_->places(), k = chords_->intervals();
  std::uint32_t nodes[kMostPlaces];
  places_of(cell, nodes);
  const double weight = terrain_.weight(cell.x, cell.y) * scale_;
  const double here = value_[node];
  const int before = place > 0 ? place - 1 : places - 1;
  const int after = place + 1 < places ? place + 1 : 0;
  const double step = here + weight / k;
  offer(nodes[before], step);
  offer(nodes[after], step);
  // What has its value through this cell tells it nothing: ways in a cell are straight.
  if (by_[node] == into_) return;
  double out[3 * CellChords::kMostIntervals];
  bool from_interval = false;
  for (const int interval : {before, place}) {
    const int low = interval, high = interval + 1 < places ? interval + 1 : 0;
    if (!is_spread(nodes[low]) || !is_spread(nodes[high])) continue;
    from_interval = true;
    const double a = value_[nodes[low]], b = value_[nodes[high]];
    const double least = std::min(a, b);
    chords_->reach(interval, a, b, weight, out);
    int to = (interval / k + 1) * k + 1;
    for (int i = 0; i < 3 * k - 1; ++i, ++to) {
      const std::uint32_t other = nodes[to >= places ? to - places : to];
      if (value_[other] > least) offer(other, out[i]);
    }
  }
  if (from_interval) return;
  const Point from = chords_->at(place);
  for (int to = 0; to < places; ++to)
    if (value_[nodes[to]] > here) offer(nodes[to], here + weight * distance(from, chords_->at(to)));
}

void EdgeField::take(std::uint32_t node, double value) {
  const double gain = value_[node] - value;
  value_[node] = value;
  by_[node] = into_;
  if (is_spread(node)) {  // what comes back must gain more each time, else little goes round long
    const int doubled = std::max(0, spread_[node] / 2 - kFreeTimes);
    if (spread_[node] > kMost || gain < std::ldexp(least_gain_[node / per_block_], doubled)) return;
    ++spread_[node];
  }
  queue_.push(node, value);
}

// Places that marching has passed by, where it was not to go on.
void EdgeField::fill(double* values, double weight) const {
  for (int place = 0; place < chords_->places(); ++place) {
    if (values[place] < kInfinity) continue;
    for (int from = 0; from < chords_->places(); ++from) {
      values[place] = std::min(
          values[place], values[from] + weight * distance(chords_->at(from), chords_->at(place)));
    }
  }
}

double EdgeField::complete() {
  const int places = chords_->places();
  std::uint32_t nodes[kMostPlaces];
  double values[kMostPlaces];
  double most = 0;
  for (const std::uint32_t at : cells_) {
    places_of(terrain_.cell(at), nodes);
    for (int i = 0; i < places; ++i) values[i] = value_[nodes[i]];
    fill(values, terrain_.at(at) * scale_);
    for (int i = 0; i < places; ++i) {
      value_[nodes[i]] = values[i];
      most = std::max(most, values[i]);
    }
  }
  places_of(source_, nodes);
  values_of(source_, values);
  chords_->lower_from(source_at_, values, terrain_.weight(source_.x, source_.y));
  for (int i = 0; i < places; ++i) value_[nodes[i]] = values[i];
  return most;
}

bool EdgeField::settle(double most, Poller& poller) {
  constexpr std::uint8_t kDirty = 2;
  const int places = chords_->places();
  std::vector<std::uint32_t> now = cells_, next;
  for (const std::uint32_t at : now) reached_[at] |= kDirty;
  for (int round = 0; round < 1000 && !now.empty(); ++round) {
    for (const std::uint32_t at : now) {
      if ((reached_[at] & kDirty) == 0) continue;
      reached_[at] &= ~kDirty;
      std::uint32_t nodes[kMostPlaces];
      double values[kMostPlaces];
      places_of(terrain_.cell(at), nodes);
      for (int i = 0; i < places; ++i) values[i] = value_[nodes[i]];
      std::uint8_t lowered[kMostPlaces] = {};
      const double tolerance = kAbsolute * terrain_.at(at) + kRelative * most;
      if (poller.stop_after(places)) return false;
      if (!chords_->lower(values, terrain_.at(at), tolerance, lowered)) continue;
      for (int i = 0; i < places; ++i) {
        if (lowered[i] == 0) continue;
        value_[nodes[i]] = values[i];
        each_cell_at(nodes[i], [&](Cell other, int) {
          std::uint8_t& mark = reached_[terrain_.index(other.x, other.y)];
          if (mark != 1) return;
          mark |= kDirty;
          next.push_back(static_cast<std::uint32_t>(terrain_.index(other.x, other.y)));
        });
      }
    }
    now.swap(next);
    next.clear();
  }
  for (const std::uint32_t at : now) reached_[at] = 1;
  return now.empty();
}

bool EdgeField::certify(Poller& poller) {
  marched_.append(value_.size(), 0);
  for (std::size_t i = 0; i < value_.size(); ++i) marched_[i] = value_[i];
  const double most = complete();
  const bool settled = settle(most, poller);
  if (poller.stopped()) return false;
  // Where no chord was off by more than the tolerance, none is by more than that over its length,
  // which is at least an interval.
  const double off = kAbsolute + kRelative * most / terrain_.least();
  excess_ = settled ? 1 + 2 * off * chords_->intervals() + 1e-12 : measured_excess(poller);
  return !poller.stopped();
}

double EdgeField::measured_excess(Poller& poller) const {
  double most = 1, greatest = 0;
  double values[kMostPlaces];
  for (const std::uint32_t at : cells_) {
    values_of(terrain_.cell(at), values);
    most = std::max(most, chords_->excess(values, terrain_.at(at)));
    for (int i = 0; i < chords_->places(); ++i) greatest = std::max(greatest, values[i]);
    poller.stop_after(chords_->places());
  }
  // The source's cell: what its boundary costs from there.
  values_of(source_, values);
  most = std::max(most,
                  chords_->excess_from(source_at_, values, terrain_.weight(source_.x, source_.y)));
  // Differences of values are rounded, too.
  return most + 1e-12 + 4e-16 * chords_->intervals() * greatest / terrain_.least();
}

std::int64_t EdgeField::bytes() const noexcept {
  return held_bytes(blocks_, lattice_, split_, reached_, cells_, waiting_) + value_.bytes() +
         left_.bytes() + marched_.bytes() + spread_.bytes() + by_.bytes() + queue_.bytes();
}

}  // namespace lasius::cost
