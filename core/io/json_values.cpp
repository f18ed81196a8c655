#include "core/io/json_values.h"

#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <utility>

#include "core/base/json_place.h"
#include "core/base/number_text.h"
#include "lasius/base/error.h"

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

Json point(Point p) {
  Json::array_t pair(2);
  pair[0] = number(p.x);
  pair[1] = number(p.y);
  return pair;
}

Json points(const std::vector<Point>& path) {
  if (path.empty()) return nullptr;
  Json::array_t list;
  list.reserve(path.size());
  for (const Point p : path) list.push_back(point(p));
  return list;
}

Json roomy_object() {
  constexpr std::size_t kMembers = 64;
  Json::object_t object;
  object.reserve(kMembers);
  return object;
}

void append(Json& to, Json&& members) {
  for (auto& [name, value] : members.get_ref<Json::object_t&>()) to[name] = std::move(value);
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

namespace {

/// Is this one value of CBOR, nested no deeper than any file of ours, its lists no longer than its
/// bytes? What the parser relies on.
bool is_cbor(std::string_view bytes) {
  constexpr std::size_t kDeepest = 64;
  std::vector<std::uint64_t> left{1};  // values, on each level
  std::size_t at = 0;
  while (!left.empty() && left.size() <= kDeepest) {
    if (left.back() == 0) {
      left.pop_back();
      continue;
    }
    --left.back();
    if (at == bytes.size()) return false;
    const int head = static_cast<unsigned char>(bytes[at++]), kind = head >> 5, low = head & 31;
    std::uint64_t value = static_cast<std::uint64_t>(low);
    if (low >= 24) {
      const std::size_t size = std::size_t{1} << (low - 24);
      if (low > 27 || size > bytes.size() - at) return false;
      value = 0;
      for (std::size_t i = 0; i < size; ++i)
        value = value << 8 | static_cast<unsigned char>(bytes[at++]);
    }
    const bool counts = kind >= 2 && kind <= 5;
    if (counts && value > bytes.size() - at) return false;
    if (kind == 2 || kind == 3) at += static_cast<std::size_t>(value);
    if (kind == 4) left.push_back(value);
    if (kind == 5) left.push_back(2 * value);
    if (kind == 6) left.push_back(1);
  }
  return left.empty() && at == bytes.size();
}

}  // namespace

Json read_cbor(std::string_view bytes, const std::string& file) {
  Json value;
  if (is_cbor(bytes))
    value =
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
