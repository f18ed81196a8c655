#include <algorithm>
#include <set>

#include "core/tour/order/window_search.h"

namespace lasius::tour {

namespace {

constexpr std::size_t kMostStates = 20'000;

// Stops put one behind another, and taken back where the capacity lets none follow.
class Builder {
 public:
  /// `tries`: choices are taken back; else the nearest that may follow is taken, whatever comes.
  Builder(const Costs& costs, const Ends& ends, const PartialOrder& given, bool tries)
      : costs_(costs),
        ends_(ends),
        given_(given),
        tries_(tries),
        done_(costs.size(), 0),
        waits_(costs.size()) {
    for (int v = 0; v < costs.size(); ++v) waits_[v] = static_cast<int>(given.previous(v).size());
  }

  FirstOrder build() {
    FirstOrder first;
    if (ends_.start >= 0) {
      if (waits_[ends_.start] > 0 || !fits(ends_.start)) return {{}, true};
      put(ends_.start);
    }
    first.proven = !extend();
    if (order_.size() == done_.size()) first = {std::move(order_), false};
    if (given_up_) first.proven = false;
    return first;
  }

 private:
  struct Choice {
    std::vector<int> stops;  // that may follow, the best last
    std::size_t length;      // of the order when it was made
  };

  bool fits(int stop) const { return carried_ + given_.load(stop) <= given_.capacity(); }
  void put(int stop) {
    order_.push_back(stop);
    done_[stop] = 1;
    carried_ += given_.load(stop);
    for (const int v : given_.next(stop)) --waits_[v];
  }
  void take_back(std::size_t length) {
    for (; order_.size() > length; order_.pop_back()) {
      const int stop = order_.back();
      done_[stop] = 0;
      carried_ -= given_.load(stop);
      for (const int v : given_.next(stop)) ++waits_[v];
    }
  }

  // Whether an order of all stops was found.
  bool extend() {
    std::vector<Choice> choices;
    std::set<std::vector<bool>> seen;
    for (;;) {
      if (order_.size() == done_.size()) return true;
      std::vector<int> stops = following();
      if (stops.size() > 1) {
        if (seen.size() == kMostStates) return !(given_up_ = true);
        if (!seen.insert({done_.begin(), done_.end()}).second) stops.clear();
      }
      if (stops.size() > 1)
        choices.push_back({std::move(stops), order_.size()});
      else if (stops.size() == 1) {
        put(stops.front());
        continue;
      }
      while (!choices.empty() && choices.back().stops.empty()) choices.pop_back();
      if (choices.empty()) return false;
      take_back(choices.back().length);
      const int stop = choices.back().stops.back();
      choices.back().stops.pop_back();
      put(stop);
    }
  }

  // What may follow, the nearest last. A stop that takes nothing up is never wrong: then that
  // alone.
  std::vector<int> following() const {
    std::vector<std::pair<Cost, int>> near;
    bool light = false;
    const int last = order_.empty() ? -1 : order_.back();
    for (int v = 0; v < costs_.size(); ++v) {
      if (done_[v] || waits_[v] > 0 || !fits(v)) continue;
      if (v == ends_.goal && order_.size() + 1 < done_.size()) continue;
      const bool takes_none = tries_ && given_.load(v) <= 0;
      if (takes_none && !light) near.clear();
      light = light || takes_none;
      if (takes_none == light) near.emplace_back(last < 0 ? v : costs_.lower(last, v), v);
    }
    if (light || !tries_) {
      if (!near.empty()) near = {*std::min_element(near.begin(), near.end())};
    } else {
      std::sort(near.rbegin(), near.rend());
    }
    std::vector<int> stops;
    stops.reserve(near.size());
    for (const auto& [cost, stop] : near) stops.push_back(stop);
    return stops;
  }

  const Costs& costs_;
  const Ends& ends_;
  const PartialOrder& given_;
  bool tries_;
  std::vector<char> done_;
  std::vector<int> waits_, order_;
  std::int64_t carried_ = 0;
  bool given_up_ = false;
};

}  // namespace

FirstOrder first_order(const Costs& costs, const Ends& ends, const PartialOrder& given) {
  FirstOrder near = Builder(costs, ends, given, false).build();
  return near.order.empty() && given.limited() ? Builder(costs, ends, given, true).build() : near;
}

}  // namespace lasius::tour
