#include "lasius/drive/navigator.h"

#include <utility>

#include "core/base/held_bytes.h"
#include "core/base/invalid_parameter.h"
#include "core/drive/navigator_impl.h"
#include "core/grid/cell_distance.h"

namespace lasius {

Pilot::~Pilot() = default;
double Pilot::move_cost(Cell from, Cell to) { return distance(from, to); }

Navigator::Navigator(Grid map, Cell goal, const NavigatorOptions& options)
    : impl_(std::make_unique<Impl>(std::move(map), goal, options)) {}
Navigator::~Navigator() = default;
Navigator::Navigator(Navigator&&) noexcept = default;
Navigator& Navigator::operator=(Navigator&&) noexcept = default;

void Navigator::observe(const Rectangle& part, bool blocked) {
  if (blocked) impl_->doubts.saw_walls(impl_->map.map(), part);
  impl_->map.set(part, blocked, impl_->on_change, impl_->on_edit);
}
void Navigator::observe(std::span<const Cell> cells, bool blocked) {
  if (blocked) impl_->doubts.saw_walls(impl_->map.map(), cells);
  impl_->map.set(cells, blocked, impl_->on_change, impl_->on_edit);
}
void Navigator::set_costs(const Rectangle& part, std::span<const double> weights) {
  if (!impl_->costs)
    refuse("a Navigator without costs is told of some", "give it NavigatorOptions::costs");
  impl_->costs->set(part, weights);
  impl_->holds = false;
}
double Navigator::move_cost(Cell from, Cell to) {
  return impl_->costs ? impl_->costs->move_cost(from, to) : Pilot::move_cost(from, to);
}
const Way& Navigator::step(Cell robot, const StopCondition& stop) {
  return impl_->step(robot, stop);
}

Cell Navigator::goal() const noexcept { return impl_->goal; }
void Navigator::set_goal(Cell goal) {
  if (goal == impl_->goal) return;
  impl_->goal = goal;
  impl_->holds = false;
  if (impl_->colony) impl_->send_colony(goal);
}
void Navigator::forget() {
  impl_->holds = false;
  if (impl_->colony) impl_->colony->forget();
}

const Grid& Navigator::map() const noexcept { return impl_->map.map(); }
const Grid& Navigator::passable() const noexcept { return impl_->map.passable(); }
bool Navigator::connected(Cell a, Cell b) { return *impl_->connected(a, b, impl_->corners, {}); }
double Navigator::radius() const noexcept { return impl_->options.radius; }
void Navigator::begin_drive() { impl_->doubts = Doubts(0); }
double Navigator::goal_tolerance() const noexcept { return impl_->options.goal_tolerance; }
Corners Navigator::corners() const noexcept { return impl_->corners; }
Preparation Navigator::preparation() const noexcept { return impl_->preparation; }
std::int64_t Navigator::bytes() const noexcept {
  const Impl& i = *impl_;
  return i.map.bytes() + i.four.bytes() + (i.eight ? i.eight->bytes() : 0) + i.preparation.bytes +
         i.preparation.labels.bytes + (i.stale ? i.stale->bytes() : 0) +
         (i.space() != nullptr ? i.space()->bytes() : 0) + i.workspace.bytes() + i.doubts.bytes() +
         i.string.bytes() +
         held_bytes(i.way.path, i.way.walk, i.way.curve, i.edited, i.walk, i.unprepared) +
         (i.costs ? i.costs->bytes() : 0);
}

}  // namespace lasius
