// What results tell of costs, and whether they are still those.
#include "lasius/base/error.h"
#include "tools/bitmap/cost_layers.h"
#include "tools/record/recorded.h"

namespace lasius::tool {

void record_costs(const LoadedCosts& costs, Json& findings, Json& parameters) {
  Json& layers = findings["layers"] = Json::array();
  for (std::size_t i = 0; i < costs.hashes.size(); ++i)
    layers.push_back({{"file", costs.asked.layers[i].file},
                      {"hash", hash_text(costs.hashes[i])},
                      {"factor", number(costs.asked.layers[i].factor)}});
  if (const auto& inflation = costs.inflation)
    parameters["inflation"] = {number(inflation->radius), number(inflation->scaling),
                               number(inflation->weight)};
  if (costs.asked.eight_moves) parameters["moves"] = 8;
}

void check_layers(const LoadedCosts& costs, const Json& result) {
  for (std::size_t i = 0; i < costs.hashes.size(); ++i) {
    const auto hash = hash_text(costs.hashes[i]);
    const auto made_on = recorded<std::string>(result["layers"][i], "hash");
    if (hash != made_on)
      throw Error(ErrorCode::file_broken, {.file = costs.asked.layers[i].file},
                  "has hash " + hash + ", the result was made on " + made_on,
                  "put the file of that time in its place");
  }
}

}  // namespace lasius::tool
