// Fields of a JSON document, read strictly: every mistake names the file, the place and the remedy.
#pragma once

#include <initializer_list>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "core/arm/robot/vec3.h"

namespace lasius::arm {

/// An object within a document, with the path to it for messages: "obstacles[3]". The document's
/// text and tree must outlive it.
class JsonFields {
 public:
  using Json = nlohmann::json;

  /// @throws Error(file_broken) where it is no object or has a field that is not in `known`.
  JsonFields(const Json& object, std::string_view text, std::string file, std::string path,
             std::initializer_list<std::string_view> known);

  bool has(std::string_view name) const;
  std::string text(std::string_view name) const;
  std::string text_or(std::string_view name, std::string fallback) const;
  /// Finite and within the range.
  double number(std::string_view name, double least, double most) const;
  double number_or(std::string_view name, double least, double most, double fallback) const;
  /// Three finite numbers, none beyond `most` either way.
  Vec3 vector(std::string_view name, double most) const;
  Vec3 vector_or(std::string_view name, double most, Vec3 fallback) const;
  /// Two numbers, the first not above the second.
  std::pair<double, double> range(std::string_view name, double most) const;
  /// The objects of a list of `least` to `most`.
  std::vector<JsonFields> list(std::string_view name, std::size_t least, std::size_t most,
                               std::initializer_list<std::string_view> known) const;
  /// Pairs of whole numbers from 0 to `most`.
  std::vector<std::pair<int, int>> pairs(std::string_view name, int most) const;

  /// Throws Error(file_broken): "FILE, line N: PATH.name PROBLEM; REMEDY".
  [[noreturn]] void fail(std::string_view name, const std::string& problem,
                         const std::string& remedy) const;
  const std::string& file() const noexcept { return file_; }

 private:
  const Json& at(std::string_view name) const;
  std::vector<double> numbers(std::string_view name, std::size_t count, double most) const;

  const Json* object_;
  std::string_view text_;
  std::string file_;
  std::string path_;
};

/// The document in `text`, its "format" checked. @throws Error(file_broken) with the byte offset.
std::shared_ptr<const nlohmann::json> parse_json(std::string_view text, const std::string& file,
                                                 std::string_view format);

}  // namespace lasius::arm
