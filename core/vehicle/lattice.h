// A vehicle's lattice: the centres of cells, some headings, and motions between them with the
// masks of all cells that they meet.
#pragma once

#include <vector>

#include "core/vehicle/mask.h"
#include "core/vehicle/outline.h"
#include "core/vehicle/word.h"

namespace lasius::vehicle {

/// A motion from one heading to another, or the same, from cell to cell.
struct Edge {
  int from = 0, to = 0;  ///< headings
  int dx = 0, dy = 0;    ///< cells
  int gear = 1;          ///< 0: a rotation in place
  float cost = 0;        ///< by the vehicle's prices, without cusps
  double angle = 0;      ///< of a line: to where it drives, from the heading
  Masks::Mask mask;
  Word word;  ///< of the radius; backwards: of the motion that leads from its end to its begin
};

/// Directions (p, q) of small whole numbers: a straight motion ends on a cell. A quarter of a turn
/// leads from heading i to i + kHeadings / 4.
class Lattice {
 public:
  static constexpr int kHeadings = 16;

  explicit Lattice(const Vehicle& vehicle, const Outline& outline);

  double yaw(int heading) const noexcept { return yaws_[heading]; }
  Pose pose(int x, int y, int heading) const noexcept { return {x + 0.5, y + 0.5, yaws_[heading]}; }
  const std::vector<Edge>& edges() const noexcept { return edges_; }
  /// Indices of the edges that begin or end with a heading.
  const std::vector<int>& from(int heading) const noexcept { return from_[heading]; }
  const std::vector<int>& to(int heading) const noexcept { return to_[heading]; }
  const Masks& masks() const noexcept { return masks_; }
  /// The footprint at a heading.
  const Masks::Mask& footprint(int heading) const noexcept { return footprints_[heading]; }
  /// Appends the motions of an edge that begins at a cell.
  void append(const Edge& edge, int x, int y, std::vector<Segment>& to) const;

 private:
  void add_edge(Edge edge, const Outline& outline, const Vehicle& vehicle);
  void add_rotations(const Vehicle& vehicle, const Outline& outline);
  Masks::Mask sweep(const std::vector<Segment>& motion, const Outline& outline);

  double radius_;
  std::vector<double> yaws_;
  std::vector<Edge> edges_;
  std::vector<std::vector<int>> from_, to_;
  std::vector<Masks::Mask> footprints_;
  Masks masks_;
};

}  // namespace lasius::vehicle
