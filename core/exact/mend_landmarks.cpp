#include "core/exact/mend_landmarks.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lasius::exact {

void LandmarkMender::mend(std::span<const NewEdge> edges) {
  if (edges.empty()) return;
  for (landmark_ = 0; landmark_ < landmarks_.cells().size(); ++landmark_) {
    if (!landmarks_.bounds(landmark_)) continue;
    overwritten_.clear();
    if (!reach_unknown(edges)) {
      landmarks_.give_up(landmark_);
      continue;
    }
    const std::size_t kept = overwritten_.size();
    if (restore<true>(edges)) continue;
    undo(kept);
    if (restore<false>(edges)) continue;
    landmarks_.give_up(landmark_);
  }
}

void LandmarkMender::raise_all(std::span<const std::uint32_t> corners) {
  for (landmark_ = 0; landmark_ < landmarks_.cells().size(); ++landmark_) {
    queue_.clear();
    for (const std::uint32_t corner : corners) {
      for (const GraphEdge& edge : graph_.edges(corner)) {
        offer<true>(edge.to(), corner, way(corner, edge));
      }
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
bool LandmarkMender::reach_unknown(std::span<const NewEdge> edges) {
  queue_.clear();
  reached_.clear();
  for (const NewEdge& e : edges) {
    const std::uint32_t to = e.edge.to();
    if (std::isnan(known(e.from)) && !std::isnan(known(to))) queue_.push_back(e.from);
    if (!std::isnan(known(e.from)) && std::isnan(known(to))) queue_.push_back(to);
  }
  for (std::size_t next = 0; next < queue_.size(); ++next) {
    const std::uint32_t corner = queue_[next];
    if (!std::isnan(known(corner))) continue;
    if (reached_.size() == kMostCorners) return false;
    float least = landmarks_.most();
    for (const GraphEdge& edge : graph_.edges(corner)) {
      const float there = known(edge.to());
      if (std::isnan(there)) {
        queue_.push_back(edge.to());
      } else {
        least = std::min(least, there + way(corner, edge));
      }
    }
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
    for (const GraphEdge& edge : graph_.edges(corner)) {
      offer<kRaise>(corner, edge.to(), way(corner, edge));
    }
  }
  return true;
}

template <bool kRaise>
bool LandmarkMender::restore(std::span<const NewEdge> edges) {
  queue_.clear();
  const auto check = [&](std::uint32_t from, const GraphEdge& edge) {
    const float length = way(from, edge);
    offer<kRaise>(from, edge.to(), length);
    offer<kRaise>(edge.to(), from, length);
  };
  for (const NewEdge& e : edges) check(e.from, e.edge);
  for (const std::uint32_t corner : reached_) {
    for (const GraphEdge& edge : graph_.edges(corner)) check(corner, edge);
  }
  return spread<kRaise>(kMostCorners);
}

}  // namespace lasius::exact
