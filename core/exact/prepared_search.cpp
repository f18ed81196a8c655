#include "core/exact/prepared_search.h"

#include <algorithm>
#include <cmath>

#include "core/base/held_bytes.h"
#include "core/base/special_values.h"
#include "core/exact/anytime.h"
#include "core/exact/corner_view.h"
#include "core/grid/grid_view.h"

namespace lasius::exact {

namespace {

// Expansions before a search scans the goal's view: many short searches end earlier.
constexpr std::int64_t kFirstFew = 4;
constexpr double kNearby = 2;  // cells; short queries leave the line by more
constexpr std::uint32_t kLastStamp = std::numeric_limits<std::uint32_t>::max() - 3;

double distance(const QueryEnd& a, int x, int y) noexcept {
  return exact::distance(a.x, a.y, 2 * x, 2 * y);
}

}  // namespace

// What a scan of start or goal finds.
template <class Found>
struct PreparedSearch::Sink {
  const Found& found;
  Poller& poller;
  void corner(int x, int y) { found(x, y); }
  bool go_on(std::int64_t words) { return !poller.stop_after(words); }
};

// For the whole map; where there is no goal the start is one.
void PreparedSearch::begin(const Grid& grid, const CornerGraph& graph, Point start, Point goal,
                           Mode mode, Poller& poller) {
  map_ = view_of(grid);
  graph_ = &graph;
  poller_ = &poller;
  beside_ = nullptr;
  improvements_.begin({});
  start_ = QueryEnd(start);
  goal_ = QueryEnd(goal);
  straight_ = lower_ = exact::distance(start_.x, start_.y, goal_.x, goal_.y);
  horizon_ = kInfinity;
  mode_ = mode;
  told_to_stop_ = false;
  margin_ = 0;
  if (nodes_size_ < graph.size() || stamp_ > kLastStamp) {
    nodes_size_ = std::max(nodes_size_, graph.size());
    nodes_ = ZeroArray<Node>(nodes_size_);
    stamp_ = 0;
  }
}

// Calls found(x, y) for the corners that an end sees, up to the horizon.
template <class Found>
void PreparedSearch::scan_view(const QueryEnd& end, const QueryEnd& other, const Found& found) {
  if (end.is_centre()) {
    Sink<Found> sink{found, *poller_};
    const Ellipse ellipse{end.near(), other.near(), horizon_ + other.off()};
    return view_from_centre(map_, ellipse, stack_, sink);
  }
  const auto worth = [&](int x, int y) {
    return distance(end, x, y) + distance(other, x, y) <= horizon_;
  };
  EndView(map_, end, *poller_).run(worth, [&](const SeenCorner& seen) { found(seen.x, seen.y); });
}

// The corners that the goal sees get their true distance as an estimate: going on from them in any
// other way is longer.
void PreparedSearch::scan_goal_view() {
  goal_corners_.clear();
  const auto found = [this](int x, int y) {
    const double to_goal = distance(goal_, x, y);
    if (distance(start_, x, y) + to_goal > horizon_) return;
    const std::uint32_t index = graph_->index(x, y);
    nodes_[index] = {kInfinity, to_goal, kStart, stamp_, kColumn, true, false, false};
    goal_corners_.push_back(index);
  };
  scan_view(goal_, start_, found);
}

void PreparedSearch::scan_start_view() {
  start_corners_.clear();
  const auto found = [this](int x, int y) { start_corners_.push_back(graph_->index(x, y)); };
  scan_view(start_, goal_, found);
}

// Forgets all corners that were reached, and the path.
void PreparedSearch::restart() {
  ++stamp_;
  upper_ = kInfinity;
  frontier_.reset(straight_, kBucketWidth);
}

void PreparedSearch::reach_start_corners() {
  for (const std::uint32_t index : start_corners_) {
    const GraphCorner& corner = graph_->corner(index);
    const int x = corner.x(), y = corner.y();
    double length = distance(start_, x, y);
    if (mode_ == Mode::flood) length = Landmarks::whole_grains(length, grain_);
    if (too_long(length, x, y)) continue;
    reach(kStart, length, index, x, y, corner.side_from(start_.fine()));
  }
}

// See Landmarks: what the corners know that the goal sees.
void PreparedSearch::measure_landmarks() {
  const Landmarks& landmarks = graph_->landmarks();
  goal_distances_ = {};
  if (landmarks.empty()) return;
  std::array<double, Landmarks::kCount> least, largest;
  least.fill(kInfinity);
  largest.fill(-kInfinity);
  for (const std::uint32_t index : goal_corners_) {
    const Landmarks::Distances& here = landmarks.distances(index);
    const double way = nodes_[index].to_goal;
    for (std::size_t i = 0; i < least.size(); ++i) {
      if (here[i] + way < least[i]) least[i] = here[i] + way;
      if (here[i] - way > largest[i]) largest[i] = here[i] - way;
    }
  }
  for (std::size_t i = 0; i < least.size(); ++i)
    if (least[i] < kInfinity) goal_distances_.set(i, least[i], largest[i]);
}

double PreparedSearch::estimate(std::uint32_t index, int x, int y) const noexcept {
  if (mode_ == Mode::flood || mode_ == Mode::all) return 0;
  const double straight = distance(goal_, x, y);
  if (mode_ != Mode::whole_map || graph_->landmarks().empty()) return straight;
  return std::max(straight, graph_->landmarks().bound(index, goal_distances_));
}

// Is every path behind the horizon that comes to lattice point (x, y) with this length?
bool PreparedSearch::too_long(double length, int x, int y) const noexcept {
  return mode_ == Mode::near_line && length + distance(goal_, x, y) > horizon_;
}

// A corner at lattice point (x, y), by a way of this length.
void PreparedSearch::reach(std::uint32_t parent, double length, std::uint32_t index, int x, int y,
                           Side side) {
  Node& node = nodes_[index];
  if (node.stamp == stamp_) {
    if (margin_ > 0 && alike(length, node.length))
      note_way(index, length < node.length ? node.parent : parent);
    if (length >= node.length) return;
  } else {
    node.stamp = stamp_;
    node.to_goal = estimate(index, x, y);
    node.sees_goal = node.listed = false;
  }
  node.length = length;
  node.parent = parent;
  node.side = side;
  node.expanded = false;
  const double bound = length + node.to_goal;
  if (bound >= longest()) return;
  if (node.sees_goal) {
    if (bound >= upper_) return;
    upper_ = bound;
    last_ = index;
  } else {
    frontier_.push(index, bound);
  }
}

void PreparedSearch::follow(std::uint32_t index, const Root& root, const GraphEdge& edge) {
  const double x = edge.x - root.x, y = edge.y - root.y;
  const double length = root.length + std::sqrt(x * x + y * y);
  if (too_long(length, edge.x, edge.y)) return;
  reach(index, length, edge.to(), edge.x, edge.y, edge.side());
}

// Returns the work done.
std::int64_t PreparedSearch::expand(std::uint32_t index) {
  Node& node = nodes_[index];
  node.expanded = true;
  const GraphCorner& corner = graph_->corner(index);
  const Root root{corner.x(), corner.y(), node.length};
  const bool first = node.parent == kStart;
  const kernels::FinePoint from = start_.fine();
  const GraphCorner& parent = graph_->corner(first ? index : node.parent);
  const std::int64_t onward_x = root.x - parent.x(), onward_y = root.y - parent.y();
  const int bend = corner.bend(node.side);
  const auto edges = graph_->edges(index, node.side);
  // What is followed is known before the nodes are: their loads go side by side. Near the straight
  // line few edges lead to a node.
  const bool fetch = mode_ != Mode::near_line;
  std::size_t taut = 0;
  for (; taut < edges.size(); ++taut) {
    const GraphEdge& edge = edges[taut];
    const std::int64_t turn =
        first ? kernels::turn_sign(from, place(index), kernels::fine({2 * edge.x, 2 * edge.y}))
              : onward_x * (edge.y - root.y) - onward_y * (edge.x - root.x);
    if (turn * bend < 0) break;
    if (!fetch) continue;
    __builtin_prefetch(nodes_.at(edge.to()));
    graph_->landmarks().prefetch(edge.to());
  }
  for (const GraphEdge& edge : edges.first(taut)) follow(index, root, edge);
  return kWordsPerNode + static_cast<std::int64_t>(taut);
}

std::int64_t PreparedSearch::expand_all(std::uint32_t index) {
  nodes_[index].expanded = true;
  const GraphCorner& corner = graph_->corner(index);
  const double before = nodes_[index].length;
  const auto edges = graph_->edges(index);
  for (const GraphEdge& edge : edges) {
    const double x = edge.x - corner.x(), y = edge.y - corner.y();
    const double way = Landmarks::whole_grains(std::sqrt(x * x + y * y), grain_);
    reach(index, before + way, edge.to(), edge.x, edge.y, edge.side());
  }
  return kWordsPerNode + static_cast<std::int64_t>(edges.size());
}

// Takes the best corner of the frontier; false when none can lead to a shorter path, or stopped.
bool PreparedSearch::next_corner(std::uint32_t& index) {
  while (frontier_.advance(*poller_)) {
    lower_ = std::max(lower_, std::min(frontier_.floor(), upper_));
    if (frontier_.floor() >= longest()) return false;
    index = frontier_.pop();
    const Node& node = nodes_[index];
    if (!node.expanded && node.length + node.to_goal < longest()) return true;
    if (poller_->stop_after(1)) return false;
  }
  lower_ = std::max(lower_, std::min(upper_, horizon_));
  return false;
}

// False if the budget of expansions was spent before the search ended.
bool PreparedSearch::run(double target_gap, std::int64_t budget) {
  for (; !poller_->stopped(); --budget) {
    if (budget == 0) return false;
    std::uint32_t index = 0;
    if (!next_corner(index)) break;
    if (margin_ == 0 && upper_ - lower_ <= target_gap * lower_) break;
    if (mode_ == Mode::first_few && reach_goal_from(index)) continue;
    poller_->stop_after(mode_ == Mode::flood ? expand_all(index) : expand(index));
    if (beside_ != nullptr) beside_->take_turn(*poller_);
    if (!tell_improvement()) return told_to_stop_ = true;
  }
  return true;
}

// Takes the straight way from a corner to the goal; false if it does not see it.
bool PreparedSearch::reach_goal_from(std::uint32_t index) {
  const GraphCorner& corner = graph_->corner(index);
  if (!goal_.sees(map_, kernels::HalfPoint{2 * corner.x(), 2 * corner.y()})) return false;
  const Node& node = nodes_[index];
  upper_ = node.length + node.to_goal;
  last_ = index;
  return true;
}

// The next three: true if the search has ended.
bool PreparedSearch::search_near(double target_gap) {
  mode_ = Mode::near_line;
  horizon_ = straight_ * graph_->detour() + kNearby;
  restart();
  scan_goal_view();
  scan_start_view();
  reach_start_corners();
  run(target_gap, kNoBudget);
  return upper_ < kInfinity || poller_->stopped();
}

bool PreparedSearch::search_few(double target_gap) {
  mode_ = Mode::first_few;
  horizon_ = kInfinity;
  restart();
  scan_start_view();
  reach_start_corners();
  return run(target_gap, kFirstFew) || (upper_ < kInfinity && run(target_gap, kNoBudget));
}

bool PreparedSearch::search_whole_map(double target_gap) {
  horizon_ = kInfinity;
  if (mode_ == Mode::near_line) scan_start_view();
  mode_ = Mode::whole_map;
  restart();
  scan_goal_view();
  if (!poller_->stopped()) measure_landmarks();
  reach_start_corners();
  return run(target_gap, kNoBudget);
}

void PreparedSearch::search(const Grid& grid, const CornerGraph& graph, Point start, Point goal,
                            const ExactOptions& options, const StopCondition& stop,
                            ExactAnswer& answer) {
  Poller poller(stop, kWordsPerPoll);
  begin(grid, graph, start, goal, Mode::first_few, poller);
  beside_ = options.beside;
  improvements_.begin(options);
  if (start_.sees(map_, goal_)) {
    upper_ = lower_;
    last_ = kStart;
  } else {
    const double gap = options.target_gap;
    const bool ended = graph.detour() <= kMostDetour ? search_near(gap) : search_few(gap);
    if (!ended) search_whole_map(gap);
  }
  poller_ = nullptr;
  beside_ = nullptr;
  tell_improvement();  // the last one; nothing is left to stop
  answer.path.clear();
  if (upper_ < kInfinity) trace(answer.path);
  conclude(lower_, upper_, told_to_stop_ ? StopCondition::Cause::token : poller.cause(),
           options.target_gap, answer);
  answer.stored_legs = true;
}

bool PreparedSearch::tell_improvement() {
  return improvements_.tell(lower_, upper_, poller_, [this](std::vector<Point>& path) {
    trace(path);
    return path_length(path);
  });
}

std::int64_t PreparedSearch::bytes() const noexcept {
  return nodes_.bytes() + frontier_.bytes() + improvements_.bytes() + last_way_.bytes() +
         held_bytes(start_corners_, goal_corners_, stack_, ways_, way_, steps_);
}

kernels::FinePoint PreparedSearch::place(std::uint32_t index) const noexcept {
  if (index == kStart) return start_.fine();
  const GraphCorner& corner = graph_->corner(index);
  return kernels::fine({2 * corner.x(), 2 * corner.y()});
}

void PreparedSearch::trace(std::vector<Point>& path) const {
  BackwardPath back(goal_, path);
  for (std::uint32_t i = last_; i != kStart; i = nodes_[i].parent) {
    const GraphCorner& corner = graph_->corner(i);
    back.corner({2 * corner.x(), 2 * corner.y()}, place(nodes_[i].parent));
  }
  back.start(start_);
}

}  // namespace lasius::exact
