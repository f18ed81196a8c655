// ANYA: exact any-angle paths by searching intervals of grid lines.
#pragma once

#include <cstdint>
#include <vector>

#include "bench/peers/query_planner.h"

namespace lasius::peers {

/// Shortest Euclidean path among the blocked cells (Harabor, Grastien, Öz & Aksakalli 2016), under
/// the rule of lasius/path/path.h. A node is an interval of a horizontal grid line that a root, the
/// last turn, sees through the rows between; successors are made row by row from the runs of free
/// cells.
///
/// Start and goal are cell centres: the start sends two intervals, the lines above and below its
/// run, and the goal is met when its row is entered. Ends of intervals within 1e-6 of a column are
/// put on it (two such ends differ by far more), so decisions at corners are exact.
class Anya final : public QueryPlanner {
 public:
  explicit Anya(const Grid& grid) : grid_(&grid), table_(1024), mask_(1023) {}
  double plan(Cell start, Cell goal, std::vector<Point>& path) override;

 private:
  // A turn of the path, or its start; roots form a tree.
  struct Root {
    double x, y;
    double cost;
    double to_goal;  // straight distance
    double slope;    // of that line, columns a row
    std::int32_t parent;
    std::uint32_t corner;  // lattice point, kNoCorner for the start
  };
  struct Node {
    double left, right;  // of the interval; both the front end for a flat node
    double bound;        // no path through this node is shorter
    std::int32_t root;
    std::int32_t line;
    std::int8_t dy;  // direction of travel; 0: along the line
    std::int8_t dx;  // of a flat node
  };
  struct Item {
    double bound;
    std::uint32_t node;
    bool operator<(const Item& o) const noexcept { return bound > o.bound; }
  };
  struct Entry {
    std::uint32_t corner, stamp;
    double cost;
  };
  static constexpr std::uint32_t kNoCorner = ~std::uint32_t{0};

  void expand(Node node);
  void expand_cone(const Node& node);
  void expand_run(const Node& node, double ratio, int run_left, int run_right);
  void expand_flat(const Node& node);
  void turn_below(const Node& node, double ratio, int far, int x);
  void turn_behind(const Node& node, double ratio, int x, int side);

  std::int32_t make_root(std::int32_t parent, int x, int y);
  void push_root(double x, double y, double cost, std::int32_t parent, std::uint32_t corner);
  void add_cone(std::int32_t root, double left, double right, int line, int dy);
  void add_flat(std::int32_t root, int x, int line, int dx);
  void see_goal(std::int32_t root, int row, int run_left, int run_right);
  void store(const Node& node);
  Entry& entry(std::uint32_t corner);
  void grow_table();

  const Grid* grid_;
  std::vector<Root> roots_;
  std::vector<Node> nodes_;
  std::vector<std::uint32_t> spare_;  // free places in nodes_
  std::vector<Item> heap_;
  std::vector<Node> fresh_;   // successors of the node in hand
  std::vector<Entry> table_;  // least cost of each corner reached: open addressing, stamped
  std::size_t mask_;
  std::size_t used_ = 0;
  std::uint32_t stamp_ = 0;

  Cell goal_{};
  Point target_{};
  double best_ = kNoPath;
  std::int32_t best_root_ = -1;
  Point best_via_{};
  bool has_via_ = false;
};

}  // namespace lasius::peers
