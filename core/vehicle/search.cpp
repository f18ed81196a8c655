#include "core/vehicle/search.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

#include "core/vehicle/search_ends.h"
#include "core/vehicle/steering.h"

namespace lasius::vehicle {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();
constexpr double kBucket = 0.125;
constexpr int kProbed = 2000;               ///< states of the probe from the goals
constexpr std::int64_t kHard = 20'000;      ///< states after which all of the lattice is looked at
constexpr std::int64_t kHardest = 100'000;  ///< and over weights a path is good enough

class Search {
 public:
  Search(const Prepared& prepared, const Pose& start, std::span<const Goal> goals,
         const SearchOptions& options, SearchMemory& memory, Result& counts, Poller& poller)
      : prepared_(prepared),
        space_(prepared.space),
        lattice_(prepared.lattice),
        vehicle_(prepared.space.vehicle()),
        start_(start),
        goals_(goals),
        options_(options),
        counts_(counts),
        poller_(poller),
        layers_(vehicle_.reverse && vehicle_.cusp_cost > 0 ? 2 : 1),
        steering_(vehicle_),
        prices_(prepared.prices),
        edges_(prepared.edges),
        flood_(prepared.free, space_, prices_, options.wide, memory.flood, poller),
        lattice_flood_(memory.lattice_flood),
        reached_(memory.reached),
        leads_(memory.leads),
        queue_(memory.queue),
        probe_(memory.probe) {
    reached_.reset(space_, layers_);
    leads_.reset(space_, layers_);
  }

  Found run() {
    shots_from_start();
    if (done()) return std::move(best_);
    connect_ends();
    if (done() || to_goal_.empty() || from_start_.empty()) return std::move(best_);
    begin_probe();
    const bool trap = probe(kProbed) && !start_leads();
    if (done() || trap) return std::move(best_);
    queue_.reset(0, kBucket);
    forward();
    for (int gaps = 4; gaps > 0 && options_.creeps && best_.goal < 0 && cross(); --gaps) forward();
    return std::move(best_);
  }

 private:
  bool done() const { return poller_.stopped(); }
  int layer_of(int gear) const { return layers_ > 1 && gear < 0 ? 1 : 0; }
  /// What a change costs in a cell, of a path whose last gear is that of a layer.
  double cusp(int layer, int gear, const Cell& at) const {
    if (layers_ == 1 || gear == 0 || layer == layer_of(gear)) return 0;
    return vehicle_.cusp_cost * prices_.weight(at.x, at.y);
  }
  /// Of an edge of the lattice that begins in a cell.
  double price(int e, int x, int y) const {
    return edges_ != nullptr ? edges_->at(e, x, y) : lattice_.edges()[e].cost;
  }
  double radius() const { return std::max(vehicle_.turning_radius, 2.0); }
  double near() const { return std::max(radius(), 4.0); }

  void shots_from_start() {
    for (const Goal& goal : goals_)
      shoot(start_, goal, 0, 0, options_.wide ? 12 : 6, [&](std::vector<Segment>&) {});
  }

  /// Tries ways to a goal straight on. @param gear  by which the pose was reached, 0: any
  template <class Before>
  bool shoot(const Pose& from, const Goal& goal, double cost, int gear, int most, Before&& before) {
    // On a lattice beside a wall others would do, but at last it is to be this one.
    const double open = options_.wide ? 2 * Space::Impl::kFine : Space::Impl::kLoose;
    steering_.aim(from, goal.pose, most);
    for (int i = 0; i < steering_.size(); ++i) {
      if (cost + steering_.cost(i) >= best_.cost && best_.goal >= 0) return false;
      shot_.clear();
      if (!steering_.append(i, shot_)) continue;
      double total = cost;
      total += prices_.weighted() ? prices_.of(shot_) : steering_.cost(i);
      if (gear != 0 && !shot_.empty() && shot_[0].gear == -gear)
        total += vehicle_.cusp_cost * prices_.weight(from);
      const bool dearer = best_.goal >= 0 && total >= best_.cost;
      if (prices_.weighted() && dearer) continue;
      if (!space_.all_free(shot_, open, false, counts_.checked) || dearer) continue;
      best_.segments.clear();
      before(best_.segments);
      best_.segments.insert(best_.segments.end(), shot_.begin(), shot_.end());
      best_.cost = total;
      best_.goal = goal.index;
      // Over weights a longer one may be cheaper.
      if (!prices_.weighted()) return true;
    }
    return false;
  }

  void connect_ends() {
    SearchEnds ends = ends_of_search(prepared_, start_, goals_, options_, counts_, poller_);
    from_start_ = std::move(ends.from_start);
    to_goal_ = std::move(ends.to_goal);
    for (const Connector& c : to_goal_) flood_.add_source(c.x, c.y, c.cost);
  }

  bool edge_free(const Edge& edge, int x, int y) {
    if (x < 0 || y < 0 || x >= space_.width() || y >= space_.height()) return false;
    ++counts_.checked;
    const auto cell = static_cast<std::size_t>(y) * space_.width() + x;
    const double reach = 2 * static_cast<double>(edge.mask.reach);
    if (static_cast<double>(space_.field().squared_half_cells[cell]) > reach * reach) return true;
    return lattice_.masks().free(edge.mask, space_.bits(), x, y);
  }

  /// A state of the probe, from which a motion in a gear leads on.
  void lead(int x, int y, int heading, int gear, double cost, std::uint32_t next, std::int32_t by) {
    for (int layer = 0; layer < layers_; ++layer)
      lead_in(leads_.index(x, y, heading, layer), cost + cusp(layer, gear, {x, y}), next, by);
  }
  void lead_in(std::uint32_t index, double cost, std::uint32_t next, std::int32_t by) {
    const auto total = static_cast<float>(cost);
    Leads& state = leads_[index];
    if (total >= state.cost) return;
    state = {total, next, by, false};
    probe_.push(index, total);
  }

  void begin_probe() {
    probe_.reset(0, kBucket);
    for (std::size_t i = 0; i < to_goal_.size(); ++i) {
      const Connector& c = to_goal_[i];
      lead(c.x, c.y, c.heading, c.gear, c.cost, 0, ~static_cast<std::int32_t>(i));
    }
  }

  /// Dijkstra from the goals backwards, so many states on. True if it ran dry: what it met is all
  /// from which they can be reached on the lattice.
  bool probe(std::int64_t states) {
    while (probe_.advance(poller_)) {
      if (states <= 0 || poller_.stopped()) return false;
      const std::uint32_t index = probe_.pop();
      if (leads_[index].expanded) continue;
      leads_[index].expanded = true;
      --states;
      ++counts_.expanded;
      if (poller_.stop_after(64)) return false;
      const Cell at = leads_.cell(index);
      const double cost = leads_[index].cost;
      const int layer = leads_.layer(index);
      const int heading = leads_.heading(index);
      if (const Reached* met = reached_.find(at.x, at.y, heading, layer)) {
        const double total = static_cast<double>(met->cost) + cost;
        if (total < kNever && (best_.goal < 0 || total < best_.cost))
          finish(reached_.index(at.x, at.y, heading, layer), total);
      }
      for (const int e : lattice_.to(heading)) {
        const Edge& edge = lattice_.edges()[e];
        if (edge.gear != 0 && layer != layer_of(edge.gear) && layers_ > 1) continue;
        const int x = at.x - edge.dx;
        const int y = at.y - edge.dy;
        if (!edge_free(edge, x, y)) continue;
        const double total = price(e, x, y) + cost;
        if (edge.gear != 0) {
          lead(x, y, edge.from, edge.gear, total, index, e);
        } else {
          lead_in(leads_.index(x, y, edge.from, layer), total, index, e);
        }
      }
    }
    return !poller_.stopped();
  }

  /// Whether a connector of the start ends where the probe has been.
  bool start_leads() {
    return std::ranges::any_of(from_start_, [&](const Connector& c) {
      const Leads* state = leads_.find(c.x, c.y, c.heading, layer_of(c.gear));
      return state != nullptr && state->cost < std::numeric_limits<float>::infinity();
    });
  }

  double estimate(const Cell& at, int heading) {
    const double flood = flood_.at(at.x, at.y);
    if (flood > 1e29 || flood > 4 * radius() || vehicle_.turning_radius == 0 || goals_.size() > 8) {
      return flood;
    }
    double least = kNever;
    const Pose pose = lattice_.pose(at.x, at.y, heading);
    for (const Goal& goal : goals_) least = std::min(least, steering_.least(pose, goal.pose));
    return options_.lattice_tolerance > 0 ? flood : std::max(flood, least);
  }

  /// On by small motions from where it came nearest to a goal. False: a pocket, or nothing new.
  bool cross() {
    if (done() || best_.full || reached_.size() / 4 < kProbed) return false;
    std::ranges::move(connectors_across(
                          prepared_, reached_, [&](int x, int y) { return flood_.at(x, y); },
                          [&](std::uint32_t i, std::vector<Segment>& to) { append_reached(i, to); },
                          counts_, poller_),
                      std::back_inserter(from_start_));
    return from_start_.size() > offered_;
  }

  void forward() {
    for (; offered_ < from_start_.size(); ++offered_) {
      const Connector& c = from_start_[offered_];
      offer(c.x, c.y, c.heading, layer_of(c.gear), c.cost, 0, ~static_cast<std::int32_t>(offered_));
    }
    std::int64_t expanded = 0;
    std::int64_t next_probe = std::int64_t{2} * kProbed;
    std::uint32_t shots = 0;
    while (queue_.advance(poller_)) {
      if (best_.goal >= 0 && best_.cost <= queue_.floor()) break;
      if (reached_.size() > options_.max_states) {
        best_.full = true;
        break;
      }
      if (expanded >= next_probe) {
        // A goal that hardly anything leads to shows from its own side.
        if (best_.goal < 0 && probe(expanded / 2)) break;
        next_probe = 2 * expanded;
      }
      const std::uint32_t index = queue_.pop();
      if (reached_[index].expanded) continue;
      reached_[index].expanded = true;
      if (++expanded == kHard && flood_lattice()) break;
      if (expanded >= kHardest && best_.goal >= 0 && prices_.weighted()) break;
      if (poller_.stop_after(64)) break;
      const Cell at = reached_.cell(index);
      const int heading = reached_.heading(index);
      const int layer = reached_.layer(index);
      const double cost = reached_[index].cost;
      const double left = reached_[index].left;
      const auto every = static_cast<std::uint32_t>(
          left < 2 * radius() ? 1 : std::min(1000.0, 1 + left / radius()));
      if (++shots % every == 0) shoot_from(index, at, heading, layer, cost);
      for (const int e : lattice_.from(heading)) {
        const Edge& edge = lattice_.edges()[e];
        if (!edge_free(edge, at.x, at.y)) continue;
        const int to_layer = edge.gear == 0 ? layer : layer_of(edge.gear);
        offer(at.x + edge.dx, at.y + edge.dy, edge.to, to_layer,
              cost + price(e, at.x, at.y) + cusp(layer, edge.gear, at), index, e);
      }
    }
    counts_.expanded += expanded;
  }

  /// The cheapest path of the lattice, up to the rounding of its costs, where most of the lattice
  /// would be entered else. True if that ends the search: one was found, or there is none. Not
  /// where a path may cost more than the flood can tell. Over weights, which the flood does not
  /// know, what it finds is a path, and the search goes on.
  bool flood_lattice() {
    if (layers_ > 1 || std::int64_t{space_.width()} * space_.height() > options_.max_states ||
        !LatticeFlood::takes(lattice_) || EdgePlanes::bytes(space_, lattice_) > EdgePlanes::kMost)
      return false;
    const EdgePlanes* planes = prepared_.planes.get(
        options_.stop, [&] { return EdgePlanes::make(space_, lattice_, poller_); });
    if (planes == nullptr) return poller_.stopped();
    LatticeFlood flood(*planes, lattice_, space_.width(), space_.height(), lattice_flood_);
    const Found before = best_;
    const int end = flood.run(from_start_, to_goal_, poller_);
    if (end >= 0) {
      const Connector& last = to_goal_[end];
      const double total = flood.cost(last.x, last.y, last.heading) + last.cost;
      if (best_.goal < 0 || total < best_.cost) {
        best_ = {{}, total, last.end};
        flood.append(from_start_, {last.x, last.y}, last.heading, best_.segments);
        best_.segments.insert(best_.segments.end(), last.motions.begin(), last.motions.end());
      }
    }
    // Most of a turn about a goal, say, where no motions of the lattice are sharp enough.
    for (const Goal& goal : goals_) {
      const double most = best_.goal < 0 ? kNever : best_.cost;
      for (const auto& [total, x, y, h] :
           flood.about(goal.pose, std::min(2 * near(), 60.0), most, steering_, poller_)) {
        if ((best_.goal >= 0 && total >= best_.cost) || poller_.stop_after(64)) break;
        shoot(lattice_.pose(x, y, h), goal, flood.cost(x, y, h), 0, 3,
              [&, at = Cell{x, y}, heading = h](auto& to) {
                flood.append(from_start_, at, heading, to);
              });
      }
    }
    if (best_.goal >= 0) best_.cost = prices_.of(best_.segments);
    if (before.goal >= 0 && before.cost <= best_.cost) best_ = before;
    return !flood.ran_out() && (best_.goal < 0 || !prices_.weighted());
  }

  void offer(int x, int y, int heading, int layer, double cost, std::uint32_t before,
             std::int32_t by) {
    if (x < 0 || y < 0 || x >= space_.width() || y >= space_.height()) return;
    const std::uint32_t index = reached_.index(x, y, heading, layer);
    Reached& state = reached_[index];
    const auto known = static_cast<float>(cost);
    if (known >= state.cost) return;
    if (state.left < 0) state.left = static_cast<float>(estimate({x, y}, heading));
    if (state.left > 1e29F) return;
    state.cost = known;
    state.before = before;
    state.by = by;
    state.expanded = false;
    const double key = cost + options_.weight * static_cast<double>(state.left);
    if (const Leads* leads = leads_.find(x, y, heading, layer)) {
      const double total = cost + static_cast<double>(leads->cost);
      if (total < kNever && (best_.goal < 0 || total < best_.cost)) finish(index, total);
    }
    if (best_.goal < 0 || key < best_.cost) queue_.push(index, key);
  }

  /// The path to a state from which the way is known.
  void finish(std::uint32_t index, double total) {
    best_.segments.clear();
    append_reached(index, best_.segments);
    best_.cost = total;
    const Cell at = reached_.cell(index);
    std::uint32_t next = leads_.index(at.x, at.y, reached_.heading(index), reached_.layer(index));
    while (leads_[next].by >= 0) {
      const Cell cell = leads_.cell(next);
      lattice_.append(lattice_.edges()[leads_[next].by], cell.x, cell.y, best_.segments);
      next = leads_[next].next;
    }
    const Connector& last = to_goal_[~leads_[next].by];
    best_.segments.insert(best_.segments.end(), last.motions.begin(), last.motions.end());
    best_.goal = last.end;
  }

  void append_reached(std::uint32_t index, std::vector<Segment>& to) {
    std::vector<std::uint32_t> states{index};
    while (reached_[states.back()].by >= 0) states.push_back(reached_[states.back()].before);
    const Connector& first = from_start_[~reached_[states.back()].by];
    to.insert(to.end(), first.motions.begin(), first.motions.end());
    for (std::size_t i = states.size(); i-- > 1;) {
      const Cell cell = reached_.cell(states[i]);
      lattice_.append(lattice_.edges()[reached_[states[i - 1]].by], cell.x, cell.y, to);
    }
  }

  void shoot_from(std::uint32_t index, const Cell& at, int heading, int layer, double cost) {
    const Pose pose = lattice_.pose(at.x, at.y, heading);
    const auto squared = [&](const Goal& goal) {
      const double dx = goal.pose.x - pose.x, dy = goal.pose.y - pose.y;
      return dx * dx + dy * dy;
    };
    const auto nearest = std::ranges::min_element(goals_, {}, squared);
    if (nearest == goals_.end()) return;
    if (std::sqrt(squared(*nearest)) + cost >= best_.cost && best_.goal >= 0) return;
    shoot(pose, *nearest, cost, layers_ > 1 ? (layer == 1 ? -1 : 1) : 0, options_.wide ? 6 : 3,
          [&](std::vector<Segment>& to) { append_reached(index, to); });
  }

  const Prepared& prepared_;
  const Space::Impl& space_;
  const Lattice& lattice_;
  const Vehicle& vehicle_;
  Pose start_;
  std::span<const Goal> goals_;
  SearchOptions options_;
  Result& counts_;
  Poller& poller_;
  int layers_;
  Steering steering_;
  const Prices& prices_;
  const EdgePrices* edges_;
  Flood flood_;
  LatticeFlood::Memory& lattice_flood_;
  States<Reached>& reached_;
  States<Leads>& leads_;
  BucketQueue& queue_;
  BucketQueue& probe_;
  std::vector<Connector> from_start_, to_goal_;
  std::size_t offered_ = 0;  ///< of those from the start
  std::vector<Segment> shot_;
  Found best_;
};

}  // namespace

Found search(const Prepared& prepared, const Pose& start, std::span<const Goal> goals,
             const SearchOptions& options, SearchMemory& memory, Result& counts, Poller& poller) {
  return Search(prepared, start, goals, options, memory, counts, poller).run();
}

}  // namespace lasius::vehicle
