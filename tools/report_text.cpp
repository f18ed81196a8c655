#include <array>
#include <cmath>
#include <cstdio>
#include <nlohmann/json_fwd.hpp>
#include <sstream>

#include "report.h"
#include "values.h"

namespace lasius::tool {
namespace {

/// Empty where the value is missing or not finite.
std::string finite_text(const std::optional<double>& value) {
  return value && std::isfinite(*value) ? to_text(*value) : std::string();
}

void write_points(std::ostream& out, const std::vector<Point>& path, const char* between) {
  for (const Point p : path) out << to_text(p.x) << between << to_text(p.y) << "\n";
}

}  // namespace

std::string result_text(const PreparedMap& map, const RunOptions& run, const Answer& answer) {
  const Result& result = answer.result;
  std::ostringstream out;
  out << to_string(result.status) << "\n";
  if (result.path.empty()) return out.str();
  const bool world = run.frame == Frame::world;
  out << to_text(world ? map.metres(result.length) : result.length) << "\n";
  write_points(out, world ? map.to_world(result.path) : result.path, " ");
  return out.str();
}

std::string gap_text(const Answer& answer) {
  if (!answer.optimum) return {};
  const auto against = [&](const char* name, double optimum) {
    std::array<char, 96> text;
    std::snprintf(text.data(), text.size(), "%s %.6f", name, optimum);
    std::string part = text.data();
    if (answer.result.path.empty() || !(optimum > 0)) return part;
    const double gap = 100 * (answer.result.length / optimum - 1);
    std::snprintf(text.data(), text.size(), " (the path: %+.3f%%)", gap);
    return part + text.data();
  };
  std::string text = against("optimum", *answer.optimum);
  if (answer.grid_optimum) text += ", " + against("by its own moves", *answer.grid_optimum);
  return text;
}

std::string result_csv(const Result& result) {
  std::ostringstream out;
  if (result.best.empty()) {
    out << "x,y\n";
    write_points(out, result.path, ",");
    return out.str();
  }
  out << "iteration,best,mean,arrived\n";
  for (std::size_t i = 0; i < result.best.size(); ++i)
    out << i + 1 << "," << finite_text(result.best[i]) << "," << finite_text(result.mean[i]) << ","
        << result.arrived[i] << "\n";
  return out.str();
}

std::string batch_csv_header() {
  return "index,sx,sy,gx,gy,status,length,lower_bound,gap,iterations,elapsed_ms\n";
}

std::string batch_csv_row(const Answer& answer, Frame frame) {
  const Result& result = answer.result;
  const Point start = cell_numbers(answer.start, frame), goal = cell_numbers(answer.goal, frame);
  std::ostringstream out;
  out << answer.index.value_or(0) << "," << whole_text(start.x) << "," << whole_text(start.y) << ","
      << whole_text(goal.x) << "," << whole_text(goal.y) << "," << to_string(result.status) << ","
      << finite_text(result.length) << "," << finite_text(result.lower_bound) << ","
      << finite_text(result.gap()) << "," << result.iterations << "," << to_text(answer.elapsed_ms)
      << "\n";
  return out.str();
}

}  // namespace lasius::tool
