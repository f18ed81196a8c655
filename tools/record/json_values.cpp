#include "tools/record/json_values.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "lasius/error.h"
#include "tools/console/values.h"

namespace lasius::tool {

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json optional_number(const std::optional<double>& value) {
  return value ? number(*value) : Json(nullptr);
}

Json numbers(const std::vector<double>& values) {
  Json list = Json::array();
  for (const double value : values) list.push_back(number(value));
  return list;
}

Json point(Point p) { return Json::array({number(p.x), number(p.y)}); }

Json points(const std::vector<Point>& path) {
  if (path.empty()) return nullptr;
  Json list = Json::array();
  for (const Point p : path) list.push_back(point(p));
  return list;
}

Json gap_to(const std::optional<double>& optimum, double length) {
  if (!optimum || std::isnan(length)) return nullptr;
  // Lengths are sums of rounded roots: one may come out a hair below the other.
  constexpr double kRounding = 1e-12;
  const double gap = *optimum > 0 ? (length - *optimum) / *optimum : 0;
  return number(std::abs(gap) < kRounding ? 0 : gap);
}

Json parameter_json(const std::string& text) {
  if (const auto integer = parse_integer(text)) return *integer;
  if (const auto real = parse_real(text)) return *real;
  return text;
}

std::string parameter_text(const Json& value) {
  if (value.is_string()) return value.get<std::string>();
  return value.is_number_float() ? to_text(value.get<double>()) : value.dump();
}

Json parameters_json(const Algorithm& algorithm,
                     const std::function<std::string(std::string_view name)>& text) {
  Json object = Json::object();
  for (const Parameter& parameter : algorithm.parameters)
    object[std::string(parameter.name)] = parameter_json(text(parameter.name));
  return object;
}

Json range_json(const Parameter& parameter) {
  Json json = {{"type", parameter.type}};
  const std::string_view range = parameter.range;
  if (const auto dots = range.find(" .. "); dots != std::string_view::npos) {
    json["minimum"] = parameter_json(std::string(range.substr(0, dots)));
    json["maximum"] = parameter_json(std::string(range.substr(dots + 4)));
    return json;
  }
  json["values"] = Json::array();
  for (std::size_t from = 0; from <= range.size();) {
    const auto bar = std::min(range.find('|', from), range.size());
    json["values"].push_back(parameter_json(std::string(range.substr(from, bar - from))));
    from = bar + 1;
  }
  return json;
}

std::string hash_text(std::uint64_t hash) {
  std::array<char, 17> digits;
  std::snprintf(digits.data(), digits.size(), "%016llx", static_cast<unsigned long long>(hash));
  return digits.data();
}

void check_hash(const std::string& file, std::uint64_t hash, const std::string& recorded,
                const char* remedy) {
  if (hash_text(hash) == recorded) return;
  throw Error(ErrorCode::file_broken, {.file = file},
              "has hash " + hash_text(hash) + ", the result was made on " + recorded, remedy);
}

std::string line(const Json& value) {
  return value.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace lasius::tool
