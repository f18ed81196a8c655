#include "tools/tour/stop_details.h"

#include <algorithm>
#include <map>
#include <string_view>

#include "core/base/did_you_mean.h"
#include "core/tour/order/partial_order.h"

namespace lasius::tool {

void add_details(const std::vector<StopDetails>& details, TourStops& stops,
                 const std::function<void(int stop, const std::string& problem,
                                          const std::string& remedy)>& fail) {
  const int n = static_cast<int>(details.size());
  const auto any = [&](const auto& has) { return std::ranges::any_of(details, has); };
  if (any([](const StopDetails& one) { return !one.name.empty(); }))
    for (const StopDetails& one : details) stops.names.push_back(one.name);
  if (any([](const StopDetails& one) { return one.load.has_value(); }))
    for (const StopDetails& one : details) stops.loads.push_back(one.load.value_or(0));
  if (any([](const StopDetails& one) { return !one.group.empty(); }))
    for (const StopDetails& one : details) stops.groups.push_back(one.group);
  if (any([](const StopDetails& one) { return one.yaw.has_value(); }))
    for (const StopDetails& one : details) stops.yaws.push_back(one.yaw);
  if (!any([](const StopDetails& one) { return !one.after.empty(); })) return;
  std::map<std::string_view, std::vector<int>> named;
  std::vector<std::string_view> known;
  for (int i = 0; i < n; ++i)
    if (!details[i].name.empty()) named[details[i].name].push_back(i);
  for (const auto& [name, of] : named) known.push_back(name);
  std::vector<tour::Before> relation;
  stops.after.resize(details.size());
  for (int i = 0; i < n; ++i)
    for (const std::string& name : details[i].after) {
      const std::vector<int> of = named.contains(name) ? named[name] : std::vector<int>();
      if (of.empty())
        fail(i, "\"after\": no stop is named \"" + name + "\"",
             known.empty() ? "give each stop its name" : did_you_mean(name, known));
      if (of.size() > 1)
        fail(i,
             "\"after\": stops " + std::to_string(of[0]) + " and " + std::to_string(of[1]) +
                 " are both named \"" + name + "\"",
             "give each its own name");
      stops.after[i].push_back(of.front());
      relation.emplace_back(of.front(), i);
    }
  const std::vector<int> circle = tour::circle_of(n, relation);
  if (circle.empty()) return;
  const auto shown = [&](int stop) {
    return details[stop].name.empty() ? "stop " + std::to_string(stop) : details[stop].name;
  };
  std::string text = "\"after\" is a circle: ";
  for (const int stop : circle) text += shown(stop) + " before ";
  fail(circle.front(), text + shown(circle.front()), "leave one of these out");
}

}  // namespace lasius::tool
