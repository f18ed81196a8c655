#include "bench/pose_pairs.h"

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <random>

#include "lasius/base/error.h"

namespace lasius::bench {

using vehicle::Pose;

PosePairs read_pose_pairs(const std::filesystem::path& file) {
  std::ifstream in(file);
  PosePairs pairs;
  for (Pose a, b; in >> a.x >> a.y >> a.yaw >> b.x >> b.y >> b.yaw;) pairs.emplace_back(a, b);
  if (pairs.empty() || !in.eof())
    throw Error(ErrorCode::file_broken, {.file = file.string()}, "a line is not x y yaw x y yaw",
                "give six numbers a line");
  return pairs;
}

std::vector<Point> nodes_of_graph(const std::filesystem::path& file, const WorldFrame& frame,
                                  int height) {
  std::vector<Point> nodes;
  try {
    std::ifstream in(file);
    const auto graph = nlohmann::json::parse(in);
    for (const auto& feature : graph.at("features")) {
      const auto& geometry = feature.at("geometry");
      if (geometry.at("type") != "Point") continue;
      const auto& at = geometry.at("coordinates");
      nodes.push_back(frame.to_cells({at.at(0).get<double>(), at.at(1).get<double>()}, height));
    }
  } catch (const nlohmann::json::exception& error) {
    throw Error(ErrorCode::file_broken, {.file = file.string()}, error.what(),
                "give a route graph in GeoJSON");
  }
  return nodes;
}

PosePairs pairs_of_graph(const std::filesystem::path& file, const WorldFrame& frame, int height) {
  const std::vector<Point> nodes = nodes_of_graph(file, frame, height);
  std::vector<Pose> poses;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const Point from = nodes[i], to = nodes[(i + 1) % nodes.size()];
    poses.push_back({from.x, from.y, std::atan2(to.y - from.y, to.x - from.x)});
  }
  PosePairs pairs;
  for (const Pose& from : poses)
    for (const Pose& to : poses)
      if (&from != &to) pairs.emplace_back(from, to);
  return pairs;
}

PosePairs random_pose_pairs(const vehicle::Space& space, const Grid& grid, int count) {
  std::mt19937_64 random(1);
  const auto unit = [&] { return static_cast<double>(random() >> 11) * 0x1p-53; };
  const auto draw = [&] {
    Pose pose;
    for (int tries = 0; tries < 100000; ++tries) {
      pose = {grid.width() * unit(), grid.height() * unit(), 6.28 * unit()};
      if (space.free(pose)) break;
    }
    return pose;
  };
  PosePairs pairs;
  for (int i = 0; i < count; ++i) {
    const Pose start = draw();
    pairs.emplace_back(start, draw());
  }
  return pairs;
}

}  // namespace lasius::bench
