// The options of the commands that plan: as typed, and read.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tools/options/options.h"

namespace lasius::tool {

/// What all of them have, as typed, before values are looked at.
struct SearchText {
  std::string algorithm, preset, seed, threads, time_limit, target_gap, progress;
  std::vector<std::string> set, outputs;
  /// Parameters with an option of their own: name as in `algorithms`, and value.
  std::vector<std::pair<std::string, std::string>> named;
  bool json = false, quiet = false, verbose = false;

  /// Precondition: one of them.
  std::string& value_of(std::string_view name);
};

/// Options of plan and batch.
struct RunText : SearchText {
  RunText();
  std::string map, frame, radius, tracks, goal_tolerance;
  bool unknown_free = false, prepare = false, gap = false;
};

/// Endings of the files that -o takes.
inline constexpr std::array<std::string_view, 4> kResultEndings{".json", ".csv", ".svg", ".png"};
inline constexpr std::array<std::string_view, 6> kDriveEndings{".json", ".csv", ".svg",
                                                               ".png",  ".gif", ".html"};
inline constexpr std::array<std::string_view, 7> kArmEndings{".json", ".csv", ".yaml", ".yml",
                                                             ".svg",  ".png", ".html"};
inline constexpr std::array<std::string_view, 3> kMapOutputEndings{".map", ".pbm", ".png"};
/// Of one plan.
inline constexpr std::array<std::string_view, 5> kPlanEndings{".json", ".csv", ".svg", ".png",
                                                              ".html"};

/// @throws UsageError; Error(invalid_parameter) for a value that the library refuses.
RunOptions make_run(const RunText& text,
                    std::span<const std::string_view> endings = kResultEndings);

/// Options of plan and drive on bitmaps.
struct EndsText {
  std::string start, goal;
};
PlanCommand make_plan(const EndsText& ends, RunOptions run);

/// Options of drive.
struct DriveText : RunText {
  EndsText ends;
  std::string world, changes, sense, max_ticks;
};
/// @throws as make_run
DriveCommand make_drive(const DriveText& text);

/// Options of arm.
struct ArmText : SearchText {
  ArmText();
  ArmCommand taken;  ///< options whose text is their value: files, links, switches
  std::string start, clearance, rate, recheck, duration, position_tolerance, angle_tolerance;
  std::vector<std::string> packages, contacts, joint_values;
  /// Option and value of each goal, as they follow each other.
  std::vector<std::pair<std::string, std::string>> goals;
  bool plain = false;
};

/// @throws UsageError. Values of parameters are looked at when the command runs.
ArmCommand make_arm(const ArmText& text);

/// Options of polygon worlds, beside those of bitmaps.
struct WorldText {
  std::string margin, join, boundary;
  bool repair = false;
};

struct PolygonText {
  WorldText world;
  EndsText ends;
};

/// @throws UsageError
WorldOptions make_world_options(const std::string& file, const WorldText& text);
PolygonCommand make_polygon(const RunText& run, const PolygonText& text,
                            std::span<const std::string_view> endings = kResultEndings);

/// @throws UsageError where --radius is given for a polygon world.
void refuse_radius(std::string_view radius);

/// @throws UsageError where an option of polygon worlds is given with a bitmap.
void refuse_world_options(const WorldText& text);

/// The seed; 1 where `text` is empty. @throws UsageError.
std::uint64_t seed_value(const std::string& text);

/// The first of "N", "A-B" or "A..B" (N: from 1 on), and how many they are.
/// @throws UsageError for another text, one below `least`, and too many.
std::pair<std::uint64_t, int> seed_range(std::string_view option, const std::string& text,
                                         std::int64_t least);

/// @throws UsageError for a file whose ending is not one of `endings`, with the nearest; a stream
/// (/dev/stdout) needs none.
void check_endings(const std::vector<std::string>& files,
                   std::span<const std::string_view> endings);

}  // namespace lasius::tool
