#include "core/vehicle/smooth.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/vehicle/angle.h"
#include "core/vehicle/steering.h"

namespace lasius::vehicle {
namespace {

constexpr int kNodes = 60;
constexpr double kLeast = 1e-6;  ///< what a change has to gain

/// A pose on the path.
struct Node {
  Pose pose;
  double cost = 0;  ///< of the path up to here, cusps before it included
  int run = 0;      ///< counts changes of gear
  int gear = 1;
};

/// What joins two nodes.
struct Leg {
  std::vector<Segment> motions;
  double cost = 0;
  int gear = 0;         ///< of a word of one gear; 0: any way
  bool movable = true;  ///< else a part of the path as it was
};

class Smoother {
 public:
  Smoother(const Space::Impl& space, const Prices& prices, std::int64_t& checked, Poller& poller)
      : space_(space),
        prices_(prices),
        vehicle_(space.vehicle()),
        steering_(vehicle_),
        checked_(checked),
        poller_(poller) {}

  std::vector<Segment> run(const std::vector<Segment>& path) {
    lay_nodes(path);
    shortcuts(path);
    descend();
    std::vector<Segment> made;
    for (const Leg& leg : legs_) made.insert(made.end(), leg.motions.begin(), leg.motions.end());
    return made;
  }

 private:
  double price(int gear) const { return gear < 0 ? vehicle_.reverse_cost : 1; }

  void lay_nodes(const std::vector<Segment>& path) {
    nodes_.clear();
    places_.clear();
    const double spacing = std::max(1.5, driven_length(path) / kNodes);
    Node node{path[0].begin, 0, 0, path[0].gear};
    int gear = 0;
    double next = 0;  // driven, to the next node
    double driven = 0;
    for (std::size_t i = 0; i < path.size(); ++i) {
      const Segment& s = path[i];
      if (s.gear != 0 && gear != 0 && s.gear != gear) {
        ++node.run;
        node.cost += vehicle_.cusp_cost * prices_.weight(s.begin);
      }
      if (s.gear != 0) gear = s.gear;
      node.gear = gear;
      const double before = node.cost;
      for (; s.gear != 0 && next < driven + s.length; next += spacing) {
        const double at = next - driven;
        put({s.pose(at), before + prices_.part(s, at), node.run, gear}, i, at);
      }
      driven += s.length;
      node.cost = before + prices_.part(s, s.extent());
    }
    node.pose = path.back().end();
    put(node, path.size() - 1, path.back().extent());
    // A path that begins with a rotation.
    if (places_[0].first != 0 || places_[0].second != 0) {
      nodes_.insert(nodes_.begin(), {path[0].begin, 0, 0, nodes_[0].gear});
      places_.insert(places_.begin(), {0, 0.0});
    }
  }
  void put(const Node& node, std::size_t segment, double at) {
    nodes_.push_back(node);
    places_.push_back({segment, at});
  }

  /// The way from one pose to another in a gear, or any way where that is 0; `leg` has the cheapest
  /// that is free. False: none costs less than `most`, or none is free.
  bool steer(const Pose& from, const Pose& to, int gear, double most, Leg& leg) {
    looked_ = false;
    if (gear == 0) {
      bool any = false;
      steering_.aim(from, to, 3);
      for (int i = 0; i < steering_.size() && steering_.cost(i) < most; ++i) {
        way_.clear();
        if (!steering_.append(i, way_)) continue;
        const double cost = prices_.weighted() ? prices_.of(way_) : steering_.cost(i);
        if (cost >= most || !free(way_)) continue;
        std::swap(leg.motions, way_);
        leg.cost = most = cost;
        leg.gear = 0;
        any = true;
        if (!prices_.weighted()) return true;
      }
      return any;
    }
    leg.cost = words_.aim(from, to, vehicle_.turning_radius, gear) * price(gear);
    if (leg.cost >= most) return false;
    leg.gear = gear;
    if (!words_.motions(leg.motions)) return false;
    if (prices_.weighted()) leg.cost = prices_.of(leg.motions);
    return leg.cost < most && free(leg.motions);
  }

  bool free(const std::vector<Segment>& motions) {
    looked_ = true;
    return space_.all_free(motions, Space::Impl::kLoose, false, checked_);
  }

  /// In which gear alone a way between two nodes is looked for.
  int gear_between(const Node& a, const Node& b) const {
    return a.run == b.run && vehicle_.turning_radius > 0 && !vehicle_.rotate_in_place ? a.gear : 0;
  }

  /// The cheapest chain of legs over the nodes.
  void shortcuts(const std::vector<Segment>& path) {
    constexpr int kTries = 24;
    const int n = static_cast<int>(nodes_.size());
    std::vector<double> best(n, 0);
    std::vector<int> before(n, 0);
    std::vector<Leg> leg(n);
    std::vector<std::pair<double, int>> open;
    for (int b = 1; b < n; ++b) {
      const Node& to = nodes_[b];
      best[b] = best[b - 1] + to.cost - nodes_[b - 1].cost;
      before[b] = b - 1;
      leg[b].movable = false;
      open.clear();
      for (int a = 0; a < b && !poller_.stop_after(64); ++a) {
        const Node& from = nodes_[a];
        const double dx = to.pose.x - from.pose.x;
        const double dy = to.pose.y - from.pose.y;
        const double line = std::sqrt(dx * dx + dy * dy);
        if (best[a] + line >= best[b] - kLeast) continue;
        open.push_back({best[a] + least(from, to, line), a});
      }
      std::ranges::sort(open);
      int tries = 0;
      for (const auto& [cost, a] : open) {
        if (cost >= best[b] - kLeast || tries == kTries) break;
        const bool made = steer(nodes_[a].pose, to.pose, gear_between(nodes_[a], to),
                                best[b] - best[a] - kLeast, made_);
        // Over weights many are not free for their price alone.
        if (looked_ || !prices_.weighted()) ++tries;
        if (!made) continue;
        best[b] = best[a] + made_.cost;
        before[b] = a;
        leg[b] = made_;
      }
    }
    std::vector<int> chain;
    for (int b = n - 1; b > 0; b = before[b]) chain.push_back(b);
    joints_.assign(1, nodes_[0].pose);
    legs_.clear();
    for (std::size_t i = chain.size(); i-- > 0;) {
      const int b = chain[i];
      if (!leg[b].movable) take_over(path, before[b], b, leg[b]);
      legs_.push_back(std::move(leg[b]));
      joints_.push_back(nodes_[b].pose);
    }
  }

  double least(const Node& from, const Node& to, double line) {
    const int gear = gear_between(from, to);
    if (gear == 0) return line;
    return words_.aim(from.pose, to.pose, vehicle_.turning_radius, gear) * price(gear);
  }

  /// The path as it was between two nodes.
  void take_over(const std::vector<Segment>& path, int a, int b, Leg& leg) const {
    leg.cost = nodes_[b].cost - nodes_[a].cost;
    for (std::size_t i = places_[a].first; i <= places_[b].first; ++i) {
      Segment part = path[i];
      const double from = i == places_[a].first ? places_[a].second : 0;
      const double to = i == places_[b].first ? places_[b].second : part.extent();
      if (to - from < 1e-9) continue;
      part.begin = path[i].pose(from);
      if (part.gear == 0) {
        part.angle = part.angle < 0 ? from - to : to - from;
      } else {
        part.length = to - from;
      }
      leg.motions.push_back(part);
    }
  }

  /// Moves each joint along, across and about itself while both its legs get cheaper.
  void descend() {
    constexpr double kTurns = 0.12;  // radians a cell of the step
    for (double step = 2; step > 0.1; step /= 2) {
      bool moved = true;
      for (int pass = 0; moved && pass < 3; ++pass) {
        moved = false;
        for (std::size_t i = 1; i + 1 < joints_.size(); ++i) {
          if (!legs_[i - 1].movable || !legs_[i].movable) continue;
          for (int move = 0; move < 6 && !poller_.stop_after(64); ++move) {
            const double by = (move & 1) != 0 ? -step : step;
            const auto [sine, cosine] = kernels::sine_cosine(joints_[i].yaw);
            Pose pose = joints_[i];
            if (move < 2) {
              pose.x += by * cosine;
              pose.y += by * sine;
            } else if (move < 4) {
              pose.x -= by * sine;
              pose.y += by * cosine;
            } else {
              pose.yaw += by * kTurns;
            }
            moved = move_joint(i, pose) || moved;
          }
        }
      }
    }
  }

  bool move_joint(std::size_t i, const Pose& pose) {
    Leg& before = legs_[i - 1];
    Leg& after = legs_[i];
    const double most = before.cost + after.cost - kLeast;
    const auto line = [](const Pose& a, const Pose& b) {
      const double dx = a.x - b.x;
      const double dy = a.y - b.y;
      return std::sqrt(dx * dx + dy * dy);
    };
    const double rest = line(pose, joints_[i + 1]);
    if (line(joints_[i - 1], pose) + rest >= most) return false;
    if (!steer(joints_[i - 1], pose, before.gear, most - rest, made_)) return false;
    if (!steer(pose, joints_[i + 1], after.gear, most - made_.cost, other_)) return false;
    std::swap(before, made_);
    std::swap(after, other_);
    joints_[i] = pose;
    return true;
  }

  const Space::Impl& space_;
  const Prices& prices_;
  const Vehicle& vehicle_;
  Steering steering_;
  std::int64_t& checked_;
  Poller& poller_;
  GearWords words_;
  std::vector<Node> nodes_;
  std::vector<std::pair<std::size_t, double>> places_;  ///< of the nodes: segment and extent there
  std::vector<Pose> joints_;
  std::vector<Leg> legs_;  ///< between the joints
  Leg made_, other_;
  std::vector<Segment> way_;
  bool looked_ = false;  ///< whether the last way looked for was asked whether it is free
};

}  // namespace

std::vector<Segment> smoothed(const Space::Impl& space, const Prices& prices,
                              std::vector<Segment> path, std::int64_t& checked, Poller& poller) {
  if (path.empty() || (path.size() == 1 && !prices.weighted())) return path;
  std::vector<Segment> made = Smoother(space, prices, checked, poller).run(path);
  return prices.of(made) < prices.of(path) ? made : path;
}

}  // namespace lasius::vehicle
