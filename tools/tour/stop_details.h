// What a file says of stops beside their coordinates.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "tools/options/options.h"

namespace lasius::tool {

struct StopDetails {
  std::string name = {};
  std::vector<std::string> after = {};  ///< names
  std::optional<int> load = {};
  std::string group = {};
  std::optional<double> yaw = {};
};

/// Puts the details of all stops, in their order, into the lists of `stops`; names become indices.
/// `fail` throws what is wrong with a stop, and how to mend it: a name that none or several have,
/// stops in a circle.
void add_details(const std::vector<StopDetails>& details, TourStops& stops,
                 const std::function<void(int stop, const std::string& problem,
                                          const std::string& remedy)>& fail);

}  // namespace lasius::tool
