// The options that the commands that plan have in common.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tools/command_line/option_table.h"
#include "tools/console/exit_code.h"
#include "tools/options/options.h"

namespace lasius::tool {

inline const ExitText kOutput{kNoOutput, "an output cannot be written"};
/// Files that say more than a text: presets, studies.
inline const std::vector<std::string> kDocuments{".yaml", ".yml", ".json"};

/// What the options that all planning commands have mean to one of them.
struct SearchHelp {
  const char* seed;
  const char* time_limit;
  const char* target_gap;
  const char* json;
  const char* outputs;
  std::span<const std::string_view> endings;  ///< of outputs
};

void add_search_options(OptionTable& table, SearchOptions& to, const SearchHelp& help);
/// An algorithm's parameter with an option of its own.
void add_parameter(OptionTable& table, const char* option, SearchOptions& to, const char* help,
                   const char* type);
void add_preset(OptionTable& table, SearchOptions& to, const char* help);

/// What is left to read once all options are: a preset's file, threads. @throws UsageError for
/// options that do not go together.
void finish_search(SearchOptions& options);

void add_seed(OptionTable& table, std::uint64_t& to);

/// The first of "N", "A-B" or "A..B" (N: from 1 on), and how many they are.
/// @throws UsageError for another text, one below `least`, and too many.
std::pair<std::uint64_t, int> seed_range(std::string_view option, const std::string& text,
                                         std::int64_t least);

/// --part I/N.
void add_part(OptionTable& table, Part& to, const char* help);

/// -o of files whose ending is one of `endings`, the nearest of which a UsageError names; a stream
/// (/dev/stdout) needs none.
void check_ending(const std::string& file, std::span<const std::string_view> endings);
std::vector<std::string> texts(std::span<const std::string_view> words);

/// A start or goal on a bitmap: a cell, or a point where a coordinate has a decimal point or an
/// exponent and where metres are given. @throws UsageError
End point_value(std::string_view option, const std::string& text, Frame frame);
/// "1.57", radians, or "90deg". @throws UsageError
double angle_value(std::string_view option, std::string_view text, double low, double high);
/// Of radians that may have been meant as degrees: as in ": 90 radians are 14.32 turns; degrees end
/// in deg". Else empty.
std::string turns_hint(std::string_view text, double yaw);
/// "X,Y,YAW": a point as above, in the frame of `run`, whose notes tell of many turns, and an angle
/// of at most 100000 radians. @throws UsageError
PoseEnd pose_value(std::string_view option, const std::string& text, RunOptions& run);
/// The same of what knows cells alone: the cell that holds it, or metres in it. @throws UsageError
Point end_value(std::string_view option, const std::string& text, Frame frame);
/// Options that must be there though CLI11 does not say so. @throws UsageError
void require(const std::string& command, const char* option, const std::string& text);

/// Files that a bitmap is read from, and those of polygon worlds.
std::vector<std::string> map_endings(bool with_worlds);

}  // namespace lasius::tool
