#include "tools/record/json_values.h"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <system_error>

#include "tools/console/values.h"

namespace lasius::tool {

std::optional<double> gap_to(const std::optional<double>& optimum, double length) {
  if (!optimum) return std::nullopt;
  SearchResult against;
  against.length = length;
  against.lower_bound = optimum;
  const auto gap = against.gap();
  // Lengths are sums of rounded roots: one may come out a hair below the other.
  constexpr double kRounding = 1e-12;
  return gap && std::abs(*gap) < kRounding ? 0 : gap;
}

Json range_json(const Parameter& parameter) {
  Json object = {{"type", parameter.type}};
  if (parameter.choices.empty()) {
    object["minimum"] = json::parameter(parameter.text_of(parameter.least));
    object["maximum"] = json::parameter(parameter.text_of(parameter.most));
    return object;
  }
  object["values"] = Json::array();
  for (const auto choice : parameter.choices)
    object["values"].push_back(json::parameter(std::string(choice)));
  return object;
}

std::uint64_t bytes_hash(std::string_view bytes, std::uint64_t hash) noexcept {
  for (const char c : bytes) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  return hash;
}

std::uint64_t file_hash(const std::string& file, std::uint64_t hash) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(file, ignored)) return hash;
  std::ifstream in(file, std::ios::binary);
  for (char c = 0; in.get(c);) hash = bytes_hash({&c, 1}, hash);
  return hash;
}

std::string hash_text(std::uint64_t hash) {
  return printed("%016llx", static_cast<unsigned long long>(hash));
}

}  // namespace lasius::tool
