// Arcs that a search has reached, by which ways.
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "core/base/held_bytes.h"
#include "core/base/large_array.h"
#include "core/disc/curve.h"
#include "core/disc/disc_space.h"
#include "core/disc/view.h"

namespace lasius::disc {

/// A way to an arc and the turn around it: what comes early by a longer way and what comes late by
/// a shorter one can both matter, so an arc may have several.
struct Label {
  double length = 0;   ///< from the start to where it touches the arc
  double to_goal = 0;  ///< from there, straight
  double angle = 0;    ///< of the normal there
  Normal normal = {};
  std::uint32_t arc = 0;
  std::uint32_t parent = 0;
  std::uint32_t next = 0;  ///< label of the same arc; 0: none
  bool rising = false;
  enum class Line : std::uint8_t { unknown, free, blocked } line = Line::unknown;  ///< to it
  bool expanded = false;
  bool weighed = false;    ///< the weighted search has expanded it
  std::uint8_t scans = 0;  ///< how often it was expanded and cut off
};

/// All labels, by number and by arc. Number 0 is the start.
class Labels {
 public:
  static constexpr std::uint32_t kStart = 0;

  /// Forgets all. @param bent  by how much a way that is not taut has to be shorter than a label's
  void reset(const DiscSpace& space, double bent = 0) {
    radius_ = space.radius();
    bent_ = bent;
    heads_.resize(space.arcs().size());
    if (++stamp_ == 0) {
      heads_.assign(heads_.size(), {});
      stamp_ = 1;
    }
    labels_.clear();
    labels_.push_back({});
  }
  Label& operator[](std::uint32_t i) noexcept { return labels_[i]; }
  const Label& operator[](std::uint32_t i) const noexcept { return labels_[i]; }
  std::uint32_t size() const noexcept { return static_cast<std::uint32_t>(labels_.size()); }

  std::uint32_t add(const Label& label) {
    Head& head = heads_[label.arc];
    const std::uint32_t number = size();
    labels_.push_back(label);
    labels_[number].next = head.stamp == stamp_ ? head.first : 0;
    head = {stamp_, number};
    return number;
  }

  /// Is there a shorter way to where a label touches its arc, along the arc from where another one
  /// does? One of the same turn that comes there by a way of the same length will do, too.
  /// Distances along an arc are the least that there are on the arc, so no shortest path has such a
  /// label. `reached` tells of a label whether the line to it is free.
  template <class Reached>
  bool dominated(const Label& label, std::uint32_t number, const Reached& reached) const {
    const Head& head = heads_[label.arc];
    for (std::uint32_t i = head.stamp == stamp_ ? head.first : 0; i != 0; i = labels_[i].next) {
      const Label& other = labels_[i];
      if (i == number || other.line == Label::Line::blocked) continue;
      const double turned = label.rising ? label.angle - other.angle : other.angle - label.angle;
      const double length = other.length + radius_ * std::abs(turned);
      const bool taut = other.rising == label.rising && turned >= 0;
      const bool tie = length == label.length && taut;
      if ((length + (taut ? 0 : bent_) < label.length || tie) && reached(i)) return true;
    }
    return false;
  }
  /// The label of the same turn that a label's rays are to be looked along up to, since it has a
  /// shorter way; kStart: none, they reach to the arc's end.
  template <class Reached>
  std::uint32_t ahead(const Label& label, const Reached& reached) const {
    double nearest = 4;  // more than any turn
    std::uint32_t found = kStart;
    const Head& head = heads_[label.arc];
    for (std::uint32_t i = head.stamp == stamp_ ? head.first : 0; i != 0; i = labels_[i].next) {
      const Label& other = labels_[i];
      const double turned = label.rising ? other.angle - label.angle : label.angle - other.angle;
      if (other.line == Label::Line::blocked || other.rising != label.rising || !(turned > 0) ||
          turned >= nearest || !(other.length < label.length + radius_ * turned) || !reached(i))
        continue;
      nearest = turned;
      found = i;
    }
    return found;
  }

  std::int64_t bytes() const noexcept { return labels_.bytes() + held_bytes(heads_); }

 private:
  struct Head {
    std::uint32_t stamp = 0;
    std::uint32_t first = 0;
  };
  double radius_ = 0;
  double bent_ = 0;
  std::uint32_t stamp_ = 0;
  std::vector<Head> heads_;
  GrowingList<Label> labels_;
};

/// The curve from a start over a label and its parents to a goal, its last line at this normal.
Curve trace(const DiscSpace& space, const Labels& labels, std::uint32_t last, Normal leaves,
            Point start, Point goal);

}  // namespace lasius::disc
