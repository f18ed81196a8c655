#include "core/tour/order/partial_order.h"

#include <algorithm>

namespace lasius::tour {

namespace {

// The ends of each stop's pairs, stop by stop.
Rows<int> ends_of(int size, std::vector<Before> pairs) {
  std::sort(pairs.begin(), pairs.end());
  Rows<int> ends;
  auto next = pairs.begin();
  for (int stop = 0; stop < size; ++stop) {
    for (; next != pairs.end() && next->first == stop; ++next) ends.push(next->second);
    ends.end_row();
  }
  return ends;
}

// Stops, none behind one that comes after it; those on and behind circles are missing.
std::vector<int> sorted_stops(int size, std::span<const Before> relation) {
  std::vector<int> waits(size, 0), sorted;
  const Rows<int> ends = ends_of(size, {relation.begin(), relation.end()});
  for (const Before& pair : relation) ++waits[pair.second];
  for (int v = 0; v < size; ++v)
    if (waits[v] == 0) sorted.push_back(v);
  for (std::size_t i = 0; i < sorted.size(); ++i)
    for (const int stop : ends[sorted[i]])
      if (--waits[stop] == 0) sorted.push_back(stop);
  return sorted;
}

}  // namespace

std::vector<int> circle_of(int size, std::span<const Before> relation) {
  const std::vector<int> sorted = sorted_stops(size, relation);
  if (static_cast<int>(sorted.size()) == size) return {};
  std::vector<char> left(size, 1);
  for (const int v : sorted) left[v] = 0;
  std::vector<int> prior(size, -1);  // of those left, each has one that is left
  for (const auto& [a, b] : relation)
    if (left[a] && left[b]) prior[b] = a;
  int v = static_cast<int>(std::find(left.begin(), left.end(), 1) - left.begin());
  for (int i = 0; i < size; ++i) v = prior[v];  // on a circle by now
  std::vector<int> circle = {v};
  for (int w = prior[v]; w != v; w = prior[w]) circle.push_back(w);
  std::reverse(circle.begin(), circle.end());
  std::rotate(circle.begin(), std::min_element(circle.begin(), circle.end()), circle.end());
  return circle;
}

PartialOrder::PartialOrder(int size, std::span<const Before> relation, std::vector<int> loads,
                           std::int64_t capacity)
    : loads_(std::move(loads)), capacity_(capacity) {
  std::vector<Before> pairs(relation.begin(), relation.end());
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  if (pairs.empty()) return;
  const Rows<int> ends = ends_of(size, pairs);
  words_ = (static_cast<std::size_t>(size) + 63) / 64;
  later_.assign(size * words_, 0);
  std::vector<int> sorted = sorted_stops(size, pairs);
  std::vector<Before> reduced;
  std::vector<std::uint64_t> beyond(words_);
  std::reverse(sorted.begin(), sorted.end());
  for (const int v : sorted) {
    std::fill(beyond.begin(), beyond.end(), 0);
    for (const int w : ends[v])
      for (std::size_t i = 0; i < words_; ++i) beyond[i] |= later_[w * words_ + i];
    for (const int w : ends[v])
      if ((beyond[w / 64] >> (w % 64) & 1) == 0) reduced.emplace_back(v, w);
    std::copy(beyond.begin(), beyond.end(), later_.begin() + static_cast<long>(v * words_));
    for (const int w : ends[v]) later_[v * words_ + w / 64] |= std::uint64_t{1} << (w % 64);
  }
  next_ = ends_of(size, reduced);
  for (auto& [a, b] : reduced) std::swap(a, b);
  previous_ = ends_of(size, std::move(reduced));
}

bool PartialOrder::parted(int a, int b) const noexcept {
  if (before(b, a)) return true;
  const auto behind = next(a);
  return before(a, b) && !std::binary_search(behind.begin(), behind.end(), b);
}

bool PartialOrder::carries(std::span<const int> order) const noexcept {
  std::int64_t carried = 0;
  for (const int stop : order)
    if ((carried += load(stop)) > capacity_) return false;
  return true;
}

}  // namespace lasius::tour
