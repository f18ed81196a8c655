// Writes small random maps with weights, and proofs of what crossing them costs: as a program that
// uses the library does. make_proofs FOLDER COUNT makes FOLDER/I.map, I.pfm (weights less 1),
// I.proof.json.
#include <cstdint>
#include <fstream>
#include <random>
#include <string>
#include <vector>

#include "lasius/cost_planner.h"
#include "lasius/io_json.h"
#include "lasius/map_io.h"

using namespace lasius;

int main(int, char** arguments) {
  std::mt19937 random(7);
  const auto below = [&](int n) { return static_cast<int>(random() % n); };
  for (int made = 0; made < std::stoi(arguments[2]);) {
    const int width = 8 + below(30), height = 8 + below(30);
    Grid grid(width, height);
    std::vector<float> added;
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) {
        if (below(5) == 0) grid.set_blocked({x, y}, true);
        added.push_back(0.125F * static_cast<float>(below(40)));
      }
    }
    CostField costs(width, height);
    costs.add(std::vector<double>(added.begin(), added.end()));
    costs.add(grid, Inflation{.radius = 4, .scaling = 0.5, .weight = 3});
    const CostPlanner planner(Planner(Grid(grid)), costs);
    const CostResult result =
        planner.plan({.start = {0, 0}, .goal = {width - 1, height - 1}}, {.proof = true});
    if (!result.proof) continue;
    const std::string name = std::string(arguments[1]) + "/" + std::to_string(made++);
    write_map(grid, name + ".map");
    std::ofstream(name + ".proof.json") << proof_to_json(*result.proof);
    std::ofstream layer(name + ".pfm", std::ios::binary);
    layer << "Pf\n" << width << " " << height << "\n-1.0\n";
    for (int y = height; y-- > 0;)
      layer.write(reinterpret_cast<const char*>(added.data() + y * width),
                  static_cast<std::streamsize>(sizeof(float)) * width);
  }
}
