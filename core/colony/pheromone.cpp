// A caller's own update acts on the trail by the same steps as the built-in ones.

#include <algorithm>
#include <string>

#include "core/base/number_text.h"
#include "core/colony/stored_pheromone.h"
#include "core/params/parameter_table.h"
#include "kernels/walk/walk.h"

namespace lasius {
namespace {

static_assert(Pheromone::kTileSide == kernels::kTileSide);

std::string entry(const char* list, std::size_t i) {
  return std::string(list) + "[" + std::to_string(i) + "]";
}

/// @throws Error(invalid_parameter) for the first place that is none of `count`.
void check_places(std::span<const TrailPlace> places, std::int64_t count) {
  const auto outside = [count](TrailPlace place) { return place < 0 || place >= count; };
  const auto bad = std::ranges::find_if(places, outside);
  if (bad == places.end()) return;
  throw invalid_parameter(entry("places", static_cast<std::size_t>(bad - places.begin())) + " is " +
                              std::to_string(*bad),
                          "the places of this trail are 0 to " + std::to_string(count - 1));
}

void check_lengths(std::size_t places, std::size_t values) {
  if (places == values) return;
  throw invalid_parameter(
      "there are " + std::to_string(values) + " values for " + std::to_string(places) + " places",
      "give one for each");
}

bool is_tau(double value) noexcept { return value >= 0 && value <= Pheromone::kMost; }

Error no_tau(const std::string& name, double value) {
  return invalid_parameter(name + " is " + number_text(value),
                           "it must be 0 .. " + number_text(Pheromone::kMost));
}

void check(std::span<const TrailPlace> places, std::int64_t count, std::span<const double> values) {
  check_places(places, count);
  check_lengths(places.size(), values.size());
  const auto bad = std::ranges::find_if_not(values, is_tau);
  if (bad != values.end())
    throw no_tau(entry("values", static_cast<std::size_t>(bad - values.begin())), *bad);
}

}  // namespace

Trail Pheromone::trail() const noexcept { return stored_.kind; }
std::int64_t Pheromone::places() const noexcept { return stored_.places(); }

void Pheromone::persist(double persistence) {
  require_parameter(persistence >= 0 && persistence <= 1, "persistence", persistence,
                    "it must be 0 .. 1");
  stored_.field.evaporate(persistence);
}

void Pheromone::add(std::span<const TrailPlace> places, double amount) {
  check_places(places, stored_.places());
  if (!is_tau(amount)) throw no_tau("amount", amount);
  stored_.for_each(places,
                   [&](GridPlace place, std::size_t) { stored_.field.deposit(place, amount); });
}

void Pheromone::add(std::span<const TrailPlace> places, std::span<const double> values) {
  check(places, stored_.places(), values);
  stored_.for_each(
      places, [&](GridPlace place, std::size_t i) { stored_.field.deposit(place, values[i]); });
}

void Pheromone::set(std::span<const TrailPlace> places, std::span<const double> values) {
  check(places, stored_.places(), values);
  stored_.for_each(
      places, [&](GridPlace place, std::size_t i) { stored_.field.set_tau(place, values[i]); });
}

void Pheromone::clamp(double least, double most) {
  if (!is_tau(least)) throw no_tau("least", least);
  if (!(most > 0 && most >= least))
    throw invalid_parameter("most is " + number_text(most) + ", least " + number_text(least),
                            "most must be positive, and not below least");
  stored_.field.bound(least, most);
}

void Pheromone::get(std::span<const TrailPlace> places, std::span<double> values) const {
  check_places(places, stored_.places());
  check_lengths(places.size(), values.size());
  std::ranges::transform(places, values.begin(),
                         [this](TrailPlace place) { return stored_.field.tau(stored_.at(place)); });
}

void Pheromone::check_learned() const {
  if (stored_.learned) return;
  throw invalid_parameter("no cell has learned: the heuristic is another one",
                          "set heuristic to learned and update to learning");
}

void Pheromone::get_learned(std::span<const TrailPlace> cells, std::span<double> values) const {
  check_learned();
  check_places(cells, stored_.cells);
  check_lengths(cells.size(), values.size());
  std::ranges::transform(cells, values.begin(),
                         [this](TrailPlace cell) { return stored_.field.eta(stored_.cell(cell)); });
}

void Pheromone::set_learned(std::span<const TrailPlace> cells, std::span<const double> values) {
  check_learned();
  check(cells, stored_.cells, values);
  for (std::size_t i = 0; i < cells.size(); ++i)
    stored_.field.set_eta(stored_.cell(cells[i]), values[i]);
}

int Pheromone::tiles() const noexcept { return stored_.field.tiles(); }

TrailTile Pheromone::tile(int number) const {
  if (number < 0 || number >= tiles())
    throw invalid_parameter("tile " + std::to_string(number) + " is asked for",
                            "there are " + std::to_string(tiles()) + ", from 0");
  TrailTile tile;
  tile.stored = stored_.field.stored(number, tile.first);
  return tile;
}

double Pheromone::scale() const noexcept { return stored_.field.scale(); }
double Pheromone::untouched() const noexcept { return stored_.field.untouched(); }
double Pheromone::least() const noexcept { return stored_.field.least(); }
double Pheromone::most() const noexcept { return stored_.field.most(); }

}  // namespace lasius
