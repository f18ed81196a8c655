// Boost.Graph's A*, over a grid as an implicit graph: nothing stored but the moves of each cell.
#include <algorithm>
#include <bit>
#include <boost/graph/astar_search.hpp>
#include <boost/iterator/iterator_facade.hpp>
#include <cstdint>
#include <numbers>
#include <utility>

#include "bench/peers/move_grid.h"
#include "bench/peers/peers.h"

namespace lasius::peers {
namespace {

/// One move out of a cell.
struct GridEdge {
  std::uint32_t source, target;
  bool diagonal;
  friend bool operator==(const GridEdge&, const GridEdge&) = default;
};

struct GridGraph {
  const MoveGrid* moves;
};

/// Runs over the moves of one cell, a bit of its mask at a time.
class GridEdgeIterator : public boost::iterator_facade<GridEdgeIterator, GridEdge,
                                                       boost::forward_traversal_tag, GridEdge> {
 public:
  GridEdgeIterator() = default;
  GridEdgeIterator(const MoveGrid& moves, std::uint32_t source, unsigned mask)
      : moves_(&moves), source_(source), mask_(mask) {}

 private:
  friend class boost::iterator_core_access;
  GridEdge dereference() const {
    const auto k = static_cast<unsigned>(std::countr_zero(mask_));
    return {source_, source_ + static_cast<std::uint32_t>(moves_->offsets()[k]), k >= 4};
  }
  bool equal(const GridEdgeIterator& other) const { return mask_ == other.mask_; }
  void increment() { mask_ &= mask_ - 1; }

  const MoveGrid* moves_ = nullptr;
  std::uint32_t source_ = 0;
  unsigned mask_ = 0;
};

std::pair<GridEdgeIterator, GridEdgeIterator> out_edges(std::uint32_t v, const GridGraph& graph) {
  return {{*graph.moves, v, graph.moves->moves(v)}, {*graph.moves, v, 0}};
}
std::size_t out_degree(std::uint32_t v, const GridGraph& graph) {
  return static_cast<std::size_t>(std::popcount(graph.moves->moves(v)));
}
std::uint32_t source(const GridEdge& edge, const GridGraph&) { return edge.source; }
std::uint32_t target(const GridEdge& edge, const GridGraph&) { return edge.target; }

}  // namespace
}  // namespace lasius::peers

template <>
struct boost::graph_traits<lasius::peers::GridGraph> {
  using vertex_descriptor = std::uint32_t;
  using edge_descriptor = lasius::peers::GridEdge;
  using out_edge_iterator = lasius::peers::GridEdgeIterator;
  using degree_size_type = std::size_t;
  using directed_category = boost::directed_tag;
  using edge_parallel_category = boost::disallow_parallel_edge_tag;
  using traversal_category = boost::incidence_graph_tag;
  static vertex_descriptor null_vertex() { return ~std::uint32_t{0}; }
};

namespace lasius::peers {
namespace {

/// boost::astar_search_no_init over the implicit grid graph: shortest octile path. Its maps are
/// stamped, so that a query initialises only the cells that it meets; the heap's own index is a
/// vector that Boost grows anew each time.
class BoostAStar final : public QueryPlanner {
 public:
  explicit BoostAStar(const Grid& grid);
  double plan(Cell start, Cell goal, std::vector<Point>& path) override;

  /// What the search keeps of a cell, valid when the stamp is the query's.
  struct Node {
    double distance, bound;
    std::uint32_t predecessor, stamp;
    std::uint8_t colour;
  };

 private:
  MoveGrid moves_;
  std::vector<Node> nodes_;
  std::uint32_t stamp_ = 0;
};

using Node = BoostAStar::Node;
using Vertex = std::uint32_t;

// The nodes of one query; a node of an older one is made new when it is first looked at.
struct Nodes {
  Node* data;
  std::uint32_t stamp;
  Node& operator()(Vertex v) const noexcept {
    Node& node = data[v];
    if (node.stamp != stamp) node = {kNoPath, kNoPath, v, stamp, boost::white_color};
    return node;
  }
};

// A read-write property map of one member.
template <typename T, auto kMember>
struct MemberMap {
  using key_type = Vertex;
  using value_type = T;
  using reference = T;
  using category = boost::read_write_property_map_tag;
  Nodes nodes;
  friend T get(const MemberMap& map, Vertex v) { return static_cast<T>(map.nodes(v).*kMember); }
  friend void put(const MemberMap& map, Vertex v, T value) {
    using Stored = std::remove_reference_t<decltype(map.nodes(v).*kMember)>;
    map.nodes(v).*kMember = static_cast<Stored>(value);
  }
};

struct WeightMap {
  using key_type = GridEdge;
  using value_type = double;
  using reference = double;
  using category = boost::readable_property_map_tag;
  friend double get(const WeightMap&, const GridEdge& edge) {
    return edge.diagonal ? std::numbers::sqrt2 : 1.0;
  }
};

struct OctileHeuristic {
  const MoveGrid* moves;
  Cell goal;
  double operator()(Vertex v) const {
    const Cell c = moves->cell(v);
    const int dx = std::abs(c.x - goal.x), dy = std::abs(c.y - goal.y);
    return std::max(dx, dy) + (std::numbers::sqrt2 - 1) * std::min(dx, dy);
  }
};

struct GoalFound {};

struct StopAtGoal : boost::default_astar_visitor {
  explicit StopAtGoal(Vertex g) : goal(g) {}
  Vertex goal;
  void examine_vertex(Vertex v, const GridGraph&) const {
    if (v == goal) throw GoalFound{};
  }
};

BoostAStar::BoostAStar(const Grid& grid) : moves_(grid), nodes_(moves_.size(), Node{}) {}

double BoostAStar::plan(Cell start, Cell goal, std::vector<Point>& path) {
  path.clear();
  const Nodes nodes{nodes_.data(), ++stamp_};
  const GridGraph graph{&moves_};
  const Vertex from = moves_.index(start), to = moves_.index(goal);
  const OctileHeuristic heuristic{&moves_, goal};
  using Index = boost::typed_identity_property_map<Vertex>;
  nodes(from).distance = 0;
  nodes(from).bound = heuristic(from);
  try {
    boost::astar_search_no_init(
        graph, from, heuristic, StopAtGoal(to), MemberMap<Vertex, &Node::predecessor>{nodes},
        MemberMap<double, &Node::bound>{nodes}, MemberMap<double, &Node::distance>{nodes},
        WeightMap{}, MemberMap<boost::default_color_type, &Node::colour>{nodes}, Index{},
        std::less<double>{}, std::plus<double>{}, kNoPath, 0.0);
    return kNoPath;
  } catch (GoalFound) {
  }
  for (Vertex v = to; v != from; v = nodes(v).predecessor) path.push_back(centre(moves_.cell(v)));
  path.push_back(centre(start));
  std::reverse(path.begin(), path.end());
  return nodes(to).distance;
}

}  // namespace

std::unique_ptr<QueryPlanner> boost_astar(const Grid& grid) {
  return std::make_unique<BoostAStar>(grid);
}

}  // namespace lasius::peers
