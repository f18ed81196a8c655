// System D: what one parameter after another does to arms among unknown obstacles.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "tools/study/study.h"

namespace lasius::study {

/// One choice of parameters over the base set.
struct ArmSetting {
  std::string sweep;  ///< which parameter is changed; "base"
  std::string value;  ///< of it, as in the source
  Settings settings = {};
  std::string name() const { return sweep == "base" ? "base" : sweep + "-" + value; }
};
/// The base set, then the sweeps of the source, without repeats of the base set.
std::vector<ArmSetting> arm_settings();

/// One scene with start and goal, made from a seed.
struct ArmQuestion {
  std::uint64_t seed = 1;
  double wall = 0;  ///< see arm::GenerateOptions
};
/// Ten: the straight way is open in five, closed in five; two of those need a detour of at least
/// 1.5 times the Manhattan distance. The first seeds of each kind.
std::vector<ArmQuestion> arm_questions();

/// One run; lengths are shares of the optimum of the fully known lattice.
struct ArmRun {
  std::vector<double> best;
  std::vector<double> mean;
  std::int64_t questions = 0;
  std::int64_t steps = 0;
};

/// What was measured of a question itself.
struct ArmGround {
  double optimum = 0;  ///< metres
  double detour = 1;   ///< optimum / Manhattan distance
  bool straight = true;
  std::array<int, 3> points{};
};

/// What carries pheromone: the two readings of the source.
inline constexpr std::array<const char*, 2> kReadings{"arcs", "edges"};

/// Of each question, for the robot in this file.
std::vector<ArmGround> arm_grounds(const std::filesystem::path& robot);

struct ArmFindings {
  int seeds = 0;
  std::vector<ArmQuestion> questions;
  std::vector<ArmGround> grounds;
  std::vector<ArmSetting> settings;
  /// By reading, setting, question, seed.
  std::array<std::vector<std::vector<std::vector<ArmRun>>>, 2> runs;

  const std::vector<std::vector<ArmRun>>& of(std::size_t reading, const std::string& name) const;
};

struct ArmStudyOptions {
  int seeds = 30;
  int threads = 1;
  std::filesystem::path folder;  ///< runs are kept in its subfolder `runs`
  std::filesystem::path robot;   ///< maps/arms/industrial6.json
  std::stop_token stop = {};
  std::function<void(std::int64_t done, std::int64_t total, const std::string& note)> progress = {};
};

/// Nothing when it was stopped.
std::optional<ArmFindings> run_arm_study(const ArmStudyOptions& options);

/// A trend that the source reports, and what the runs say of it under one reading.
struct ArmTrend {
  std::string text;
  std::array<Claim::Answer, 2> found;  ///< by reading
};
std::vector<ArmTrend> arm_trends(const ArmFindings& findings);

/// The report; `pictures` are file names beside it.
std::string arm_report(const ArmFindings& findings, const std::vector<std::string>& pictures);

}  // namespace lasius::study
