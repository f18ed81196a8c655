#include "core/vehicle/tour/unjoined.h"

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

namespace lasius::vehicle {

namespace {

constexpr int kSeveral = 3;  // places to which no way was found that make a stop one left out
constexpr int kFew = 20;     // places between all of which there are plans soon

class Ways {
 public:
  Ways(const LegPrices& legs, const TourPlaces& places)
      : legs_(legs), places_(places), n_(static_cast<int>(places.at.size())) {
    for (int place = 0; place < n_; ++place)
      if (!places.left_out.contains(place)) kept_.push_back(place);
    const auto n = static_cast<std::size_t>(n_);
    ways_.resize(n * n);
    for (auto& live : live_) live.assign(n, 0);
    for (const auto& [leg, plan] : legs.plans()) {
      const int from = legs.at(leg.first).place, to = legs.at(leg.second).place;
      if (places.left_out.contains(from) || places.left_out.contains(to)) continue;
      Way& tried = ways_[index(from, to)];
      ++tried.tried;
      if (plan.segments.empty()) continue;
      tried.found = true;
      live_[0][from] = live_[1][to] = 1;
    }
  }

  // One that nothing joins. Legs to places that nothing else is joined to tell nothing.
  Unjoined alone() const {
    Unjoined worst;
    std::size_t most = 0;
    for (const int place : kept_)
      for (const int side : {0, 1}) {
        const bool needed = places_.needs_leg[side][place] != 0;
        const bool neither = side == 0 && places_.needs_leg[1][place] == 0 && live_[1][place] == 0;
        if (live_[side][place] != 0 || !(needed || (neither && places_.end[place] == 0))) continue;
        std::vector<std::pair<int, int>> tried = tried_of(place, side);
        if (tried.empty()) continue;
        if (!needed) {
          const auto back = tried_of(place, 1);
          if (back.empty()) continue;
          tried.insert(tried.end(), back.begin(), back.end());
        }
        const bool replaces_end = worst.place >= 0 && places_.end[worst.place] != 0;
        if (tried.size() < most || (tried.size() == most && !replaces_end)) continue;
        worst = {place, {}};
        most = tried.size();
        for (const auto& way : tried)
          if (worst.untried.empty()) worst.untried = untried(way.first, way.second);
      }
    return worst;
  }

  // The one without ways to most others.
  Unjoined least_joined(const std::vector<PosePair>& order) const {
    std::set<int> meant;
    Unjoined worst;
    for (const PosePair& leg : order) {
      if (legs_.has_way(leg)) continue;
      const int from = legs_.at(leg.first).place, to = legs_.at(leg.second).place;
      meant.insert({from, to});
      const std::vector<PosePair> more = untried(from, to);
      worst.untried.insert(worst.untried.end(), more.begin(), more.end());
    }
    if (meant.empty()) return worst;
    std::set<int> asked = meant;
    if (kept_.size() <= kFew) asked.insert(kept_.begin(), kept_.end());
    // Ways of one pair of poses each say all; of several it counts, too, what the order lacks.
    const bool exact =
        std::ranges::all_of(kept_, [&](int place) { return places_.at[place].size() == 1; });
    std::tuple<bool, int, bool> most;  // no end, ways lost, of a leg without a plan
    for (const int place : asked) {
      const std::tuple lost{places_.end[place] == 0, count_lost(place, worst.untried),
                            !exact && meant.contains(place)};
      if (worst.place >= 0 && lost <= most) continue;
      worst.place = place;
      most = lost;
    }
    std::sort(worst.untried.begin(), worst.untried.end());
    const auto same = std::unique(worst.untried.begin(), worst.untried.end());
    worst.untried.erase(same, worst.untried.end());
    return worst;
  }

 private:
  struct Way {
    std::size_t tried = 0;  // legs
    bool found = false;
  };

  std::size_t index(int from, int to) const {
    return static_cast<std::size_t>(from) * static_cast<std::size_t>(n_) +
           static_cast<std::size_t>(to);
  }
  const Way& way(int from, int to) const { return ways_[index(from, to)]; }

  // Tried ways away from a place (side 0), or to it, if these are enough: all, or several others'.
  std::vector<std::pair<int, int>> tried_of(int place, int side) const {
    std::vector<std::pair<int, int>> tried;
    int joined = 0;  // others that are
    for (const int other : kept_) {
      const auto ends = side == 0 ? std::pair{place, other} : std::pair{other, place};
      if (other == place || way(ends.first, ends.second).tried == 0) continue;
      tried.push_back(ends);
      if (live_[1 - side][other] != 0) ++joined;
    }
    if (joined < kSeveral && tried.size() + 1 < kept_.size()) tried.clear();
    return tried;
  }

  // Ways that are none; adds a leg of each of which that is not known.
  int count_lost(int place, std::vector<PosePair>& legs) const {
    int lost = 0;
    for (const int other : kept_)
      for (const auto& [from, to] : {std::pair{place, other}, std::pair{other, place}}) {
        if (other == place || way(from, to).found) continue;
        const std::vector<PosePair> more = untried(from, to);
        if (more.empty())
          ++lost;
        else
          legs.push_back(more.front());
      }
    return lost;
  }

  std::vector<PosePair> untried(int from, int to) const {
    std::vector<PosePair> legs;
    if (way(from, to).tried == places_.at[from].size() * places_.at[to].size()) return legs;
    for (const int a : places_.at[from])
      for (const int b : places_.at[to])
        if (!legs_.known({a, b})) legs.emplace_back(a, b);
    return legs;
  }

  const LegPrices& legs_;
  const TourPlaces& places_;
  int n_;
  std::vector<int> kept_;
  std::vector<Way> ways_;      // between places
  std::vector<char> live_[2];  // whether a way leads away from a place, to it
};

}  // namespace

Unjoined unjoined(const LegPrices& legs, const TourPlaces& places,
                  const std::vector<PosePair>& order) {
  const Ways ways(legs, places);
  Unjoined worst = ways.alone();
  return worst.place >= 0 ? worst : ways.least_joined(order);
}

int most_lost(const LegPrices& legs, const TourPlaces& places, const std::vector<PosePair>& lost) {
  std::map<int, int> lost_at;
  for (const auto& [leg, plan] : legs.plans())
    if (plan.segments.empty())
      for (const int pose : {leg.first, leg.second}) ++lost_at[legs.at(pose).place];
  int worst = -1, most = 0;
  for (const PosePair& leg : lost)
    for (const int pose : {leg.first, leg.second})
      if (const int place = legs.at(pose).place; places.end[place] == 0 && lost_at[place] > most)
        worst = pose, most = lost_at[place];
  return worst;
}

}  // namespace lasius::vehicle
