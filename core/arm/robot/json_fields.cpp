#include "core/arm/robot/json_fields.h"

#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "core/base/did_you_mean.h"
#include "core/base/json_text.h"
#include "lasius/base/error.h"

namespace lasius::arm {
namespace {

std::string range_text(double least, double most) {
  const auto shorten = [](double v) {
    std::string text = json_text(v);
    return text.ends_with(".0") ? text.substr(0, text.size() - 2) : text;
  };
  return shorten(least) + " .. " + shorten(most);
}

}  // namespace

JsonFields::JsonFields(const Json& object, std::string_view text, std::string file,
                       std::string path, std::initializer_list<std::string_view> known)
    : object_(&object), text_(text), file_(std::move(file)), path_(std::move(path)) {
  if (!object.is_object()) fail("", "is not an object", "write it as {...}");
  for (const auto& [name, value] : object.items()) {
    bool is_known = false;
    for (const auto k : known) is_known |= k == name;
    if (is_known) continue;
    fail(name, "is not a field of it", did_you_mean(name, {known.begin(), known.size()}));
  }
}

void JsonFields::fail(std::string_view name, const std::string& problem,
                      const std::string& remedy) const {
  std::string place = path_;
  if (!name.empty()) place += (place.empty() ? "" : ".") + std::string(name);
  const auto line = json_line(text_, place);
  if (place.empty()) place = "the document";
  throw Error(ErrorCode::file_broken, {.file = file_, .line = line}, place + " " + problem, remedy);
}

bool JsonFields::has(std::string_view name) const { return object_->contains(name); }

const JsonFields::Json& JsonFields::at(std::string_view name) const {
  const auto found = object_->find(name);
  if (found == object_->end()) fail(name, "is missing", "add it");
  return *found;
}

std::string JsonFields::text(std::string_view name) const {
  const Json& value = at(name);
  if (!value.is_string()) fail(name, "is not a text", "write it in quotes");
  return value.get<std::string>();
}
std::string JsonFields::text_or(std::string_view name, std::string fallback) const {
  return has(name) ? text(name) : std::move(fallback);
}

double JsonFields::number(std::string_view name, double least, double most) const {
  const Json& value = at(name);
  if (!value.is_number()) fail(name, "is not a number", "it must be " + range_text(least, most));
  const double number = value.get<double>();
  if (!(number >= least && number <= most))
    fail(name, "is " + json_text(value), "it must be " + range_text(least, most));
  return number;
}
double JsonFields::number_or(std::string_view name, double least, double most,
                             double fallback) const {
  return has(name) ? number(name, least, most) : fallback;
}

std::vector<double> JsonFields::numbers(std::string_view name, std::size_t count,
                                        double most) const {
  const Json& value = at(name);
  const std::string remedy =
      "it must be " + std::to_string(count) + " numbers from " + range_text(-most, most);
  if (!value.is_array() || value.size() != count)
    fail(name, "is not a list of " + std::to_string(count), remedy);
  std::vector<double> numbers;
  for (const Json& entry : value) {
    if (!entry.is_number() || !(std::abs(entry.get<double>()) <= most))
      fail(name, "holds " + json_text(entry), remedy);
    numbers.push_back(entry.get<double>());
  }
  return numbers;
}

Vec3 JsonFields::vector(std::string_view name, double most) const {
  const auto v = numbers(name, 3, most);
  return {v[0], v[1], v[2]};
}
Vec3 JsonFields::vector_or(std::string_view name, double most, Vec3 fallback) const {
  return has(name) ? vector(name, most) : fallback;
}

std::pair<double, double> JsonFields::range(std::string_view name, double most) const {
  const auto v = numbers(name, 2, most);
  if (v[0] > v[1]) fail(name, "has its first number above its second", "swap them");
  return {v[0], v[1]};
}

std::vector<JsonFields> JsonFields::list(std::string_view name, std::size_t least, std::size_t most,
                                         std::initializer_list<std::string_view> known) const {
  const Json& value = at(name);
  if (!value.is_array()) fail(name, "is not a list", "write it as [...]");
  if (value.size() < least || value.size() > most)
    fail(name, "has " + std::to_string(value.size()) + " entries",
         "it must have " + std::to_string(least) + " .. " + std::to_string(most));
  std::vector<JsonFields> entries;
  const std::string path = (path_.empty() ? "" : path_ + ".") + std::string(name);
  for (std::size_t i = 0; i < value.size(); ++i)
    entries.emplace_back(value[i], text_, file_, path + "[" + std::to_string(i) + "]", known);
  return entries;
}

std::vector<std::pair<int, int>> JsonFields::pairs(std::string_view name, int most) const {
  std::vector<std::pair<int, int>> pairs;
  if (!has(name)) return pairs;
  const Json& value = at(name);
  const auto whole = [&](const Json& n) {
    return n.is_number_integer() && n.get<double>() >= 0 && n.get<double>() <= most;
  };
  if (!value.is_array()) fail(name, "is not a list", "write it as [[a, b], ...]");
  for (const Json& entry : value) {
    if (!entry.is_array() || entry.size() != 2 || !whole(entry[0]) || !whole(entry[1]))
      fail(name, "holds " + json_text(entry),
           "it must hold pairs of whole numbers from 0 to " + std::to_string(most));
    pairs.emplace_back(entry[0].get<int>(), entry[1].get<int>());
  }
  return pairs;
}

std::shared_ptr<const nlohmann::json> parse_json(std::string_view text, const std::string& file,
                                                 std::string_view format) {
  nlohmann::json document = read_json(text, file);
  const bool named = document.is_object() && document.contains("format");
  if (!named || document["format"] != format)
    throw Error(
        ErrorCode::file_broken, {.file = file, .line = json_line(text, "format")},
        named ? "format is " + json_text(document["format"]) : "the document has no \"format\"",
        "it must be \"" + std::string(format) + "\"");
  return std::make_shared<const nlohmann::json>(std::move(document));
}

}  // namespace lasius::arm
