// Costs from a source to the edges of cells: made by marching, made a lower bound, traced back.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/base/bucket_queue.h"
#include "core/base/large_array.h"
#include "core/base/poller.h"
#include "core/cost/cell_chords.h"
#include "core/cost/polish.h"
#include "core/cost/terrain.h"

namespace lasius::cost {

/// Values at k intervals of each edge, linear between their ends. Marching (Field D* of Ferguson
/// and Stentz 2006, with k intervals an edge) makes them nearly the cost from the source; `certify`
/// lowers them until no chord of any marched cell costs less than the values differ: then no path
/// from the source that stays in these cells costs less than the value where it ends.
///
/// At a corner where two blocked cells meet the cells left and right of it have values of their
/// own.
class EdgeField {
 public:
  /// A lower bound of what a path costs from some end to a point of a cell, through that cell.
  class Bound {
   public:
    virtual ~Bound() = default;
    virtual double at(Point p, Cell cell) const = 0;
  };

  /// A `Bound` is looked at in so many points an interval.
  static constexpr int kRestPoints = 8;

  explicit EdgeField(const Terrain& terrain) : terrain_(terrain) {}

  /// Forgets everything. Marching goes into cells of `before` alone, unless it is null. Weights are
  /// divided by 1 + slack while marching, so that less is left to lower. `at`: where in the cell,
  /// inside of it, as in [0, 1] x [0, 1]. `most`: about the greatest value that is marched for, if
  /// it is known; it decides about time alone.
  void begin(const CellChords& chords, Cell source, double slack, const EdgeField* before,
             Point at = kMiddle, double most = 0);

  /// Goes on until every value that is left, together with a lower bound of what it costs from
  /// there to the other end, is above `limit`. The bound is that of `before`, or where that is null
  /// `rest`, which outlives the field. False when stopped.
  bool march(const Bound& rest, double limit, Poller& poller);
  /// False when stopped: then the values are no bounds.
  bool certify(Poller& poller);
  /// How far the certified values are from obeying every chord, as a factor of at least 1: values
  /// divided by it are lower bounds. The bounds below are divided by it.
  double excess() const noexcept { return excess_; }
  /// The same, of all chords of all cells, and of rounding.
  double measured_excess(Poller& poller) const;

  /// After certify: no path from the source to a point inside a cell that stays in these cells
  /// costs less. Infinite where they do not reach it.
  double bound(Cell target, Point at = kMiddle) const;
  /// After certify: no path from the source to the other end costs less that leaves these cells,
  /// but stays in those of `before`.
  double bound_of_leaving() const;
  /// A path from the source to a point inside the target, as legs; nothing where none was found.
  std::optional<std::vector<Leg>> trace(Cell target, Point at = kMiddle) const;

  /// Marched cells, as indices of the terrain, in the order in which they were reached.
  const std::vector<std::uint32_t>& cells() const noexcept { return cells_; }
  bool has(std::size_t cell) const noexcept { return !reached_.empty() && reached_[cell] != 0; }
  int intervals() const noexcept { return chords_->intervals(); }
  /// The values around a marched cell, by place.
  void values_of(Cell cell, double* values) const noexcept;
  std::int64_t bytes() const noexcept;

 private:
  static constexpr std::int32_t kNoBlock = -1;
  static constexpr int kMostPlaces = 4 * CellChords::kMostIntervals;

  std::int32_t block(int x, int y);
  void places_of(Cell cell, std::uint32_t* nodes) const noexcept;
  bool open(Cell cell) const noexcept {
    const std::size_t at = terrain_.index(cell.x, cell.y);
    return terrain_.at(at) < kInfinity && (before_ == nullptr || before_->has(at));
  }
  template <class Visit>
  void each_cell_at(std::uint32_t node, const Visit& visit) const;
  double left(std::uint32_t node) noexcept;
  void spread(std::uint32_t node);
  void spread_into(Cell cell, int place, std::uint32_t node);
  bool is_spread(std::uint32_t node) const noexcept { return spread_[node] % 2 != 0; }
  void offer(std::uint32_t node, double value) {
    if (value < value_[node]) take(node, value);
  }
  void take(std::uint32_t node, double value);
  void reach(Cell cell);
  void fill(double* values, double weight) const;
  /// Gives all places of all cells a value; the greatest. The source's cell: by its own chords.
  double complete();
  /// Lowers values until no chord of a cell is off by more than a tolerance. False if some still
  /// are, or when stopped.
  bool settle(double most, Poller& poller);
  double bound_of_leaving(Cell cell, int edge, const std::uint32_t* nodes, double most) const;
  double value_before(Cell cell, int place) const noexcept;

  const Terrain& terrain_;
  const CellChords* chords_ = nullptr;
  const EdgeField* before_ = nullptr;
  Cell source_;
  Point source_at_;
  const Bound* rest_ = nullptr;
  double scale_ = 1;  // of weights while marching
  double excess_ = 1;
  int per_block_ = 0;
  // A block is 2 k nodes: a lattice point, k - 1 on the edge to its right, the point once more for
  // the cells right of it where blocked ones meet, k - 1 on the edge below it.
  std::vector<std::int32_t> blocks_;    // by lattice point
  std::vector<std::uint32_t> lattice_;  // by block
  std::vector<std::uint8_t> split_;     // by block: has the point twice
  GrowingList<float> least_gain_;       // by block: improvements below it are not spread
  GrowingList<double> left_;            // by block: to the other end, by `rest`; below 0: not known
  GrowingList<double> value_;
  GrowingList<double> marched_;       // as before certify, from where marching goes on
  GrowingList<std::uint8_t> spread_;  // by node: odd where it has been spread from; half: how often
  GrowingList<std::uint32_t> by_;     // by node: the cell through which it got its value
  std::uint32_t into_ = 0;            // the cell that is spread into
  std::vector<std::uint8_t> reached_;  // by cell
  std::vector<std::uint32_t> cells_;
  std::vector<std::uint32_t> waiting_;  // nodes beyond the limit
  BucketQueue queue_;
};

}  // namespace lasius::cost
