// Judges a drive: the world simulated anew, cell by cell, from its description.
//
// Shares nothing with the library but Grid and the types that describe a world.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "lasius/drive/drive.h"

namespace lasius {

class DriveChecker {
 public:
  DriveChecker(const Grid& truth, const Changes& changes, double radius)
      : truth_(truth), radius_(radius), changes_(changes.cells) {
    std::stable_sort(changes_.begin(), changes_.end(),
                     [](const Change& a, const Change& b) { return a.tick < b.tick; });
    for (const MovingObstacle& o : changes.obstacles) movers_.push_back({o, o.track[0]});
    std::stable_sort(movers_.begin(), movers_.end(),
                     [](const Mover& a, const Mover& b) { return a.what.tick < b.what.tick; });
  }

  /// What is wrong with a track, or nothing.
  std::string fault(const std::vector<Cell>& track) {
    for (std::size_t tick = 0; tick < track.size(); ++tick) {
      const Cell before = track[tick == 0 ? 0 : tick - 1], here = track[tick];
      const std::string place = " at tick " + std::to_string(tick) + " in (" +
                                std::to_string(here.x) + ", " + std::to_string(here.y) + ")";
      if (std::abs(here.x - before.x) > 1 || std::abs(here.y - before.y) > 1) return "leap" + place;
      // The move was made in the world of the tick before; the obstacles then moved.
      if (tick > 0 && touches_any(before, here)) return "entered an obstacle" + place;
      const auto was = movers_;
      advance(static_cast<std::int64_t>(tick), before, here);
      if (touches(here)) return "hit by an obstacle" + place;
      if (swapped(was, before, here)) return "swapped" + place;
    }
    return {};
  }

  /// True when the robot's centre could go from cell to cell now, by moves along the axes.
  bool joined(Cell from, Cell to) const {
    std::vector<Cell> open{from};
    std::set<std::pair<int, int>> seen{{from.x, from.y}};
    if (touches(from) || touches(to)) return false;
    while (!open.empty()) {
      const Cell c = open.back();
      open.pop_back();
      if (c == to) return true;
      for (const Cell n :
           {Cell{c.x + 1, c.y}, Cell{c.x - 1, c.y}, Cell{c.x, c.y + 1}, Cell{c.x, c.y - 1}}) {
        if (!touches(n) && seen.insert({n.x, n.y}).second) open.push_back(n);
      }
    }
    return false;
  }

 private:
  struct Mover {
    MovingObstacle what;
    Cell at;
    std::size_t towards = 0;
    int direction = 1;
    double owed = 0;
    bool there = false;

    bool covers(Cell c) const {
      return there && c.x >= at.x && c.y >= at.y && c.x < at.x + what.width &&
             c.y < at.y + what.height;
    }
  };

  bool occupied(Cell c) const {
    if (truth_.blocked(c)) return true;
    return std::any_of(movers_.begin(), movers_.end(), [&](const Mover& m) { return m.covers(c); });
  }
  /// Is the centre of one cell nearer than the radius to the square of another?
  bool near(Cell held, Cell square) const {
    const double dx = std::max(0.0, std::abs(held.x - square.x) - 0.5);
    const double dy = std::max(0.0, std::abs(held.y - square.y) - 0.5);
    return std::sqrt(dx * dx + dy * dy) < radius_ - 1e-9;
  }
  bool touches(Cell robot) const {
    const int reach = static_cast<int>(radius_) + 1;
    for (int y = robot.y - reach; y <= robot.y + reach; ++y) {
      for (int x = robot.x - reach; x <= robot.x + reach; ++x) {
        // A point does not touch what its cell only borders on.
        if (radius_ == 0 ? Cell{x, y} == robot && occupied({x, y})
                         : near(robot, {x, y}) && occupied({x, y})) {
          return true;
        }
      }
    }
    return false;
  }
  bool touches_any(Cell from, Cell to) const {
    if (radius_ == 0) return touches(to) || touches({from.x, to.y}) || touches({to.x, from.y});
    // Between the centres, sixteen points a move, the middle among them.
    for (int part = 1; part <= 16; ++part) {
      const Point p{from.x + 0.5 + (to.x - from.x) * part / 16.0,
                    from.y + 0.5 + (to.y - from.y) * part / 16.0};
      const int reach = static_cast<int>(radius_) + 2;
      for (int y = to.y - reach; y <= to.y + reach; ++y) {
        for (int x = to.x - reach; x <= to.x + reach; ++x) {
          const double dx = std::max({0.0, x - p.x, p.x - x - 1});
          const double dy = std::max({0.0, y - p.y, p.y - y - 1});
          if (std::sqrt(dx * dx + dy * dy) < radius_ - 1e-9 && occupied({x, y})) return true;
        }
      }
    }
    return false;
  }
  bool would_hit(const Mover& m, Cell at, Cell before, Cell here) const {
    for (int y = at.y; y < at.y + m.what.height; ++y) {
      for (int x = at.x; x < at.x + m.what.width; ++x) {
        if (held({x, y}, before, here)) return true;
      }
    }
    return false;
  }
  bool held(Cell cell, Cell before, Cell here) const {
    for (const Cell c : {before, here, Cell{before.x, here.y}, Cell{here.x, before.y}}) {
      if (radius_ == 0 ? c == cell : near(c, cell)) return true;
    }
    return false;
  }

  void advance(std::int64_t tick, Cell before, Cell here) {
    std::vector<Cell> waiting;
    waiting.swap(deferred_);
    for (const Cell c : waiting) set(c, true, before, here);
    while (next_ < changes_.size() && changes_[next_].tick <= tick) {
      const Change& change = changes_[next_++];
      for (int y = 0; y < change.part.height; ++y) {
        for (int x = 0; x < change.part.width; ++x) {
          set({change.part.x + x, change.part.y + y}, change.blocked, before, here);
        }
      }
    }
    for (Mover& m : movers_) {
      if (m.what.tick > tick) continue;
      if (!m.there) {
        m.there = !would_hit(m, m.at, before, here);
      } else {
        move(m, before, here);
      }
    }
  }
  void set(Cell c, bool blocked, Cell before, Cell here) {
    deferred_.erase(std::remove(deferred_.begin(), deferred_.end(), c), deferred_.end());
    if (truth_.blocked(c) == blocked) return;
    if (blocked && held(c, before, here)) {
      deferred_.push_back(c);
    } else {
      truth_.set_blocked(c, blocked);
    }
  }
  void move(Mover& m, Cell before, Cell here) {
    const auto& track = m.what.track;
    const bool points_differ =
        std::any_of(track.begin(), track.end(), [&](Cell c) { return c != track[0]; });
    if (m.what.speed == 0 || !points_differ) return;
    m.owed += m.what.speed;
    while (m.owed >= 1) {
      while (m.at == track[m.towards]) {
        if (m.towards == 0) m.direction = 1;
        if (m.towards + 1 == track.size()) m.direction = -1;
        m.towards = static_cast<std::size_t>(static_cast<int>(m.towards) + m.direction);
      }
      Cell to = m.at;
      to.x += track[m.towards].x > to.x ? 1 : track[m.towards].x < to.x ? -1 : 0;
      to.y += track[m.towards].y > to.y ? 1 : track[m.towards].y < to.y ? -1 : 0;
      if (would_hit(m, to, before, here)) {
        m.owed = 0;
        return;
      }
      m.at = to;
      m.owed -= 1;
    }
  }
  /// Has an obstacle come to where the robot was, that was where the robot is now?
  bool swapped(const std::vector<Mover>& was, Cell before, Cell here) const {
    if (before == here) return false;
    for (std::size_t i = 0; i < movers_.size(); ++i) {
      if (was[i].covers(here) && movers_[i].covers(before)) return true;
    }
    return false;
  }

  Grid truth_;
  double radius_;
  std::vector<Change> changes_;
  std::size_t next_ = 0;
  std::vector<Mover> movers_;
  std::vector<Cell> deferred_;
};

}  // namespace lasius
