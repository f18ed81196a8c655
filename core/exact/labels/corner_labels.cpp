#include "core/exact/labels/corner_labels.h"

#include <algorithm>
#include <chrono>
#include <limits>
#include <utility>

#include "core/base/held_bytes.h"
#include "core/base/parallel.h"
#include "core/base/thread_team.h"
#include "core/exact/labels/tile_views.h"

namespace lasius::exact {
namespace {

// Places in the arrays are 32 bits wide.
constexpr std::int64_t kMostPlaces = std::numeric_limits<std::uint32_t>::max();
constexpr std::int64_t kEntryBytes = sizeof(std::uint32_t) + sizeof(double) + sizeof(LabelStep);

// A corner's entries in the order in which queries read them: by side, by turn, by rank.
class LabelSorter {
 public:
  LabelSorter(const TautGraph& graph, const Hubs& hubs, int threads)
      : graph_(graph), hubs_(hubs), threads_(threads), places_(hubs.entries.size()) {}

  void run(LabelArrays& to) {
    const auto count = static_cast<std::uint32_t>(hubs_.entries.size());
    to.corners.resize(count);
    std::vector<std::uint32_t> first(count + std::size_t{1});
    for (std::uint32_t v = 0; v < count; ++v)
      first[v + 1] = first[v] + static_cast<std::uint32_t>(hubs_.entries[v].size());
    to.hubs.resize(first.back());
    to.lengths.resize(first.back());
    to.steps.resize(first.back());
    std::vector<std::vector<LabelGroup>> groups(count);
    const int blocks = static_cast<int>((count + kBlock - 1) / kBlock);
    const auto each = [&](const auto& body) {
      parallel_for(blocks, threads_, [&](int block, int) {
        const auto begin = static_cast<std::uint32_t>(block) * kBlock;
        for (std::uint32_t v = begin; v < std::min(begin + kBlock, count); ++v) body(v);
      });
    };
    each([&](std::uint32_t v) { sort(v, first[v], groups[v], to); });
    each([&](std::uint32_t v) { join(v, to); });
    std::uint32_t before = 0;
    for (std::uint32_t v = 0; v < count; ++v) {
      LabelCorner& corner = to.corners[v];
      corner.first += before;
      corner.middle += before;
      corner.last += before;
      before = corner.last;
      to.groups.insert(to.groups.end(), groups[v].begin(), groups[v].end());
    }
    to.groups.push_back({0, 0, first.back()});
    for (std::uint32_t rank = 0; rank < count; ++rank) to.corners[hubs_.by_rank[rank]].rank = rank;
  }

 private:
  static constexpr std::uint32_t kBlock = 64;  // corners

  void sort(std::uint32_t v, std::uint32_t first, std::vector<LabelGroup>& groups,
            LabelArrays& to) {
    // Entries by the place of their edge; few corners have many edges that lead to a hub.
    const auto& label = hubs_.entries[v];
    struct Place {
      std::uint32_t next, number;
    };
    std::vector<Place> by_next;
    for (std::uint32_t i = 0; i < label.size(); ++i) by_next.push_back({label[i].next, i});
    std::ranges::sort(by_next, [](const Place& a, const Place& b) {
      return a.next != b.next ? a.next < b.next : a.number < b.number;
    });
    places_[v].resize(label.size());
    LabelCorner& corner = to.corners[v];
    std::uint32_t at = first;
    for (const Side side : {kColumn, kLine}) {
      if (side == kLine) corner.middle = static_cast<std::uint32_t>(groups.size());
      for (const GraphEdge& edge : graph_.edges(v, side)) {
        auto from = std::ranges::lower_bound(by_next, edge.to(), {}, &Place::next);
        if (from == by_next.end() || from->next != edge.to()) continue;
        groups.push_back({edge.x, edge.y, at});
        for (; from != by_next.end() && from->next == edge.to(); ++from, ++at) {
          to.hubs[at] = label[from->number].hub;
          to.lengths[at] = label[from->number].length;
          places_[v][from->number] = at;
        }
      }
    }
    corner.last = static_cast<std::uint32_t>(groups.size());
  }

  // Finds the next corner's entry for the same hub.
  void join(std::uint32_t v, LabelArrays& to) {
    const auto& label = hubs_.entries[v];
    for (std::size_t i = 0; i < label.size(); ++i) {
      const HubEntry& entry = label[i];
      LabelStep step{entry.next, CornerLabels::kArrived};
      if (entry.next != hubs_.by_rank[entry.hub]) {
        const auto& there = hubs_.entries[entry.next];
        const auto same = std::ranges::lower_bound(there, entry.hub, {}, &HubEntry::hub);
        step.entry = places_[entry.next][static_cast<std::size_t>(same - there.begin())];
      }
      to.steps[places_[v][i]] = step;
    }
  }

  const TautGraph& graph_;
  const Hubs& hubs_;
  const int threads_;
  std::vector<std::vector<std::uint32_t>> places_;  // of entries, by corner and rank
};

}  // namespace

std::shared_ptr<const CornerLabels> CornerLabels::make(const Grid& grid, const CornerGraph& graph,
                                                       const PrepareOptions& options,
                                                       Preparation::Labels& report,
                                                       std::vector<std::uint32_t> order) {
  using State = Preparation::State;
  const auto begin = std::chrono::steady_clock::now();
  const int threads = thread_count(options.threads);
  auto labels = std::make_shared<CornerLabels>();
  const auto end = [&](State state) {
    report.state = state;
    report.seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  };
  const auto run = [&] {
    const TautGraph taut(graph);
    Hubs hubs;
    const std::int64_t most = std::min({std::int64_t{options.max_label_entries} * graph.size(),
                                        options.max_label_bytes / kEntryBytes, kMostPlaces});
    const HubsEnd found = find_hubs(taut, most, threads, options.stop, hubs, std::move(order));
    if (found != HubsEnd::ready) return found;
    LabelSorter(taut, hubs, threads).run(labels->arrays_);
    hubs = {};
    labels->tiles_across_ = static_cast<std::size_t>((grid.width() + 7) >> kTileBits);
    const std::int64_t most_bytes =
        std::min(options.max_label_bytes, kMostPlaces * std::int64_t{sizeof(TileCorner)});
    return list_tiles(grid, taut, most_bytes, threads, options.stop, labels->arrays_);
  };
  HubsEnd how = HubsEnd::stopped;
  ThreadTeam::lead(threads, [&] { how = run(); });
  if (how == HubsEnd::ready && options.stop.poll() != StopCondition::Cause::none)
    how = HubsEnd::stopped;
  if (how != HubsEnd::ready) {
    end(how == HubsEnd::stopped ? State::stopped : State::too_large);
    return nullptr;
  }
  report.entries = labels->entry_count();
  report.bytes = labels->bytes();
  end(State::ready);
  return labels;
}

std::vector<std::uint32_t> CornerLabels::order_of(const CornerGraph& own,
                                                  const CornerGraph& graph) const {
  constexpr std::size_t kShareOfNew = 50;                      // at most one in so many
  std::vector<std::pair<std::uint32_t, std::uint32_t>> order;  // rank and number
  std::size_t more = 0;
  for (std::uint32_t v = 0; v < graph.size(); ++v) {
    const int x = graph.corner(v).x(), y = graph.corner(v).y();
    const bool known = own.has_corner(x, y);
    more += !known;
    order.emplace_back(known ? arrays_.corners[own.index(x, y)].rank : own.size(), v);
  }
  if (more * kShareOfNew > graph.size()) return {};
  std::ranges::sort(order);
  std::vector<std::uint32_t> corners;
  corners.reserve(order.size());
  for (const auto& [rank, number] : order) corners.push_back(number);
  return corners;
}

std::int64_t CornerLabels::bytes() const noexcept {
  const LabelArrays& a = arrays_;
  return held_bytes(a.corners, a.groups, a.hubs, a.lengths, a.steps, a.tiles, a.live, a.dead,
                    a.masks);
}

}  // namespace lasius::exact
