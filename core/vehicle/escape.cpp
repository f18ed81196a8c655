#include "core/vehicle/escape.h"

#include <algorithm>
#include <array>
#include <limits>
#include <set>
#include <utility>

#include "core/vehicle/angle.h"
#include "kernels/base/power.h"

namespace lasius::vehicle {
namespace {

/// By which a footprint may grow along each axis that is free at some centre of a cell.
constexpr double kRoom = 0.5;
constexpr double kMostRoom = 6;
constexpr int kExpanded = 64;
constexpr int kCrept = 6000;          ///< the same of small motions
constexpr int kCrossed = 20000;       ///< the same through a gap
constexpr double kBox = 0.25;         ///< cells
constexpr double kTurned = kPi / 60;  ///< of a box
constexpr int kPlaces = 6;            ///< from which connectors are looked for

/// Best first by room. Motions turn as far as there is room for: beside a wall a vehicle gets away
/// from it a little, which gives room to turn more. Where it `creeps` motions are small, one place
/// is kept in each box of poses, and those with the most room are taken: where that does not lead
/// out of a pocket hardly anything does.
class Escape {
 public:
  Escape(const Space::Impl& space, bool towards, bool creeps, std::int64_t& checked)
      : space_(space),
        vehicle_(space.vehicle()),
        towards_(towards),
        creeps_(creeps),
        enough_(std::clamp(space.outline().around() - space.outline().inside(), kRoom, kMostRoom)),
        checked_(checked) {}

  /// A place, and how it was reached.
  struct Place {
    Pose pose;
    double room = 0;
    double cost = 0;
    double rank = 0;
    int before = -1;
    std::vector<Segment> motions = {};  ///< from there, or to there, as driven
  };

  /// The places with the most room of those that have some.
  std::vector<int> run(const Pose& pose, Poller& poller) {
    std::vector<int> found;
    put(pose, -1, {});
    int wide = 0;
    const int most = creeps_ ? kCrept : kExpanded;
    for (int expanded = 0; expanded < most && !open_.empty() && wide < kPlaces; ++expanded) {
      if (poller.stop_after(1024)) return {};
      const int at = take();
      if (places_[at].room >= kRoom) found.push_back(at);
      if (places_[at].room >= enough_)
        ++wide;
      else if (creeps_)
        creep(at);
      else
        expand(at);
    }
    std::ranges::sort(found, [&](int a, int b) {
      const double more = places_[a].room - places_[b].room;
      return creeps_ && more != 0 ? more > 0 : better(a, b);
    });
    found.resize(std::min<std::size_t>(found.size(), kPlaces));
    return found;
  }

  /// From poses on, by what is left of each.
  void cross(std::span<const Pose> from, const std::function<double(int, int)>& left) {
    left_ = &left;
    for (std::size_t i = 0; i < from.size(); ++i) put(from[i], -1 - static_cast<int>(i), {});
  }
  /// The next place that is nearer by a cell than all before; -1: none.
  int nearer(Poller& poller) {
    while (crept_++ < kCrossed && !open_.empty() && !poller.stop_after(1024)) {
      const int at = take();
      creep(at);
      const double left = left_of(places_[at].pose);
      if (left > nearest_ - 1) continue;
      nearest_ = left;
      return at;
    }
    return -1;
  }
  /// Which of the poses a place was reached from.
  int root(int at) const {
    while (at >= 0) at = places_[at].before;
    return -1 - at;
  }

  const std::vector<Place>& places() const { return places_; }
  /// The motions between the end and a place, as driven.
  std::vector<Segment> motions(int at) const {
    std::vector<Segment> way;
    for (int i = at; places_[i].before >= 0; i = places_[i].before) {
      const std::vector<Segment>& more = places_[i].motions;
      way.insert(towards_ ? way.end() : way.begin(), more.begin(), more.end());
    }
    return way;
  }

 private:
  /// First what has more room for its cost: along a wall it may double within its own length.
  bool better(int a, int b) const {
    const Place& one = places_[a];
    const Place& other = places_[b];
    if (one.rank != other.rank) return one.rank > other.rank;
    return one.cost != other.cost ? one.cost < other.cost : a < b;
  }

  double left_of(const Pose& at) const { return (*left_)(floor_of(at.x), floor_of(at.y)); }

  int take() {
    std::pop_heap(open_.begin(), open_.end(), [&](int a, int b) { return better(b, a); });
    const int at = open_.back();
    open_.pop_back();
    return at;
  }

  void put(const Pose& pose, int before, std::vector<Segment> motions) {
    const auto box = [](double value, double size) { return floor_of(value / size); };
    if (creeps_ &&
        !seen_.insert({box(pose.x, kBox), box(pose.y, kBox), box(turned(pose.yaw), kTurned)})
             .second)
      return;
    Place place{pose, left_ == nullptr ? room(pose) : 0, 0, 0, before, std::move(motions)};
    if (before >= 0) place.cost = places_[before].cost + cost(vehicle_, place.motions);
    place.rank =
        left_ != nullptr
            ? -place.cost - 1.5 * left_of(pose)
            : place.room * kernels::power(2, -place.cost / (1.5 * space_.outline().around()));
    places_.push_back(std::move(place));
    open_.push_back(static_cast<int>(places_.size()) - 1);
    std::push_heap(open_.begin(), open_.end(), [&](int a, int b) { return better(b, a); });
  }

  /// By how much the footprint may grow, up to a fifth less.
  double room(const Pose& pose) const {
    double free = enough_;
    while (free > 1e-4 && !space_.free_at(pose, free)) free /= 2;
    for (const double more : {1.4, 1.2}) {
      if (free < enough_ && space_.free_at(pose, more * free)) free *= more;
    }
    return free;
  }

  void expand(int at) {
    // No corner sweeps farther than the room.
    const double turn = std::max(0.9 * places_[at].room, 1e-3) / space_.outline().around();
    const double most = vehicle_.turning_radius > 0 ? 1 / vehicle_.turning_radius : 0;
    for (const int gear : {1, -1}) {
      if (gear < 0 && !vehicle_.reverse) continue;
      for (const double length : {1.0, 4.0, 12.0}) {
        const Segment line{.begin = {}, .length = length, .gear = gear};
        go(at, {line});
        for (int side = 1; side < 8 && vehicle_.sideways; ++side)
          go(at, {Segment{.begin = {}, .length = length, .gear = gear, .angle = side * kPi / 4}});
        // On an arc of this curvature no corner falls by more than the room.
        const double around = space_.outline().around();
        const double gentle = std::min(2 * turn / around, most);
        for (const double bent : {gentle, -gentle}) {
          if (most > 0)
            go(at, {Segment{.begin = {}, .curvature = bent, .length = 3 * length, .gear = gear}});
        }
        for (const double angle : {turn, -turn, turn / 2, -turn / 2}) {
          if (vehicle_.rotate_in_place) aside(at, {.begin = {}, .gear = 0, .angle = angle}, line);
          for (const double on : {1.0, 4.0}) {
            const double bent = std::clamp(angle / on, -most, most);
            if (most > 0)
              aside(at, {.begin = {}, .curvature = bent, .length = on, .gear = gear}, line);
          }
        }
      }
    }
  }

  /// To the boxes about that of a place.
  void creep(int at) {
    for (const double angle : {1.01 * kTurned, -1.01 * kTurned})
      if (vehicle_.rotate_in_place) go(at, {Segment{.begin = {}, .gear = 0, .angle = angle}});
    for (const int gear : {1, -1}) {
      if (gear < 0 && !vehicle_.reverse) continue;
      for (const double side : {0.0, 1.0, -1.0}) {
        if (side != 0 && vehicle_.turning_radius == 0) continue;
        const double bent = side != 0 ? side / vehicle_.turning_radius : 0;
        for (const double length : {1.01 * kBox, 2 * kBox})
          go(at, {Segment{.begin = {}, .curvature = bent, .length = length, .gear = gear}});
      }
    }
  }

  /// A turn, a line and the same turn back; and what of it is left without the last.
  void aside(int at, const Segment& turn, const Segment& line) {
    Segment back = turn;
    back.curvature = -turn.curvature;
    back.angle = -turn.angle;
    go(at, {turn, line});
    go(at, {turn, line, back});
  }

  /// From a place on, or of a goal backwards in time.
  void go(int at, std::vector<Segment> motions) {
    Pose pose = places_[at].pose;
    for (Segment& s : motions) {
      s.begin = pose;
      if (towards_) {
        Segment back = s;
        back.gear = -s.gear;
        if (s.gear == 0) back.angle = -s.angle;
        s.begin = back.end();
      }
      ++checked_;
      // What is left open is more than the last check of a path leaves.
      if (space_.touch(s, 2 * Space::Impl::kFine, false) <= 1) return;
      pose = towards_ ? s.begin : s.end();
    }
    if (towards_) std::ranges::reverse(motions);
    put(pose, at, std::move(motions));
  }

  const Space::Impl& space_;
  const Vehicle& vehicle_;
  bool towards_;
  bool creeps_;
  double enough_;  ///< room to turn where it stands
  std::int64_t& checked_;
  std::vector<Place> places_;
  std::set<std::array<int, 3>> seen_;  ///< boxes
  std::vector<int> open_;              ///< heap
  const std::function<double(int, int)>* left_ = nullptr;
  double nearest_ = std::numeric_limits<double>::infinity();
  int crept_ = 0;
};

/// Puts motions on that end of a connector which is not the lattice's.
void lengthen(const Vehicle& vehicle, bool towards, const std::vector<Segment>& way, Connector& c) {
  const auto driven = [](const Segment& s) { return s.gear != 0; };
  c.motions.insert(towards ? c.motions.end() : c.motions.begin(), way.begin(), way.end());
  c.cost = cost(vehicle, c.motions);
  const auto first = std::ranges::find_if(c.motions, driven);
  const auto last = std::ranges::find_if(c.motions.rbegin(), c.motions.rend(), driven);
  if (first == c.motions.end())
    c.gear = 0;
  else
    c.gear = towards ? first->gear : last->gear;
}

}  // namespace

std::vector<Connector> escapes(const Space::Impl& space, const Lattice& lattice, const Pose& pose,
                               bool towards, bool creeps, const ConnectorReach& reach,
                               std::int64_t& checked, Poller& poller) {
  std::vector<Connector> made;
  for (const bool small : {false, true}) {
    // Where it creeps gentle motions of an end without room were looked at in the round before.
    const bool wanted = small ? creeps : creeps == space.free_at(pose, kRoom);
    if (!wanted) continue;
    Escape escape(space, towards, small, checked);
    for (const int at : escape.run(pose, poller)) {
      const std::vector<Segment> way = escape.motions(at);
      for (Connector& c :
           connectors(space, lattice, escape.places()[at].pose, towards, reach, checked, poller)) {
        lengthen(space.vehicle(), towards, way, c);
        made.push_back(std::move(c));
      }
    }
  }
  return made;
}

std::vector<Crossing> crossings(const Space::Impl& space, const Lattice& lattice,
                                std::span<const Pose> from,
                                const std::function<double(int, int)>& left,
                                const std::function<bool(const Connector&)>& wanted,
                                const ConnectorReach& reach, std::int64_t& checked,
                                Poller& poller) {
  std::vector<Crossing> made;
  Escape escape(space, false, true, checked);
  escape.cross(from, left);
  for (int at = 0; made.empty() && (at = escape.nearer(poller)) >= 0;) {
    const std::vector<Segment> way = escape.motions(at);
    for (Connector& c :
         connectors(space, lattice, escape.places()[at].pose, false, reach, checked, poller)) {
      if (!wanted(c)) continue;
      lengthen(space.vehicle(), false, way, c);
      made.push_back({escape.root(at), std::move(c)});
    }
  }
  return made;
}

}  // namespace lasius::vehicle
