// The options of plan and batch: as typed, and read.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tools/options/options.h"

namespace lasius::tool {

/// Options as typed, before their values are looked at.
struct RunText {
  std::string map, algorithm, seed, threads, time_limit, target_gap, frame, radius, progress,
      tracks;
  std::vector<std::string> set, outputs;
  /// Parameters with an option of their own: name as in `algorithms`, and value.
  std::vector<std::pair<std::string, std::string>> named{
      {"ants", ""}, {"iterations", ""}, {"neighbours", ""}, {"corners", ""}, {"polish", ""}};
  bool unknown_free = false, prepare = false, gap = false, json = false, quiet = false,
       verbose = false;

  /// Precondition: one of them.
  std::string& value_of(std::string_view name);
};

/// @throws UsageError; Error(invalid_parameter) for a value that the library refuses.
RunOptions make_run(const RunText& text);

/// Options of arm, likewise.
struct ArmText {
  std::string robot, base, tip, scene, start, goal, algorithm, seed, threads, time_limit,
      target_gap, clearance, rate, recheck, progress;
  std::vector<std::string> set, outputs;
  std::vector<std::pair<std::string, std::string>> named{
      {"ants", ""}, {"iterations", ""}, {"pitch", ""}, {"side", ""}};
  bool plain = false, json = false, quiet = false, verbose = false;
};

/// @throws UsageError. Values of parameters are looked at when the command runs.
ArmCommand make_arm(const ArmText& text);

/// Values of options that several commands have; what they are where `text` is empty: seed 1, no
/// time limit in seconds, no gap as a fraction (typed in percent). @throws UsageError.
std::uint64_t seed_value(const std::string& text);
std::optional<double> time_limit_value(const std::string& text);
double target_gap_value(const std::string& text);

/// The endings of what `-o` of a planning command takes.
inline constexpr std::array<std::string_view, 4> kOutputEndings{".json", ".csv", ".svg", ".png"};

/// How much is said. @throws UsageError.
Messages make_messages(const RunText& text);

/// @throws UsageError for a file whose ending is not one of `endings`, with the nearest.
void check_endings(const std::vector<std::string>& files,
                   std::span<const std::string_view> endings);

}  // namespace lasius::tool
