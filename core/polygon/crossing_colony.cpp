#include <algorithm>
#include <cmath>
#include <span>

#include "core/base/poller.h"
#include "core/base/special_values.h"
#include "core/loop/trail_rules.h"
#include "core/polygon/crossing_search.h"
#include "kernels/base/power.h"
#include "kernels/base/proportional.h"
#include "kernels/base/random_stream.h"

namespace lasius::polygon {
namespace {

constexpr int kMostTabulated = 64;  // values, for the table of distances

/// A value of a gate.
struct Node {
  int gate;
  int value;
};

/// Choices of one ant, a value a gate.
struct Tour {
  std::span<const int> choices;
  double length = kNaN;
};

/// Pheromone of every value of every gate, with the weights that it gives.
class CrossingTrail {
 public:
  CrossingTrail(int gates, int values, double tau0)
      : values_(values),
        tau_(static_cast<std::size_t>(gates) * values, tau0),
        visibility_(tau_.size(), 1),
        weight_(tau_) {}

  double tau(Node n) const { return tau_[index(n)]; }
  void set_tau(Node n, double value) {
    const std::size_t i = index(n);
    tau_[i] = value;
    weight_[i] = value * visibility_[i];
  }
  void set_visibility(int gate, std::span<const double> visibility) {
    for (int k = 0; k < values_; ++k) {
      const std::size_t i = index({gate, k});
      visibility_[i] = visibility[k];
      weight_[i] = tau_[i] * visibility[k];
    }
  }
  std::span<const double> weights(int gate) const {
    return std::span(weight_).subspan(static_cast<std::size_t>(gate) * values_, values_);
  }

 private:
  std::size_t index(Node n) const { return static_cast<std::size_t>(n.gate) * values_ + n.value; }

  int values_;
  std::vector<double> tau_, visibility_, weight_;
};

/// What the rules of a trail ask of tours.
struct Tours {
  template <class Visit>
  void along(const Tour& tour, const Visit& visit) const {
    for (int g = 0; g < static_cast<int>(tour.choices.size()); ++g) visit(Node{g, tour.choices[g]});
  }
};

/// rho = 1 - persistence as it was meant: 1 - 0.9 is 0.1, not 0.09999999999999998.
double share_lost(double persistence) { return std::round((1 - persistence) * 1e15) / 1e15; }

class CrossingColony final : public CrossingSearch {
 public:
  CrossingColony(const Route& route, const Crossing& start, const Params& parameters,
                 const RunControl& control)
      : CrossingSearch(route, start, parameters, control),
        rules_{.persistence = parameters.persistence,
               .deposit = 1,
               .local_evaporation = share_lost(parameters.persistence)},
        gates_(static_cast<int>(route.gates.size())),
        tau0_(parameters.initial_pheromone > 0 ? parameters.initial_pheromone
                                               : 1 / (gates_ * start.length)),
        trail_(gates_, parameters.values, tau0_),
        choices_(static_cast<std::size_t>(parameters.ants) * gates_),
        lengths_(parameters.ants, kNaN) {
    for (const Gate& gate : route.gates) {
      for (int k = 0; k < parameters.values; ++k) points_.push_back(gate.at(value(k)));
    }
    tabulate_legs();
    tabulate_visibility();
    for (int g = 0; g < gates_; ++g) see_around(g, start.values[g]);
  }

  StopCondition::Cause send_ants(int q) override {
    std::ranges::fill(lengths_, kNaN);
    streams_.clear();
    for (int a = 0; a < parameters_.ants; ++a) {
      streams_.emplace_back(parameters_.seed, static_cast<std::uint32_t>(a),
                            static_cast<std::uint32_t>(q));
    }
    Poller poller(control_.stop);  // counts weights
    for (int g = 0; g < gates_; ++g) {
      for (int a = 0; a < parameters_.ants; ++a) {
        const int k =
            kernels::proportional_choice(trail_.weights(g), parameters_.greedy, streams_[a].next());
        choice(a, g) = std::max(k, 0);  // below 0 once all weights have underflowed
        trail_rules::pass(trail_, rules_, tau0_, Node{g, choice(a, g)});
        if (poller.stop_after(parameters_.values)) return poller.cause();
      }
    }
    for (int a = 0; a < parameters_.ants && !poller.stop_after(gates_); ++a)
      lengths_[a] = measured(a);
    return poller.cause();
  }

  void offer() override {
    iteration_best_ = -1;
    for (int a = 0; a < parameters_.ants; ++a) {
      if (std::isnan(lengths_[a])) continue;
      if (iteration_best_ < 0 || lengths_[a] < lengths_[iteration_best_]) iteration_best_ = a;
    }
    if (iteration_best_ < 0) return;
    const double length = lengths_[iteration_best_];
    best_length_ = std::min(best_length_, length);
    if (!best_choices_.empty() && !(length < best_tour_length_)) return;
    best_tour_length_ = length;
    const auto found = tour(iteration_best_).choices;
    best_choices_.assign(found.begin(), found.end());
    for (int g = 0; g < gates_; ++g) see_around(g, best_choices_[g]);
  }

  void update_trail(int) override {
    const Tour best = parameters_.global_best == GlobalBest::iteration
                          ? tour(iteration_best_)
                          : Tour{best_choices_, best_tour_length_};
    trail_rules::colony_system(trail_, rules_, Tours{}, best);
    agreed_ = all_agree() ? agreed_ + 1 : 0;
  }

  int ants() const override { return parameters_.ants; }
  double tour_length(int ant) const override { return lengths_[ant]; }

  bool settled() override {
    return CrossingSearch::settled() ||
           (parameters_.agreement > 0 && agreed_ >= parameters_.agreement);
  }

 private:
  Crossing best() const override {
    if (best_choices_.empty() || start_.length <= best_tour_length_) return start_;
    std::vector<double> values;
    for (const int k : best_choices_) values.push_back(value(k));
    return cross_at(route_, std::move(values));
  }

  double value(int k) const { return static_cast<double>(k) / (parameters_.values - 1); }
  int& choice(int ant, int gate) { return choices_[static_cast<std::size_t>(ant) * gates_ + gate]; }
  Tour tour(int ant) const {
    return {std::span(choices_).subspan(static_cast<std::size_t>(ant) * gates_, gates_),
            lengths_[ant]};
  }
  bool all_agree() const {
    for (int a = 1; a < parameters_.ants; ++a)
      if (!std::ranges::equal(tour(a).choices, tour(0).choices)) return false;
    return true;
  }
  Point point(int gate, int value) const {
    return points_[static_cast<std::size_t>(gate) * parameters_.values + value];
  }
  /// Distances between the values of neighbouring gates, where the table stays small.
  void tabulate_legs() {
    if (parameters_.values > kMostTabulated) return;
    for (int g = 0; g + 1 < gates_; ++g) {
      for (int j = 0; j < parameters_.values; ++j) {
        for (int k = 0; k < parameters_.values; ++k)
          legs_.push_back(distance(point(g, j), point(g + 1, k)));
      }
    }
  }
  double leg(int gate, int from, int to) const {
    if (legs_.empty()) return distance(point(gate, from), point(gate + 1, to));
    const auto values = static_cast<std::size_t>(parameters_.values);
    return legs_[(gate * values + from) * values + to];
  }
  double measured(int ant) const {
    const auto choices = tour(ant).choices;
    double length = distance(route_.start.given, point(0, choices.front()));
    for (int g = 0; g + 1 < gates_; ++g) length += leg(g, choices[g], choices[g + 1]);
    return length + distance(point(gates_ - 1, choices.back()), route_.goal.given);
  }

  static double visibility(double apart, double beta) {
    return kernels::power((1.1 - apart) / 1.1, beta);
  }

  /// eta^beta = ((1.1 - |h - h*|) / 1.1)^beta by the difference of two values' numbers.
  void tabulate_visibility() {
    for (int k = 0; k < parameters_.values; ++k)
      apart_.push_back(visibility(value(k), parameters_.beta));
    row_.resize(parameters_.values);
  }
  void see_around(int gate, int best) {
    for (int k = 0; k < parameters_.values; ++k) row_[k] = apart_[std::abs(k - best)];
    trail_.set_visibility(gate, row_);
  }
  void see_around(int gate, double best) {
    for (int k = 0; k < parameters_.values; ++k)
      row_[k] = visibility(std::abs(value(k) - best), parameters_.beta);
    trail_.set_visibility(gate, row_);
  }

  TrailParams rules_;
  int gates_;
  double tau0_;
  std::vector<Point> points_;  // of every value of every gate
  std::vector<double> legs_;
  CrossingTrail trail_;
  std::vector<kernels::RandomStream> streams_;
  std::vector<int> choices_;  // by ant, then gate
  std::vector<double> lengths_;
  std::vector<double> apart_, row_;
  int iteration_best_ = -1;
  int agreed_ = 0;  // iterations in a row in which all ants went the same way
  std::vector<int> best_choices_;
  double best_tour_length_ = kNaN;
};

}  // namespace

CrossingRun run_crossing_colony(const Route& route, const Crossing& start, const Params& parameters,
                                const RunControl& control) {
  return CrossingColony(route, start, parameters, control).run();
}

}  // namespace lasius::polygon
