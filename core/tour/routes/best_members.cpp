#include "core/tour/routes/best_members.h"

#include <algorithm>
#include <cstdint>
#include <limits>

namespace lasius::tour {

namespace {

using Layers = std::span<const std::vector<int>* const>;

constexpr std::int64_t kNotReached = std::numeric_limits<std::int64_t>::max();

struct Chosen {
  std::int64_t cost = kNotReached;
  std::vector<int> stops;
};

// Of layers begin, begin + 1, ... and round to the one before it.
Chosen chosen_from(const Costs& costs, Layers layers, std::size_t begin, int from, int to) {
  const std::size_t count = layers.size();
  const auto layer = [&](std::size_t i) -> const std::vector<int>& {
    return *layers[(begin + i) % count];
  };
  std::vector<std::vector<int>> prior(count);
  std::vector<std::int64_t> least, next;
  for (const int v : layer(0)) least.push_back(from >= 0 ? costs(from, v) : 0);
  for (std::size_t i = 1; i < count; ++i) {
    next.clear();
    for (const int v : layer(i)) {
      std::int64_t best = kNotReached;
      int by = 0;
      for (std::size_t u = 0; u < least.size(); ++u) {
        const std::int64_t sum = least[u] + costs(layer(i - 1)[u], v);
        if (sum < best) best = sum, by = static_cast<int>(u);
      }
      next.push_back(best);
      prior[i].push_back(by);
    }
    least.swap(next);
  }
  Chosen chosen;
  std::size_t last = 0;
  for (std::size_t u = 0; u < least.size(); ++u) {
    const std::int64_t sum = least[u] + (to >= 0 ? costs(layer(count - 1)[u], to) : 0);
    if (sum < chosen.cost) chosen.cost = sum, last = u;
  }
  chosen.stops.resize(count);
  for (std::size_t i = count; i-- > 0;) {
    chosen.stops[(begin + i) % count] = layer(i)[last];
    if (i > 0) last = static_cast<std::size_t>(prior[i][last]);
  }
  return chosen;
}

}  // namespace

std::vector<int> best_members(const Costs& costs, Layers layers, bool ring, int from, int to) {
  if (layers.empty()) return {};
  if (!ring) return chosen_from(costs, layers, 0, from, to).stops;
  const auto fewest =
      std::min_element(layers.begin(), layers.end(),
                       [](const auto* a, const auto* b) { return a->size() < b->size(); });
  std::vector<const std::vector<int>*> fixed(layers.begin(), layers.end());
  const auto begin = static_cast<std::size_t>(fewest - layers.begin());
  Chosen best;
  for (const int first : **fewest) {
    const std::vector<int> only{first};
    fixed[begin] = &only;
    Chosen chosen = chosen_from(costs, fixed, begin, -1, first);
    if (chosen.cost < best.cost) best = std::move(chosen);
  }
  return best.stops;
}

}  // namespace lasius::tour
