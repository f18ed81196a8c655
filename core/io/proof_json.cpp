#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <nlohmann/json.hpp>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/base/number_text.h"
#include "core/io/json_values.h"
#include "lasius/base/error.h"
#include "lasius/io/json.h"

namespace lasius {
namespace {

using json::Json;

constexpr std::string_view kFormat = "lasius-proof/1";

// Typed arrays, the low byte first, as they lie in memory (RFC 8746).
static_assert(std::endian::native == std::endian::little && sizeof(int) == 4);
template <class Number>
constexpr std::uint64_t kTag = std::is_same_v<Number, double> ? 86 : 78;

std::string hash_digits(std::uint64_t hash) {
  std::string digits(16, '0');
  char text[16];
  const auto end = std::to_chars(text, text + 16, hash, 16).ptr;
  std::copy(text, end, digits.end() - (end - text));
  return digits;
}

std::string hash_text(std::uint64_t hash) { return '"' + hash_digits(hash) + '"'; }

template <class Number>
Json typed_array(const std::vector<Number>& list) {
  std::vector<std::uint8_t> bytes(list.size() * sizeof(Number));
  if (!list.empty()) std::memcpy(bytes.data(), list.data(), bytes.size());
  return Json::binary(std::move(bytes), kTag<Number>);
}

Json cell_pair(Cell c) { return Json::array({c.x, c.y}); }

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
            "give a file that `lasius plan -o NAME.proof.json` (or .proof.cbor) wrote"};
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
  /// A list of numbers, or a typed array.
  template <class Number>
  std::vector<Number> numbers(const Json& object, const char* key) const {
    const Json& value = member(object, key);
    std::vector<Number> numbers;
    if (value.is_binary()) {
      const Json::binary_t& bytes = value.get_binary();
      if (!bytes.has_subtype() || bytes.subtype() != kTag<Number> ||
          bytes.size() % sizeof(Number) != 0)
        throw broken("\"" + std::string(key) + "\" is no typed array of its kind");
      numbers.resize(bytes.size() / sizeof(Number));
      if (!numbers.empty()) std::memcpy(numbers.data(), bytes.data(), bytes.size());
      for (const Number number : numbers)
        if (!std::isfinite(static_cast<double>(number))) throw fault(key, Json(number));
      return numbers;
    }
    for (const Json& one : list(object, key)) {
      if constexpr (std::is_same_v<Number, double>)
        numbers.push_back(number(one, key));
      else
        numbers.push_back(whole(one, key));
    }
    return numbers;
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

std::string proof_to_cbor(const CostProof& proof, std::string_view weights) {
  Json object = {{"format", kFormat},
                 {"map", {{"hash", hash_digits(proof.map_hash)}}},
                 {"costs", {{"hash", hash_digits(proof.costs_hash)}}},
                 {"start", cell_pair(proof.start)},
                 {"goal", cell_pair(proof.goal)},
                 {"lower_bound", proof.lower_bound}};
  if (!weights.empty()) object["weights"] = json::read(weights, "weights");
  Json& levels = object["levels"] = Json::array();
  for (const CostProof::Level& level : proof.levels)
    levels.push_back({{"from", level.from_start ? "start" : "goal"},
                      {"block", level.block},
                      {"intervals", level.intervals},
                      {"runs", typed_array(level.runs)},
                      {"values", typed_array(level.values)}});
  return json::cbor(object);
}

namespace {

CostProof proof_of(const Json& object, const std::string& file) {
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
    to.runs = read.numbers<int>(level, "runs");
    to.values = read.numbers<double>(level, "values");
  }
  return proof;
}

}  // namespace

CostProof proof_from_json(std::string_view text, const std::string& file) {
  return proof_of(json::read(text, file), file);
}

CostProof proof_from_cbor(std::string_view bytes, const std::string& file) {
  return proof_of(json::read_cbor(bytes, file), file);
}

}  // namespace lasius
