#include <algorithm>

#include "core/base/poller.h"
#include "core/base/special_values.h"
#include "core/polygon/crossing_search.h"
#include "kernels/base/random_stream.h"

namespace lasius::polygon {
namespace {

struct Chromosome {
  std::vector<double> genes;
  double length = kNaN;
};

/// Random numbers of one child; those of generation 0 make the first population.
class Draws : public kernels::RandomStream {
 public:
  Draws(std::uint64_t seed, int child, int generation)
      : RandomStream(seed, static_cast<std::uint32_t>(child),
                     static_cast<std::uint32_t>(generation)) {}
  /// Uniform in [0, 1].
  double real() { return next() / (0x1p32 - 1); }
};

class CrossingGa final : public CrossingSearch {
 public:
  CrossingGa(const Route& route, const Crossing& start, const Params& parameters,
             const RunControl& control)
      : CrossingSearch(route, start, parameters, control),
        population_(parameters.population),
        children_(parameters.population) {}

  StopCondition::Cause send_ants(int q) override {
    for (Chromosome& child : children_) child.length = kNaN;
    Poller poller(control_.stop, Poller::kSteps);
    for (int i = 0; i < parameters_.population; ++i) {
      Draws draws(parameters_.seed, i, q);
      if (q == 0)
        newcomer(children_[i], draws);
      else
        breed(children_[i], draws);
      children_[i].length = measured(children_[i].genes);
      if (poller.stop_after(static_cast<std::int64_t>(route_.gates.size()))) return poller.cause();
    }
    return StopCondition::Cause::none;
  }

  void offer() override {
    for (const Chromosome& child : children_) {
      if (!(child.length > 0) || child.length >= best_.length) continue;
      best_ = child;
      best_length_ = std::min(best_length_, child.length);
    }
  }

  /// Elitist selection: of parents and children the fittest live on.
  void update_trail(int q) override {
    if (q == 0) {
      population_ = children_;
    } else {
      for (const Chromosome& child : children_) population_.push_back(child);
    }
    std::ranges::stable_sort(population_,
                             [](const auto& a, const auto& b) { return a.length < b.length; });
    population_.resize(children_.size());
  }

  int ants() const override { return parameters_.population; }
  double tour_length(int ant) const override { return children_[ant].length; }

 private:
  Crossing best() const override {
    const bool none = best_.genes.empty() || start_.length <= best_.length;
    return none ? start_ : cross_at(route_, best_.genes);
  }

  void newcomer(Chromosome& child, Draws& draws) const {
    child.genes.resize(route_.gates.size());
    for (double& gene : child.genes) gene = draws.real();
  }

  const Chromosome& parent(Draws& draws) const {
    const int a = draws.below(parameters_.population), b = draws.below(parameters_.population);
    return population_[population_[b].length < population_[a].length ? b : a];
  }

  void breed(Chromosome& child, Draws& draws) const {
    const Chromosome& one = parent(draws);
    const Chromosome& other = parent(draws);
    child.genes = one.genes;
    if (draws.chance(parameters_.crossover)) {
      for (std::size_t g = 0; g < child.genes.size(); ++g)
        child.genes[g] += parameters_.blend * (other.genes[g] - one.genes[g]);
    }
    for (double& gene : child.genes)
      if (draws.chance(parameters_.mutation)) gene = draws.real();
  }

  double measured(const std::vector<double>& genes) const {
    Point at = route_.start.given;
    double length = 0;
    for (std::size_t g = 0; g < genes.size(); ++g) {
      const Point next = route_.gates[g].at(genes[g]);
      length += distance(at, next);
      at = next;
    }
    return length + distance(at, route_.goal.given);
  }

  std::vector<Chromosome> population_, children_;
  Chromosome best_{{}, kInfinity};
};

}  // namespace

CrossingRun run_crossing_ga(const Route& route, const Crossing& start, const Params& parameters,
                            const RunControl& control) {
  return CrossingGa(route, start, parameters, control).run();
}

}  // namespace lasius::polygon
