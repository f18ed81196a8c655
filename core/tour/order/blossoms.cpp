#include "core/tour/order/blossoms.h"

#include <algorithm>
#include <numeric>

namespace lasius::tour {

namespace {

constexpr double kExcess = 0.85;  // of 1: what legs that leave a handle may lack, and still exceed
constexpr std::size_t kFewestTeeth = 3;

int root_of(std::vector<int>& parent, int v) {
  while (parent[v] != v) v = parent[v] = parent[parent[v]];
  return v;
}

// The teeth that exceed most; none where they do not.
std::vector<std::pair<int, int>> teeth_of(const std::vector<SharedLeg>& leaving) {
  std::vector<std::pair<int, int>> teeth;
  double lack = 0, least = 1;
  const SharedLeg* turned = nullptr;  // to make them odd: in, or out
  for (const SharedLeg& leg : leaving) {
    lack += std::min(leg.share, 1 - leg.share);
    const double more = std::abs(1 - 2 * leg.share);
    if (more < least) least = more, turned = &leg;
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

}  // namespace

std::vector<Blossom> blossoms_of(int stops, std::span<const SharedLeg> legs) {
  std::vector<Blossom> found;
  std::vector<int> parent(stops);
  for (const double part : {0.05, 0.15, 0.3}) {
    std::iota(parent.begin(), parent.end(), 0);
    for (const auto& [a, b, share] : legs)
      if (share > part && share < 1 - part) {
        const int ra = root_of(parent, a), rb = root_of(parent, b);
        parent[std::max(ra, rb)] = std::min(ra, rb);
      }
    std::vector<std::vector<int>> handles(stops);
    std::vector<std::vector<SharedLeg>> leaving(stops);
    for (int v = 0; v < stops; ++v) handles[root_of(parent, v)].push_back(v);
    for (const auto& [a, b, share] : legs) {
      const int ra = root_of(parent, a), rb = root_of(parent, b);
      if (ra == rb) continue;
      leaving[ra].push_back({a, b, share});
      leaving[rb].push_back({b, a, share});
    }
    for (int root = 0; root < stops; ++root) {
      if (handles[root].size() < 3) continue;
      Blossom one{handles[root], teeth_of(leaving[root])};
      if (!one.teeth.empty() && std::find(found.begin(), found.end(), one) == found.end())
        found.push_back(std::move(one));
    }
  }
  return found;
}

}  // namespace lasius::tour
