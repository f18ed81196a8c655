#include "core/io/json_values.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "core/base/json_place.h"
#include "core/base/number_text.h"
#include "lasius/error.h"

namespace lasius::json {

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

Json text_or_null(const std::string& text) { return text.empty() ? Json(nullptr) : Json(text); }

Json parameter(const std::string& text) {
  const Json value = Json::parse(text, nullptr, false);
  return value.is_number() ? value : Json(text);
}

std::string parameter_text(const Json& value) {
  if (value.is_string()) return value.get<std::string>();
  return value.is_number_float() ? number_text(value.get<double>()) : dumped(value);
}

Json parameters(const Algorithm& algorithm,
                const std::function<std::string(std::string_view name)>& text) {
  Json object = Json::object();
  for (const Parameter& known : algorithm.parameters)
    object[std::string(known.name)] = parameter(text(known.name));
  return object;
}

void add_convergence(Json& json, const Convergence& run) {
  json["iterations"] = run.iterations;
  json["best"] = numbers(run.best);
  json["mean"] = numbers(run.mean);
  json["arrived"] = run.arrived;
  if (run.steps.empty()) return;
  json["raw_best"] = numbers(run.raw_best);
  json["cut_mean"] = numbers(run.cut_mean);
  json["cut_best"] = numbers(run.cut_best);
  json["iteration_best"] = numbers(run.iteration_best);
  json["steps"] = run.steps;
  json["band"] = numbers(run.band);
  json["trail_entropy"] = numbers(run.trail_entropy);
}

void add_proof(Json& json, const SearchResult& result) {
  json["lower_bound"] = optional_number(result.lower_bound);
  json["gap"] = optional_number(result.gap());
  json["optimal"] = result.optimal;
}

Json read(std::string_view text, const std::string& file, std::size_t from) {
  return JsonPlace::parse<Json>(text, file, from);
}

Json read_cbor(std::string_view bytes, const std::string& file) {
  Json value =
      Json::from_cbor(bytes.begin(), bytes.end(), true, false, Json::cbor_tag_handler_t::store);
  if (value.is_object()) return value;
  throw Error(ErrorCode::file_broken, {.file = file}, "it is no CBOR object, or not whole",
              "write it anew");
}

std::string cbor(const Json& value) {
  std::string bytes;
  Json::to_cbor(value, bytes);
  return bytes;
}

std::string dumped(const Json& value) {
  return value.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string line(const Json& value) { return dumped(value) + "\n"; }

}  // namespace lasius::json
