#include "core/exact/mend_landmarks.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lasius::exact {

void LandmarkMender::mend(std::span<const DirectedEdge> edges) {
  if (edges.empty()) return;
  for (landmark_ = 0; landmark_ < landmarks_.cells().size(); ++landmark_) {
    if (!landmarks_.bounds(landmark_)) continue;
    overwritten_.clear();
    if (!reach_unknown(edges)) {
      landmarks_.give_up(landmark_);
      continue;
    }
    const std::size_t kept = overwritten_.size();
    if (restore<false>(edges, kFewCorners)) continue;
    undo(kept);
    if (restore<true>(edges, kMostCorners)) continue;
    undo(kept);
    if (!restore<false>(edges, kMostCorners)) landmarks_.give_up(landmark_);
  }
}

void LandmarkMender::raise_all(std::span<const std::uint32_t> corners) {
  for (landmark_ = 0; landmark_ < landmarks_.cells().size(); ++landmark_) {
    queue_.clear();
    for (const std::uint32_t corner : corners) {
      for_each_neighbour(corner,
                         [&](std::uint32_t other, float way) { offer<true>(other, corner, way); });
    }
    spread<true>(std::numeric_limits<std::size_t>::max());
  }
  overwritten_.clear();
}

void LandmarkMender::set(std::uint32_t corner, float value) {
  overwritten_.emplace_back(corner, known(corner));
  known(corner) = value;
}

void LandmarkMender::undo(std::size_t kept) {
  while (overwritten_.size() > kept) {
    const auto [corner, value] = overwritten_.back();
    known(corner) = value;
    overwritten_.pop_back();
  }
}

// From what is known along new edges to all that is not. False if that is too much.
bool LandmarkMender::reach_unknown(std::span<const DirectedEdge> edges) {
  queue_.clear();
  reached_.clear();
  for (const DirectedEdge& e : edges) {
    const std::uint32_t to = e.edge.to();
    if (std::isnan(known(e.from)) && !std::isnan(known(to))) queue_.push_back(e.from);
    if (!std::isnan(known(e.from)) && std::isnan(known(to))) queue_.push_back(to);
  }
  for (std::size_t next = 0; next < queue_.size(); ++next) {
    const std::uint32_t corner = queue_[next];
    if (!std::isnan(known(corner))) continue;
    if (reached_.size() == kMostCorners) return false;
    float least = landmarks_.most();
    for_each_neighbour(corner, [&](std::uint32_t other, float way) {
      if (std::isnan(known(other))) {
        queue_.push_back(other);
      } else {
        least = std::min(least, known(other) + way);
      }
    });
    set(corner, least);
    reached_.push_back(corner);
  }
  return true;
}

// One end of an edge tells the other what it is to be at least (at most).
template <bool kRaise>
void LandmarkMender::offer(std::uint32_t from, std::uint32_t to, float way) {
  const float value = kRaise ? known(from) - way : known(from) + way;
  if (!(kRaise ? value > known(to) : value < known(to))) return;
  set(to, value);
  queue_.push_back(to);
}

template <bool kRaise>
bool LandmarkMender::spread(std::size_t most) {
  for (std::size_t next = 0; next < queue_.size(); ++next) {
    if (next == most) return false;
    const std::uint32_t corner = queue_[next];
    for_each_neighbour(corner,
                       [&](std::uint32_t other, float way) { offer<kRaise>(corner, other, way); });
  }
  return true;
}

template <bool kRaise>
bool LandmarkMender::restore(std::span<const DirectedEdge> edges, std::size_t most) {
  queue_.clear();
  const auto check = [&](std::uint32_t a, std::uint32_t b, float way) {
    offer<kRaise>(a, b, way);
    offer<kRaise>(b, a, way);
  };
  for (const DirectedEdge& e : edges) check(e.from, e.edge.to(), way(e.from, e.edge.to()));
  for (const std::uint32_t corner : reached_) {
    for_each_neighbour(corner, [&](std::uint32_t other, float way) { check(corner, other, way); });
  }
  return spread<kRaise>(most);
}

}  // namespace lasius::exact
