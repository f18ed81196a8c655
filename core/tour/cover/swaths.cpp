#include "core/tour/cover/swaths.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "core/base/parallel.h"
#include "core/tour/cover/sweep_cells.h"
#include "core/tour/tour_steps.h"

namespace lasius::tour {

namespace {

constexpr double kRounding = 1e-6;     // of a count of swaths
constexpr double kDearness = 6;        // of what is left, against a swath: to go there and back
constexpr double kNearEnds = 2;        // widths between ends that a straight way is looked for
constexpr double kShareOfPlans = 0.7;  // of the time to a deadline; the rest is for what is joined

std::vector<Point> both_ends(const std::vector<Swath>& swaths) {
  std::vector<Point> ends;
  ends.reserve(2 * swaths.size());
  for (const Swath& swath : swaths) ends.insert(ends.end(), {swath.from, swath.to});
  return ends;
}

}  // namespace

double ways_between(const std::vector<Swath>& swaths, bool open) {
  struct End {
    Point at;
    std::size_t swath;
  };
  if (swaths.size() < 2) return 0;
  std::vector<End> ends;
  for (std::size_t i = 0; i < swaths.size(); ++i) {
    ends.push_back({swaths[i].from, i});
    ends.push_back({swaths[i].to, i});
  }
  std::sort(ends.begin(), ends.end(), [](const End& a, const End& b) {
    if (a.at.x != b.at.x) return a.at.x < b.at.x;
    return a.at.y != b.at.y ? a.at.y < b.at.y : a.swath < b.swath;
  });
  double sum = 0, longest[2] = {0, 0};
  for (std::size_t i = 0; i < ends.size(); ++i) {
    double nearest = std::numeric_limits<double>::infinity();
    const auto look = [&](const End& other) {
      if (std::abs(other.at.x - ends[i].at.x) >= nearest) return false;
      if (other.swath != ends[i].swath) nearest = std::min(nearest, distance(other.at, ends[i].at));
      return true;
    };
    for (std::size_t j = i; j-- > 0 && look(ends[j]);) {
    }
    for (std::size_t j = i + 1; j < ends.size() && look(ends[j]); ++j) {
    }
    sum += nearest;
    longest[1] = std::max(longest[1], std::min(longest[0], nearest));
    longest[0] = std::max(longest[0], nearest);
  }
  return std::max(0.0, open ? sum - longest[0] - longest[1] : sum) / 2;
}

double Swath::length() const noexcept { return distance(from, to); }

void SwathCounts::add(const Swath& swath, int by) {
  ground_.each_row_near(swath.from, swath.to, [&](std::int64_t first, std::int64_t last) {
    for (std::int64_t i = first; i <= last; ++i)
      counts_[i] = static_cast<std::uint16_t>(std::min(counts_[i] + by, 0xffff));
  });
}

std::int64_t SwathCounts::covered(int at_least) const noexcept {
  std::int64_t sum = 0;
  for (std::int64_t i = 0; i < ground_.samples(); ++i)
    sum += ground_.wanted(i) && counts_[i] >= at_least;
  return sum;
}

std::int64_t SwathCounts::gain(const Swath& swath) const {
  std::int64_t sum = 0;
  ground_.each_row_near(swath.from, swath.to, [&](std::int64_t first, std::int64_t last) {
    for (std::int64_t i = first; i <= last; ++i) sum += open(i);
  });
  return sum;
}

bool SwathMaker::reached(const Swath& swath) const {
  return planner_.clear_at(swath.to) && planner_.joined_at(*ground_.place(), swath.from);
}

void SwathMaker::add_line(const Heading& heading, double c, std::vector<Swath>& swaths) const {
  std::vector<Stretch> places;
  lines_.on_line(heading, c, places);
  for (const Stretch& place : places)
    swaths.push_back({heading.at(place.from, c), heading.at(place.to, c)});
}

std::vector<Swath> SwathMaker::fitted(const Heading& heading, Poller& poller) const {
  const double beside = std::min(lines_.radius(), width_ / 2);
  std::vector<Swath> swaths;
  std::vector<Stretch> places;
  for (const SweepCell& cell : sweep_cells(lines_, heading, width_, poller)) {
    const double from = cell.from - (cell.wall_before ? beside : 0);
    const double to = cell.to + (cell.wall_behind ? beside : 0);
    const int count = std::max(1, static_cast<int>(std::ceil((to - from) / width_ - kRounding)));
    const double drawn_in = std::min(ToolLines::kDrawnIn, (cell.to - cell.from) / 2);
    std::size_t slice = 0;
    for (int i = 0; i < count; ++i) {
      const double c = std::clamp(from + (i + 0.5) * ((to - from) / count), cell.from + drawn_in,
                                  cell.to - drawn_in);
      while (slice + 1 < cell.slices.size() &&
             std::abs(cell.slices[slice + 1].c - c) <= std::abs(cell.slices[slice].c - c))
        ++slice;
      // The stretch of this line that goes on where the slice beside it is.
      const Stretch& beside_it = cell.slices[slice].stretch;
      lines_.on_line(heading, c, places);
      if (poller.stop_after(lines_.work_of_line(places))) return swaths;
      double most = 0;
      Stretch chosen;
      for (const Stretch& place : places) {
        const double shared =
            std::min(place.to, beside_it.to) - std::max(place.from, beside_it.from);
        if (shared > most) most = shared, chosen = place;
      }
      if (most > 0) swaths.push_back({heading.at(chosen.from, c), heading.at(chosen.to, c)});
    }
  }
  return swaths;
}

std::vector<Swath> SwathMaker::anywhere(const Heading& heading, Poller& poller) const {
  Stretch extent = lines_.extent(heading);
  // Where the tool has any place.
  std::vector<Stretch> places;
  const double step = std::min(1.0, width_ / 8);
  const auto none = [&](double c) {
    lines_.on_line(heading, c, places);
    return !poller.stop_after(lines_.work_of_line(places)) && places.empty();
  };
  while (extent.length() > step && none(extent.from + step / 2)) extent.from += step;
  while (extent.length() > step && none(extent.to - step / 2)) extent.to -= step;
  const double beside = std::min(lines_.radius(), width_ / 2);
  extent = {extent.from - beside, extent.to + beside};
  const int count = std::max(1, static_cast<int>(std::ceil(extent.length() / width_ - kRounding)));
  std::vector<Swath> swaths;
  for (int i = 0; i < count && !poller.stop_after(lines_.work_of_line({})); ++i)
    add_line(heading, extent.from + (i + 0.5) * (extent.length() / count), swaths);
  return swaths;
}

std::optional<SwathPlan> SwathMaker::plan(const Heading& heading, Laid laid,
                                          const StopCondition& laying,
                                          const StopCondition& stop) const {
  Poller lays(laying), fills(stop);
  const auto stopped = [&] { return laying.poll() != StopCondition::Cause::none; };
  if (stopped()) return std::nullopt;
  SwathPlan plan{.heading = heading,
                 .swaths = laid == Laid::fitted ? fitted(heading, lays) : anywhere(heading, lays)};
  if (stopped()) return std::nullopt;
  for (Swath& swath : plan.swaths) swath = {lines_.settled(swath.from), lines_.settled(swath.to)};
  std::erase_if(plan.swaths,
                [&](const Swath& swath) { return lays.stop_after(64) || !reached(swath); });
  SwathCounts counts(ground_);
  for (const Swath& swath : plan.swaths) {
    if (lays.stop_after(ground_.samples_near(swath.length()))) break;
    counts.add(swath);
  }
  if (stopped()) return std::nullopt;
  fill_gaps(
      lines_, ground_, heading, [&](const Swath& swath) { return reached(swath); }, counts,
      plan.swaths, fills);
  if (stopped()) return std::nullopt;
  cut_back(lines_, ground_, counts, plan.swaths, fills);
  if (stopped()) return std::nullopt;
  plan.cut = fills.stopped();
  plan.estimate = static_cast<double>(plan.swaths.size());
  if (plan.too_many() && lines_.radius() == 0) return plan;  // of a disc some may be out of reach
  const std::vector<Point> stops = both_ends(plan.swaths);
  plan.links = near_ends(clear_, lines_, stops);
  if (plan.too_many()) return plan;
  plan.estimate = chained(static_cast<int>(plan.swaths.size()), stops, plan.links).length +
                  kDearness * ground_.area(ground_.wanted_samples() - counts.covered()) / width_;
  for (const Swath& swath : plan.swaths) plan.estimate += swath.length();
  return plan;
}

std::optional<SwathPlan> SwathMaker::best(int threads, const StopCondition& first,
                                          const StopCondition& stop) const {
  const std::vector<Heading>& all = headings();
  const StopCondition until = earlier(stop, kShareOfPlans);
  std::vector<std::optional<SwathPlan>> plans(2 * all.size());
  parallel_for(static_cast<int>(plans.size()), thread_count(threads), [&](int i, int) {
    const Laid laid = i % 2 == 0 ? Laid::fitted : Laid::anywhere;
    plans[i] = plan(all[i / 2], laid, i == 0 ? first : until, until);
  });
  std::optional<SwathPlan>* least = nullptr;
  const auto rank = [](const SwathPlan& plan) { return std::pair(plan.too_many(), plan.estimate); };
  for (auto& plan : plans)
    if (plan && !plan->swaths.empty() && (least == nullptr || rank(*plan) < rank(**least)))
      least = &plan;
  if (least == nullptr) least = &plans.front();
  if (!*least) return std::nullopt;
  (*least)->cut = std::ranges::any_of(plans, [](const auto& plan) { return !plan || plan->cut; });
  if (lines_.radius() > 0) drop_apart(**least, threads, stop);
  return std::move(*least);
}

// To each swath the first of those that clear cells join, or straight ways between ends near to
// each other. Soon done, and what a stopped search can keep: so nothing stops it.
std::vector<int> SwathMaker::joined_swaths(const SwathPlan& plan) const {
  const std::vector<Swath>& swaths = plan.swaths;
  std::vector<int> first(swaths.size());
  std::iota(first.begin(), first.end(), 0);
  const auto root = [&](int i) {
    while (first[i] != i) i = first[i] = first[first[i]];
    return i;
  };
  const auto join = [&](int p, int q) { first[std::max(p, q)] = std::min(p, q); };
  for (const EndLink& link : plan.links) join(root(link.a / 2), root(link.b / 2));
  std::vector<std::pair<Point, int>> ends;
  for (int i = 0; i < static_cast<int>(swaths.size()); ++i)
    for (const Point end : {swaths[i].from, swaths[i].to}) ends.emplace_back(end, i);
  std::stable_sort(ends.begin(), ends.end(),
                   [](const auto& a, const auto& b) { return a.first.x < b.first.x; });
  for (std::size_t i = 0; i < ends.size(); ++i)
    for (std::size_t j = i + 1; j < ends.size(); ++j) {
      const auto& [a, one] = ends[i];
      const auto& [b, other] = ends[j];
      if (b.x - a.x > kNearEnds * width_) break;
      if (distance(a, b) > kNearEnds * width_) continue;
      const int p = root(one), q = root(other);
      if (p == q || !lines_.straight_between(a, b)) continue;
      join(p, q);
    }
  for (int i = 0; i < static_cast<int>(first.size()); ++i) first[i] = root(i);
  return first;
}

// Of a disc: what it cannot come to from a place of the region. Swaths that are joined are looked
// at once, the most of these first; once stopped none that was not is kept, but for those that are
// looked at whatever stops: until some are kept, the token one of them.
void SwathMaker::drop_apart(SwathPlan& plan, int threads, const StopCondition& stop) const {
  std::vector<Swath>& swaths = plan.swaths;
  const std::vector<int> first = joined_swaths(plan);
  std::vector<std::pair<int, int>> parts(swaths.size(), {0, 0});  // swaths, less; the first
  for (std::size_t i = 0; i < swaths.size(); ++i)
    parts[i].second = static_cast<int>(i), --parts[first[i]].first;
  std::sort(parts.begin(), parts.end());
  std::vector<char> kept(swaths.size(), 0), cut(swaths.size(), 0);
  const auto reached_from_place = [&](int i, const StopCondition& until) {
    return reaches(planner_, *ground_.place(), swaths[i].from, until);
  };
  std::size_t looked = 0;
  bool any = false;
  while (looked < parts.size() && parts[looked].first < 0 && !any &&
         (looked == 0 || !stop.token.stop_requested())) {
    any = reached_from_place(parts[looked].second, {});
    kept[parts[looked++].second] = any;
  }
  parallel_for(static_cast<int>(parts.size() - looked), thread_count(threads), [&](int k, int) {
    const auto [size, i] = parts[looked + k];
    if (size == 0) return;
    const auto stopped = [&] { return stop.poll() != StopCondition::Cause::none; };
    kept[i] = !stopped() && reached_from_place(i, stop);
    cut[i] = kept[i] == 0 && stopped();
  });
  plan.cut = plan.cut || std::ranges::count(cut, 1) > 0;
  std::size_t left = 0;
  for (std::size_t i = 0; i < swaths.size(); ++i)
    if (kept[first[i]] != 0) swaths[left++] = swaths[i];
  if (left < swaths.size()) plan.links.clear();
  swaths.resize(left);
}

}  // namespace lasius::tour
