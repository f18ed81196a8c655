#include "core/polygon/lengths.h"

#include <algorithm>
#include <atomic>
#include <queue>
#include <utility>

#include "core/base/parallel.h"
#include "core/base/special_values.h"
#include "core/polygon/sight.h"

namespace lasius::polygon {
namespace {

struct Leg {
  int to;
  double length;
};

// What a corner or a place sees: corners that paths bend around, and places.
struct View {
  std::vector<Leg> corners, places;
};

class LengthsAmong {
 public:
  LengthsAmong(const Regions& regions, std::span<const Place> places)
      : regions_(regions), places_(places), placed_(regions.regions().size()) {
    for (std::size_t i = 0; i < places.size(); ++i)
      for (const int r : places[i].regions) placed_[r].push_back(static_cast<int>(i));
  }

  // False if stopped.
  bool look(int threads, const StopCondition& stop) {
    const int corners = static_cast<int>(regions_.space().corners.size());
    views_.resize(corners + places_.size());
    std::vector<Sight> sights(threads, Sight(regions_));
    std::atomic<bool> stopped{false};
    parallel_for(static_cast<int>(views_.size()), threads, [&](int node, int thread) {
      if (stopped || (node < corners && !regions_.reflex(node))) return;
      Poller poller(stop);
      const bool placed = node >= corners;
      const Place* const own = placed ? &places_[node - corners] : nullptr;
      const Point from = placed ? own->given : point(node);
      View& view = views_[node];
      sights[thread].from(
          placed ? own->at : regions_.at(node), placed ? own->regions : regions_.around(node),
          poller,
          [&](int corner) {
            if (regions_.reflex(corner))
              view.corners.push_back({corner, distance(from, point(corner))});
          },
          [&](int region, const auto& seen) {
            for (const int i : placed_[region])
              if (seen(places_[i].at)) view.places.push_back({i, distance(from, places_[i].given)});
          });
      for (auto* legs : {&view.corners, &view.places}) keep_once(*legs);
      if (poller.stopped() || stop.poll() != StopCondition::Cause::none) stopped = true;
    });
    return !stopped;
  }

  // To the places behind a place.
  void row(int from, std::span<double> lengths) const {
    const int corners = static_cast<int>(regions_.space().corners.size());
    std::vector<double> way(corners, kInfinity);
    using Waiting = std::pair<double, int>;
    std::priority_queue<Waiting, std::vector<Waiting>, std::greater<>> queue;
    const auto go_on = [&](const View& view, double before) {
      for (const Leg& leg : view.places)
        lengths[leg.to] = std::min(lengths[leg.to], before + leg.length);
      for (const Leg& leg : view.corners)
        if (before + leg.length < way[leg.to]) {
          way[leg.to] = before + leg.length;
          queue.emplace(way[leg.to], leg.to);
        }
    };
    std::fill(lengths.begin(), lengths.end(), kInfinity);
    go_on(views_[corners + from], 0);
    while (!queue.empty()) {
      const auto [length, corner] = queue.top();
      queue.pop();
      if (length == way[corner]) go_on(views_[corner], length);
    }
  }

 private:
  Point point(int corner) const { return regions_.space().point(regions_.at(corner)); }
  static void keep_once(std::vector<Leg>& legs) {
    std::sort(legs.begin(), legs.end(), [](const Leg& a, const Leg& b) { return a.to < b.to; });
    legs.erase(std::unique(legs.begin(), legs.end(),
                           [](const Leg& a, const Leg& b) { return a.to == b.to; }),
               legs.end());
  }

  const Regions& regions_;
  std::span<const Place> places_;
  std::vector<std::vector<int>> placed_;  // by region
  std::vector<View> views_;               // of corners, then of places
};

}  // namespace

std::optional<std::vector<double>> lengths_among(const Regions& regions,
                                                 std::span<const Place> places, int threads,
                                                 const StopCondition& stop) {
  threads = thread_count(threads);
  const int n = static_cast<int>(places.size());
  LengthsAmong among(regions, places);
  if (!among.look(threads, stop)) return std::nullopt;
  std::vector<double> lengths(places.size() * places.size(), 0);
  std::atomic<bool> stopped{false};
  parallel_for(n, threads, [&](int from, int) {
    if (stop.poll() != StopCondition::Cause::none) stopped = true;
    if (!stopped) among.row(from, std::span(lengths).subspan(from * places.size(), places.size()));
  });
  if (stopped) return std::nullopt;
  for (int a = 0; a < n; ++a) {
    lengths[a * places.size() + a] = 0;
    for (int b = 0; b < a; ++b) lengths[a * places.size() + b] = lengths[b * places.size() + a];
  }
  return lengths;
}

}  // namespace lasius::polygon
