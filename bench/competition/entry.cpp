#include "bench/competition/entry.h"

#include <filesystem>
#include <memory>
#include <utility>

#include "lasius/plan/planner.h"

namespace {

struct ReadyMap {
  lasius::Planner planner;
  lasius::Params params;
  lasius::Workspace workspace;
};

lasius::Planner planner_of(const std::vector<bool>& bits, int width, int height) {
  lasius::Grid grid(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      grid.set_blocked({x, y}, !bits[static_cast<std::size_t>(y) * width + x]);
  return lasius::Planner(std::move(grid));
}

}  // namespace

void PreprocessMap(const std::vector<bool>& bits, int width, int height,
                   const std::string& filename) {
  const auto prepared = planner_of(bits, width, height).prepared({.threads = 1, .labels = true});
  if (prepared.preparation().state == lasius::Preparation::State::ready)
    prepared.save_preparation(filename);
}

void* PrepareForSearch(const std::vector<bool>& bits, int width, int height,
                       const std::string& filename) {
  lasius::Planner planner = planner_of(bits, width, height);
  if (std::filesystem::exists(filename)) planner = planner.load_preparation(filename);
  static std::vector<std::unique_ptr<ReadyMap>> kept;
  kept.push_back(std::make_unique<ReadyMap>(ReadyMap{std::move(planner), {}, {}}));
  return kept.back().get();
}

bool GetPath(void* data, xyLoc s, xyLoc g, std::vector<xyLoc>& path) {
  path.clear();
  auto& map = *static_cast<ReadyMap*>(data);
  const lasius::Point from{s.x, s.y}, to{g.x, g.y};
  if (from == to) return true;
  const auto result = map.planner.plan({.start_point = from, .goal_point = to}, map.params,
                                       {.workspace = &map.workspace});
  for (const lasius::Point p : result.path) path.push_back({p.x, p.y});
  return true;
}

std::string GetName() { return "lasius"; }
