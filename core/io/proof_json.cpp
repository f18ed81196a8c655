#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "core/base/number_text.h"
#include "core/io/json_values.h"
#include "lasius/error.h"
#include "lasius/io_json.h"

namespace lasius {
namespace {

using json::Json;

constexpr std::string_view kFormat = "lasius-proof/1";

std::string hash_text(std::uint64_t hash) {
  std::string digits(16, '0');
  char text[16];
  const auto end = std::to_chars(text, text + 16, hash, 16).ptr;
  std::copy(text, end, digits.end() - (end - text));
  return "\"" + digits + "\"";
}

template <class Number>
void append_list(std::string& text, const std::vector<Number>& list) {
  text += '[';
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (i > 0) text += ',';
    text += number_text(list[i]);
  }
  text += ']';
}

std::string cell_text(Cell c) { return '[' + number_text(c.x) + ',' + number_text(c.y) + ']'; }

/// Reads members of objects of one file.
class Reader {
 public:
  explicit Reader(const std::string& file) : file_(file) {}

  Error broken(const std::string& problem) const {
    return {ErrorCode::file_broken,
            {.file = file_},
            problem,
            "give a file that `lasius plan -o NAME.proof.json` or proof_to_json wrote"};
  }
  const Json& member(const Json& object, const char* key) const {
    if (!object.is_object() || !object.contains(key))
      throw broken("it lacks \"" + std::string(key) + "\"");
    return object[key];
  }
  int whole(const Json& value, const char* key) const {
    if (value.is_number_integer() && std::in_range<int>(value.get<std::int64_t>()) &&
        (!value.is_number_unsigned() || std::in_range<int>(value.get<std::uint64_t>())))
      return value.get<int>();
    throw fault(key, value);
  }
  double number(const Json& value, const char* key) const {
    if (!value.is_number() || !std::isfinite(value.get<double>())) throw fault(key, value);
    return value.get<double>();
  }
  const Json& list(const Json& object, const char* key) const {
    const Json& value = member(object, key);
    if (!value.is_array()) throw fault(key, value);
    return value;
  }
  Cell cell(const Json& object, const char* key) const {
    const Json& pair = list(object, key);
    if (pair.size() != 2) throw fault(key, pair);
    return {whole(pair[0], key), whole(pair[1], key)};
  }
  std::string text(const Json& object, const char* key) const {
    const Json& value = member(object, key);
    if (!value.is_string()) throw fault(key, value);
    return value.get<std::string>();
  }
  std::uint64_t hash(const Json& object, const char* key) const {
    const std::string digits = text(member(object, key), "hash");
    std::uint64_t hash = 0;
    const char* const end = digits.data() + digits.size();
    const auto read = std::from_chars(digits.data(), end, hash, 16);
    if (digits.size() != 16 || read.ptr != end || read.ec != std::errc())
      throw fault("hash", digits);
    return hash;
  }
  Error fault(const char* key, const Json& value) const {
    return broken("it holds \"" + std::string(key) + "\": " + json::dumped(value).substr(0, 100));
  }

 private:
  const std::string& file_;
};

}  // namespace

std::string proof_to_json(const CostProof& proof, std::string_view weights) {
  std::string text = "{\"format\":\"" + std::string(kFormat) +
                     "\",\n\"map\":{\"hash\":" + hash_text(proof.map_hash) +
                     "},\n\"costs\":{\"hash\":" + hash_text(proof.costs_hash) + "},\n";
  if (!weights.empty()) text += "\"weights\":" + std::string(weights) + ",\n";
  text += "\"start\":" + cell_text(proof.start) + ",\"goal\":" + cell_text(proof.goal) +
          ",\"lower_bound\":" + number_text(proof.lower_bound) + ",\n\"levels\":[";
  const char* between = "\n";
  for (const CostProof::Level& level : proof.levels) {
    text += between;
    text += "{\"from\":";
    text += level.from_start ? "\"start\"" : "\"goal\"";
    text += ",\"block\":" + number_text(level.block) +
            ",\"intervals\":" + number_text(level.intervals) + ",\n\"runs\":";
    append_list(text, level.runs);
    text += ",\n\"values\":";
    append_list(text, level.values);
    text += '}';
    between = ",\n";
  }
  text += "]}\n";
  return text;
}

CostProof proof_from_json(std::string_view text, const std::string& file) {
  const Json object = json::read(text, file);
  const Reader read(file);
  if (const auto format = read.text(object, "format"); format != kFormat)
    throw read.fault("format", format);
  CostProof proof{.start = read.cell(object, "start"),
                  .goal = read.cell(object, "goal"),
                  .lower_bound = read.number(read.member(object, "lower_bound"), "lower_bound"),
                  .map_hash = read.hash(object, "map"),
                  .costs_hash = read.hash(object, "costs")};
  for (const Json& level : read.list(object, "levels")) {
    const std::string from = read.text(level, "from");
    if (from != "start" && from != "goal") throw read.fault("from", from);
    CostProof::Level& to = proof.levels.emplace_back();
    to.from_start = from == "start";
    to.block = read.whole(read.member(level, "block"), "block");
    to.intervals = read.whole(read.member(level, "intervals"), "intervals");
    for (const Json& number : read.list(level, "runs"))
      to.runs.push_back(read.whole(number, "runs"));
    for (const Json& number : read.list(level, "values"))
      to.values.push_back(read.number(number, "values"));
  }
  return proof;
}

}  // namespace lasius
