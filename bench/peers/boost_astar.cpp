// Boost.Graph's A*.
#include <algorithm>
#include <boost/graph/astar_search.hpp>
#include <numbers>

#include "bench/peers/grid_graph.h"
#include "bench/peers/peers.h"

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
