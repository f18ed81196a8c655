#include "tools/report/report.h"

#include <array>
#include <nlohmann/json.hpp>
#include <ostream>
#include <utility>

#include "tools/console/values.h"
#include "tools/report/page_parts.h"
#include "tools/report/thinned.h"

namespace lasius::tool {
namespace {

constexpr std::size_t kMostPoints = 4000;  // of a curve

constexpr Escape kHtml[] = {
    {'&', "&amp;"}, {'<', "&lt;"}, {'>', "&gt;"}, {'"', "&quot;"}, {'\'', "&#39;"}};

constexpr Escape kScript[] = {{'<', "\\u003c"}};

constexpr std::array kCurves{"best",     "mean",           "arrived", "raw_best", "cut_mean",
                             "cut_best", "iteration_best", "steps",   "band",     "trail_entropy"};

std::size_t stride_for(std::size_t count, std::size_t most) {
  return std::max<std::size_t>(1, (count + most - 1) / most);
}

/// Takes the curves out of a result.
Json take_curves(Json& result) {
  Json curves = Json::object();
  if (!result.contains("best") || result["best"].empty()) {
    for (const char* name : kCurves) result.erase(name);
    return curves;
  }
  const std::size_t count = result["best"].size();
  const std::size_t stride = stride_for(count, kMostPoints);
  Json iterations = Json::array();
  for (std::size_t i = 1; i <= count; ++i) iterations.push_back(i);
  curves["iteration"] = thinned(iterations, stride);
  for (const char* name : kCurves) {
    if (!result.contains(name)) continue;
    if (result[name].size() == count) curves[name] = thinned(result[name], stride);
    result.erase(name);
  }
  return curves;
}

}  // namespace

Json run_json(const Record& run, std::string_view kind, std::string title) {
  Json result = result_json(run);
  Json content = {{"kind", kind}, {"title", std::move(title)}, {"command", run.options.called}};
  content["unit"] = run.unit;
  content["scale"] = run.scale;
  content["curves"] = take_curves(result);
  for (const char* path : {"path", "path_world", "track"}) {
    if (!result.contains(path) || !result[path].is_array()) continue;
    const std::size_t stride = stride_for(result[path].size(), kMostVertices);
    if (stride == 1) continue;
    result[path] = thinned(result[path], stride);
    content["thinned"] = stride;
  }
  content["result"] = std::move(result);
  return content;
}

void write_report_page(std::ostream& out, const Json& content) {
  // As the writer of JSON has it: bad bytes are replaced.
  const std::string title = line(Json::array({content["title"]}));
  out << "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
         "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; "
         "script-src 'unsafe-inline'; style-src 'unsafe-inline'; img-src data: blob:\">\n"
         "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
         "<title>"
      << with_escapes(json::read(title, "title")[0].get<std::string>(), kHtml)
      << "</title>\n<style>\n"
      << kPageStyle << "</style>\n</head>\n<body>\n<main id=\"report\"></main>\n"
      << "<noscript>This page is drawn by its script.</noscript>\n"
      << "<script type=\"application/json\" id=\"content\">" << with_escapes(line(content), kScript)
      << "</script>\n<script type=\"module\">\n"
      << kPageScript << "</script>\n</body>\n</html>\n";
}

}  // namespace lasius::tool
