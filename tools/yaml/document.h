// Files of keys and values, YAML or JSON, which is YAML, too: every value knows where it stands.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/file_kind.h"

namespace lasius::tool {

/// A value of a document: a text, a list or a map. All that asks more of it than it holds throws
/// Error(file_broken), which names file, line and key.
class Node {
 public:
  enum class Kind { nothing, text, list, map };
  using Entry = std::pair<std::string, Node>;

  Kind kind() const { return kind_; }
  bool is_map() const { return kind_ == Kind::map; }
  bool is_list() const { return kind_ == Kind::list; }
  const std::string& key() const { return key_; }  ///< under which it stands; of an item the list's
  std::int64_t line() const { return line_; }      ///< from 1: of its key, of an item its own
  const std::string& file() const { return *file_; }

  /// "'KEY' PROBLEM", at its line.
  [[noreturn]] void fail(const std::string& problem, const std::string& remedy) const;

  /// The entries of a map in their order; none where there is nothing.
  std::span<const Entry> entries() const;
  /// The items of a list; a text or a map is a list of itself, and nothing is an empty one.
  std::span<const Node> items() const;

  /// The value of a key; null where the map has none.
  const Node* find(std::string_view name) const;
  const Node& at(std::string_view name) const;
  /// Refuses a map with other keys than these, naming the nearest.
  void allow(std::span<const std::string_view> names) const;
  void allow(std::initializer_list<std::string_view> names) const {
    allow(std::span(names.begin(), names.size()));
  }

  const std::string& text() const;  ///< not empty
  std::string joined() const;       ///< a text, or the texts of a list joined by blanks
  std::vector<std::string> texts() const;
  double number(double low, double high) const;
  std::int64_t integer(std::int64_t low, std::int64_t high) const;
  bool flag() const;  ///< true, false, yes, no, on, off
  std::size_t choice(std::span<const std::string_view> names) const;

  // The same of the value of a key, which a map need not have.
  std::string text_or(std::string_view name, const std::string& usual) const;
  std::string joined_or_empty(std::string_view name) const;
  double number_or(std::string_view name, double usual, double low, double high) const;
  std::int64_t integer_or(std::string_view name, std::int64_t usual, std::int64_t low,
                          std::int64_t high) const;
  bool flag_or(std::string_view name, bool usual) const;

 private:
  friend class DocumentReader;

  Kind kind_ = Kind::nothing;
  std::string text_;
  std::vector<Node> items_;
  std::vector<Entry> entries_;
  std::string key_;
  std::int64_t line_ = 1;
  std::shared_ptr<const std::string> file_;
};

/// The one document of a text; `file` is how errors name it. @throws Error(file_broken): no YAML,
/// a key that is given again, aliases that make more of it than any document of ours.
Node parse_document(const std::string& text, const std::string& file);

/// The document of a file of at most 64 kB, which is to be `expected`, "a preset". @throws
/// Error(file_missing), Error(file_broken), Error(file_unsupported) where it is seen to be of
/// another kind
Node read_document(const std::string& file, const std::string& expected,
                   FileKind kind = FileKind::unknown);
/// Of a kind that has a name.
Node read_document(const std::string& file, FileKind kind);

/// True for files that may be one: .yaml, .yml, .json.
bool is_document(std::string_view file);

}  // namespace lasius::tool
