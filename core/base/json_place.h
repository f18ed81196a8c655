// JSON texts, read strictly and by one rule for all files. The parser tells only where the syntax
// is broken, so a text is read once before it is parsed, and once more when an error is told.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/text_lines.h"
#include "lasius/base/error.h"

namespace lasius {

class JsonPlace final : public nlohmann::json_sax<nlohmann::json> {
 public:
  /// Deeper than any document of ours.
  static constexpr int kDeepest = 64;
  /// More than any object of ours has: objects that keep their order find a name by looking at all.
  static constexpr std::size_t kMostMembers = 2000;

  /// The line, from 1, on which the value at `path` begins, as in "obstacles[3].size"; where there
  /// is none, the value around it. Precondition: the text is JSON up to there.
  static std::int64_t line(std::string_view text, std::string_view path) {
    return line_at(text, JsonPlace(text, path).found_);
  }

  /// The document that begins at byte `from` and ends with the text. @throws Error(file_broken)
  /// naming line and byte of `file` where the text is not JSON, a number is too large, an object
  /// gives a name twice, or the document nests deeper or has more members than any of ours.
  template <class Json>
  static Json parse(std::string_view text, const std::string& file, std::size_t from = 0) {
    const std::string_view document = text.substr(from);
    const auto deep = find_bracket(document, [](int depth) { return depth > kDeepest; });
    const auto fault =
        deep ? Fault{*deep, "the document nests too deep",
                     "no list or object here goes deeper than " + std::to_string(kDeepest)}
             : JsonPlace(document).fault_;
    if (!fault) return Json::parse(document);
    const std::size_t byte = from + fault->byte;
    throw Error(
        ErrorCode::file_broken,
        {.file = file, .line = line_at(text, byte), .offset = static_cast<std::int64_t>(byte)},
        fault->problem, fault->remedy);
  }

  /// The byte behind the object or list that the text begins with; the text's size if not closed.
  static std::size_t end_of_first(std::string_view text) {
    const auto last = find_bracket(text, [](int depth) { return depth == 0; });
    return last ? *last + 1 : text.size();
  }

 private:
  struct Fault {
    std::size_t byte;
    std::string problem, remedy;
  };

  /// The first bracket after which the depth is `wanted`.
  template <class Wanted>
  static std::optional<std::size_t> find_bracket(std::string_view json, const Wanted& wanted) {
    int depth = 0;
    bool quoted = false;
    for (std::size_t i = 0; i < json.size(); ++i) {
      const char c = json[i];
      if (quoted && c == '\\') ++i;
      if (c == '"') quoted = !quoted;
      if (quoted) continue;
      const int step = (c == '[' || c == '{') - (c == ']' || c == '}');
      depth += step;
      if (step != 0 && wanted(depth)) return i;
    }
    return std::nullopt;
  }

  /// Reads the text and tells how far it came.
  struct Cursor {
    using iterator_category = std::input_iterator_tag;
    using value_type = char;
    using difference_type = std::ptrdiff_t;
    using pointer = const char*;
    using reference = const char&;

    const char* at;
    const char** furthest;

    reference operator*() const { return *at; }
    Cursor& operator++() {
      *furthest = ++at;
      return *this;
    }
    bool operator==(const Cursor& other) const { return at == other.at; }
  };

  /// An object or a list that is not closed yet.
  struct Open {
    bool on_path;
    std::string entry;      ///< the key of the value to come
    std::size_t index = 0;  ///< in a list: of the value to come
    bool list;
    std::set<std::string> names = {};  ///< in an object that is checked: those given so far
  };

  /// Looks for the value at a path.
  JsonPlace(std::string_view text, std::string_view path) : text_(text), check_(false) {
    for (std::size_t from = 0; from < path.size();) {
      const auto to = std::min(path.find_first_of(".[", from + 1), path.size());
      const auto entry = path.substr(from, to - from);
      path_.emplace_back(entry.starts_with('.') ? entry.substr(1) : entry);
      from = to;
    }
    read();
  }
  /// Looks for the first fault.
  explicit JsonPlace(std::string_view text) : text_(text), check_(true) {
    // The parser takes a zero byte for the end.
    const auto zero = text.find('\0');
    if (read() && zero != text.npos)
      fault_ = Fault{zero, "there is a zero byte", "leave it out: JSON is text"};
  }

  bool read() {
    const char* const end = text_.data() + text_.size();
    nlohmann::json_sax<nlohmann::json>* const events = this;
    return nlohmann::json::sax_parse(Cursor{furthest_, &furthest_}, Cursor{end, &furthest_},
                                     events);
  }
  /// The last byte that the parser has read.
  std::size_t last_read() const { return static_cast<std::size_t>(furthest_ - text_.data()) - 1; }

  /// Notes a value that is on the path; false once the last one is found.
  bool value() {
    if (check_) return true;
    bool on_path = open_.empty();
    if (!open_.empty()) {
      Open& top = open_.back();
      if (top.list) top.entry = "[" + std::to_string(top.index++) + "]";
      on_path = top.on_path && open_.size() <= path_.size() && top.entry == path_[open_.size() - 1];
    }
    last_on_path_ = on_path;
    if (!on_path) return true;
    // The parser has read the last byte of the value, or of its bracket; of a number, one more.
    found_ = last_read();
    return open_.size() < path_.size();
  }
  bool begin(bool list) {
    const bool more = value();
    open_.push_back({last_on_path_, {}, 0, list});
    return more;
  }
  bool end() {
    open_.pop_back();
    return true;
  }

  bool null() override { return value(); }
  bool boolean(bool) override { return value(); }
  bool number_integer(number_integer_t) override { return value(); }
  bool number_unsigned(number_unsigned_t) override { return value(); }
  bool number_float(number_float_t, const string_t&) override { return value(); }
  bool string(string_t&) override { return value(); }
  bool binary(binary_t&) override { return value(); }
  bool start_object(std::size_t) override { return begin(false); }
  bool start_array(std::size_t) override { return begin(true); }
  bool end_object() override { return end(); }
  bool end_array() override { return end(); }
  bool key(string_t& name) override {
    Open& object = open_.back();
    object.entry = name;
    if (!check_) return true;
    if (!object.names.insert(name).second) {
      constexpr std::size_t kMostShown = 40;
      const nlohmann::json shown = name.substr(0, kMostShown);
      fault_ = Fault{
          last_read(),
          shown.dump(-1, ' ', true, nlohmann::json::error_handler_t::replace) + " is given again",
          "leave one of the two out"};
    } else if (object.names.size() > kMostMembers) {
      fault_ = Fault{last_read(), "an object has too many members",
                     "none here has more than " + std::to_string(kMostMembers)};
    }
    return !fault_;
  }
  bool parse_error(std::size_t position, const std::string&,
                   const nlohmann::json::exception& error) override {
    constexpr int kNumberTooLarge = 406;
    const std::size_t byte = position > 0 ? position - 1 : 0;
    fault_ = error.id == kNumberTooLarge
                 ? Fault{byte, "a number is too large", "numbers lie within 1e308"}
                 : Fault{byte, "this is not JSON", "correct the text there or before it"};
    return false;
  }

  std::string_view text_;
  const char* furthest_ = text_.data();
  std::vector<std::string> path_;
  std::vector<Open> open_;
  bool check_;
  bool last_on_path_ = false;
  std::size_t found_ = 0;
  std::optional<Fault> fault_;
};

}  // namespace lasius
