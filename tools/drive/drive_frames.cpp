#include "tools/drive/drive_frames.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "tools/bitmap/path_clearance.h"
#include "tools/report/packed.h"
#include "tools/report/report.h"
#include "tools/report/thinned.h"

namespace lasius::tool {
namespace {

std::vector<float> way_of(const DriveTick& tick) {
  std::vector<float> way;
  if (tick.way == nullptr) return way;
  const auto& path = tick.way->path;
  for (const Point p : thinned(path, path.size() / DriveFrames::kMostWayVertices + 1)) {
    way.push_back(static_cast<float>(p.x));
    way.push_back(static_cast<float>(p.y));
  }
  return way;
}

int pixels_along(const Grid& map, int side) {
  const double shrink =
      std::min(1.0, 1.0 * DriveFrames::kMostPixels / std::max(map.width(), map.height()));
  return std::max(1, static_cast<int>(shrink * side));
}

double rounded(double clearance) { return std::round(1000 * clearance) / 1000; }

}  // namespace

DriveFrames::DriveFrames(const Grid& map, double radius)
    : width_(pixels_along(map, map.width())),
      height_(pixels_along(map, map.height())),
      ground_(map, width_, height_),
      radius_(radius) {}

void DriveFrames::observe(const DriveTick& tick, const DriveRecorder& recorder) {
  const double middle =
      distance_to_blocked(*tick.world, centre(tick.robot), kMostClearance + radius_);
  last_clearance_ = rounded(std::clamp(middle - radius_, 0.0, 1.0 * kMostClearance));
  if (clearances_.wants(tick.tick)) clearances_.add(last_clearance_);
  if (!frames_.wants(tick.tick) && !tick.arrived) return;
  frames_.add({.tick = tick.tick,
               .robot = tick.robot,
               .obstacles = tick.obstacles,
               .way = way_of(tick),
               .codes = ground_.codes(tick, recorder).values});
}

Json DriveFrames::json() const {
  if (frames_.all().empty()) return nullptr;
  KeyFrames<Frame> kept = frames_;
  std::string codes, ways;
  for (;;) {
    std::vector<std::vector<std::uint8_t>> pixels;
    std::vector<float> points;
    for (const Frame& frame : kept.all()) {
      pixels.push_back(frame.codes);
      points.insert(points.end(), frame.way.begin(), frame.way.end());
    }
    codes = packed_frames(pixels);
    ways = packed(points);
    if (codes.size() + ways.size() <= kMostPackedBytes || kept.all().size() <= 2) break;
    kept.thin();
  }
  Json json = {{"width", width_}, {"height", height_}, {"codes", codes}, {"ways", ways}};
  json["clearances"] = {{"step", clearances_.stride()},
                        {"values", clearances_.all()},
                        {"last", last_clearance_},
                        {"most", kMostClearance}};
  for (const char* name : {"ticks", "robots", "obstacles", "way_lengths"})
    json[name] = Json::array();
  for (const Frame& frame : kept.all()) {
    json["ticks"].push_back(frame.tick);
    json["robots"].push_back({frame.robot.x, frame.robot.y});
    Json boxes = Json::array();
    for (const Rectangle& r : frame.obstacles) boxes.push_back({r.x, r.y, r.width, r.height});
    json["obstacles"].push_back(std::move(boxes));
    json["way_lengths"].push_back(frame.way.size() / 2);
  }
  return json;
}

}  // namespace lasius::tool
