#include "core/tour/order/combs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

namespace lasius::tour {

namespace {

constexpr double kExcess = 0.85;  // of 1: what legs that leave a handle may lack, and still exceed
constexpr double kGrownExcess = 0.8;           // of handles that grow, the least of each
constexpr std::array kTight{1.0, 0.95, 0.85};  // shares that make a set of two; 1: none
constexpr std::array kParts{0.02, 0.05, 0.1, 0.15, 0.2, 0.3, 0.4};
constexpr double kGrownPart = 0.1;
constexpr std::size_t kFewestTeeth = 3, kMostGrown = 15;

int root_of(std::vector<int>& parent, int v) {
  while (parent[v] != v) v = parent[v] = parent[parent[v]];
  return v;
}

bool in_part(double share, double part) { return share > part && share < 1 - part; }
double lack_of(double share) { return std::min(share, 1 - share); }
double turned_by(double share) { return std::abs(1 - 2 * share); }

// The teeth that exceed most; none where they do not.
std::vector<std::pair<int, int>> teeth_of(const std::vector<SharedLeg>& leaving) {
  std::vector<std::pair<int, int>> teeth;
  double lack = 0, least = 1;
  const SharedLeg* turned = nullptr;  // to make them odd: in, or out
  for (const SharedLeg& leg : leaving) {
    lack += lack_of(leg.share);
    if (turned_by(leg.share) < least) least = turned_by(leg.share), turned = &leg;
    if (leg.share > 0.5) teeth.emplace_back(leg.a, leg.b);
  }
  if (teeth.size() % 2 == 0 && turned != nullptr) {
    lack += least;
    const std::pair<int, int> one{turned->a, turned->b};
    if (turned->share > 0.5)
      std::erase(teeth, one);
    else
      teeth.push_back(one);
  }
  if (lack > kExcess || teeth.size() < kFewestTeeth || teeth.size() % 2 == 0) teeth.clear();
  return teeth;
}

class Finder {
 public:
  Finder(int stops, std::span<const SharedLeg> legs, Poller& poller)
      : near_(stops), stops_of_(stops), in_(stops, 0), joined_(stops, 0), poller_(poller) {
    for (int v = 0; v < stops; ++v) stops_of_[v] = {v};
    for (const auto& [a, b, share] : legs) near_[a][b] = near_[b][a] = std::min(share, 1.0);
  }

  std::vector<Comb> run() {
    for (const double tight : kTight) {
      if (tight < 1) shrink(tight);
      for (const double part : kParts) join(part);
      for (int set = 0; set < size() && !poller_.stopped(); ++set)
        if (!near_[set].empty()) grow(set);
    }
    return std::move(found_);
  }

 private:
  int size() const { return static_cast<int>(near_.size()); }
  bool stop_after(std::size_t looks) {
    return poller_.stop_after(static_cast<std::int64_t>(looks));
  }

  // Makes one set of any two whose legs take nearly all and that have a neighbour in common: of
  // others nothing new would come.
  void shrink(double tight) {
    const auto partner = [&](int set) {
      for (const auto& [other, share] : near_[set])
        if (share >= tight)
          for (const auto& [common, rest] : near_[other])
            if (near_[set].contains(common)) return other;
      return -1;
    };
    for (bool again = true; again;) {
      again = false;
      for (int set = 0; set < size() && !stop_after(near_[set].size()); ++set)
        for (int other = partner(set); other >= 0; other = partner(set)) {
          unite(set, other);
          again = true;
        }
    }
  }
  void unite(int set, int other) {
    for (const auto& [to, share] : near_[other]) {
      near_[to].erase(other);
      if (to != set) near_[set][to] = near_[to][set] = std::min(1.0, near_[set][to] + share);
    }
    near_[other].clear();
    stops_of_[set].insert(stops_of_[set].end(), stops_of_[other].begin(), stops_of_[other].end());
    stops_of_[other].clear();
  }

  // Handles of all sets that legs join which are taken in part.
  void join(double part) {
    std::vector<int> parent(near_.size());
    std::iota(parent.begin(), parent.end(), 0);
    for (int set = 0; set < size() && !stop_after(near_[set].size()); ++set)
      for (const auto& [to, share] : near_[set])
        if (in_part(share, part)) {
          const int a = root_of(parent, set), b = root_of(parent, to);
          parent[std::max(a, b)] = std::min(a, b);
        }
    std::vector<std::vector<int>> handles(near_.size());
    for (int set = 0; set < size(); ++set) handles[root_of(parent, set)].push_back(set);
    for (const std::vector<int>& handle : handles)
      if (!handle.empty()) consider(handle);
  }

  // The handle of which legs lack least while it grows by the set that is joined to it most.
  void grow(int first) {
    std::vector<int> handle{first}, touched{first};
    std::size_t chosen = 0;
    double lack = 0, least = kGrownExcess;
    int teeth = 0;
    for (int now = first; now >= 0;) {
      in_[now] = 1;
      for (const auto& [to, share] : near_[now]) {
        lack += in_[to] ? -lack_of(share) : lack_of(share);
        if (share > 0.5) teeth += in_[to] ? -1 : 1;
        if (in_[to] || !in_part(share, kGrownPart)) continue;
        joined_[to] += share;
        touched.push_back(to);
      }
      if (handle.size() > 1 && lack < least) {
        const double all = teeth % 2 != 0 ? lack : lack + least_turn(handle);
        if (all < least) least = all, chosen = handle.size();
      }
      now = -1;
      if (handle.size() == kMostGrown) break;
      for (const int v : touched)
        if (!in_[v] &&
            (now < 0 || joined_[v] > joined_[now] || (joined_[v] == joined_[now] && v < now)))
          now = v;
      if (now >= 0) handle.push_back(now);
    }
    for (const int v : handle) in_[v] = 0;
    for (const int v : touched) joined_[v] = 0;
    stop_after(handle.size() * touched.size());
    handle.resize(chosen);
    if (chosen > 0) consider(handle);
  }
  double least_turn(const std::vector<int>& handle) const {
    double least = 1;
    for (const int v : handle)
      for (const auto& [to, share] : near_[v])
        if (!in_[to]) least = std::min(least, turned_by(share));
    return least;
  }

  void consider(const std::vector<int>& handle) {
    if (stop_after(handle.size() + found_.size())) return;
    std::vector<SharedLeg> leaving;
    for (const int v : handle) in_[v] = 1;
    for (const int v : handle)
      for (const auto& [to, share] : near_[v])
        if (!in_[to]) leaving.push_back({v, to, share});
    for (const int v : handle) in_[v] = 0;
    Comb comb;
    std::vector<int> all;  // of the teeth
    for (const auto& [a, b] : teeth_of(leaving)) {
      std::vector<int>& tooth = comb.teeth.emplace_back(stops_of_[a]);
      tooth.insert(tooth.end(), stops_of_[b].begin(), stops_of_[b].end());
      std::sort(tooth.begin(), tooth.end());
      all.insert(all.end(), tooth.begin(), tooth.end());
    }
    if (comb.teeth.empty()) return;
    for (const int v : handle)
      comb.handle.insert(comb.handle.end(), stops_of_[v].begin(), stops_of_[v].end());
    if (comb.handle.size() < 3) return;
    std::sort(all.begin(), all.end());
    const bool apart = std::adjacent_find(all.begin(), all.end()) == all.end();
    if (!apart && all.size() > 2 * comb.teeth.size()) return;
    std::sort(comb.handle.begin(), comb.handle.end());
    std::sort(comb.teeth.begin(), comb.teeth.end());
    if (std::find(found_.begin(), found_.end(), comb) == found_.end())
      found_.push_back(std::move(comb));
  }

  std::vector<std::map<int, double>> near_;  // of sets: what legs between two take
  std::vector<std::vector<int>> stops_of_;   // none: part of another
  std::vector<char> in_;                     // the handle
  std::vector<double> joined_;               // to the handle
  Poller& poller_;
  std::vector<Comb> found_;
};

}  // namespace

std::int64_t Comb::most() const {
  auto sum = static_cast<std::int64_t>(handle.size());
  for (const std::vector<int>& tooth : teeth) sum += static_cast<std::int64_t>(tooth.size()) - 1;
  return sum - static_cast<std::int64_t>(teeth.size() + 1) / 2;
}

std::vector<Comb> combs_of(int stops, std::span<const SharedLeg> legs, Poller& poller) {
  return Finder(stops, legs, poller).run();
}

}  // namespace lasius::tour
