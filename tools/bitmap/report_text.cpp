#include <array>
#include <cmath>
#include <cstdio>
#include <nlohmann/json_fwd.hpp>
#include <sstream>

#include "tools/bitmap/report.h"
#include "tools/console/values.h"

namespace lasius::tool {
namespace {

/// Empty where the value is missing or not finite.
std::string finite_text(const std::optional<double>& value) {
  return value && std::isfinite(*value) ? to_text(*value) : std::string();
}

void write_points(std::ostream& out, const std::vector<Point>& path, const char* between) {
  for (const Point p : path) out << to_text(p.x) << between << to_text(p.y) << "\n";
}

/// What a column of lengths or coordinates adds to its name.
const char* unit(Frame frame) { return frame == Frame::world ? "_m" : ""; }

}  // namespace

Result in_frame(const PreparedMap& map, Frame frame, const Result& result) {
  Result shown = result;
  if (frame == Frame::cell) return shown;
  shown.length = map.metres(shown.length);
  shown.path = map.to_world(shown.path);
  if (shown.lower_bound) shown.lower_bound = map.metres(*shown.lower_bound);
  for (double& length : shown.best) length = map.metres(length);
  for (double& length : shown.mean) length = map.metres(length);
  return shown;
}

std::string result_text(const PreparedMap& map, const RunOptions& run, const Answer& answer) {
  const Result& result = answer.result;
  std::ostringstream out;
  out << to_string(result.status) << "\n";
  if (result.path.empty()) return out.str();
  out << to_text(map.length_in(run.frame, result.length)) << "\n";
  write_points(out, run.frame == Frame::world ? map.to_world(result.path) : result.path, " ");
  return out.str();
}

std::string gap_text(const PreparedMap& map, const RunOptions& run, const Answer& answer) {
  if (!answer.optimum && !answer.grid_optimum) return {};
  const auto against = [&](const char* name, double optimum) {
    std::array<char, 96> text;
    std::snprintf(text.data(), text.size(), "%s %.6f%s", name, map.length_in(run.frame, optimum),
                  run.frame == Frame::world ? " m" : "");
    std::string part = text.data();
    if (answer.result.path.empty() || !(optimum > 0)) return part;
    const double gap = 100 * (answer.result.length / optimum - 1);
    std::snprintf(text.data(), text.size(), " (the path: %+.3f%%)", gap);
    return part + text.data();
  };
  std::string text = answer.optimum ? against("optimum", *answer.optimum) : "optimum unknown";
  if (answer.grid_optimum) text += ", " + against("by its own moves", *answer.grid_optimum);
  return text;
}

std::string result_csv(const SearchResult& result, const std::vector<Point>& path, bool iterates,
                       Frame frame) {
  const char* const m = unit(frame);
  std::ostringstream out;
  if (!iterates) {
    out << "x" << m << ",y" << m << "\n";
    write_points(out, path, ",");
    return out.str();
  }
  out << "iteration,best" << m << ",mean" << m << ",arrived\n";
  for (std::size_t i = 0; i < result.best.size(); ++i)
    out << i + 1 << "," << finite_text(result.best[i]) << "," << finite_text(result.mean[i]) << ","
        << result.arrived[i] << "\n";
  return out.str();
}

std::string batch_csv_header(Frame frame) {
  const char* const m = unit(frame);
  std::ostringstream out;
  out << "index";
  for (const char* column : {"sx", "sy", "gx", "gy"}) out << "," << column << m;
  out << ",status,length" << m << ",lower_bound" << m << ",gap,iterations,elapsed_ms\n";
  return out.str();
}

std::string batch_csv_row(const PreparedMap& map, Frame frame, const Answer& answer) {
  const Result& result = answer.result;
  const auto length = [&](double cells) { return finite_text(map.length_in(frame, cells)); };
  const auto coordinate = frame == Frame::world ? to_text : whole_text;
  std::ostringstream out;
  out << answer.index.value_or(0);
  for (const Point p : {answer.start.asked, answer.goal.asked})
    out << "," << coordinate(p.x) << "," << coordinate(p.y);
  out << "," << to_string(result.status) << "," << length(result.length) << ","
      << (result.lower_bound ? length(*result.lower_bound) : "") << "," << finite_text(result.gap())
      << "," << result.iterations << "," << to_text(answer.elapsed_ms) << "\n";
  return out.str();
}

}  // namespace lasius::tool
