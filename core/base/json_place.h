// Where in a JSON text a value stands. The parser itself tells only where the syntax is broken, so
// the text is read once more when an error has to be told.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/json_depth.h"
#include "lasius/error.h"

namespace lasius {

class JsonPlace final : public nlohmann::json_sax<nlohmann::json> {
 public:
  /// The line, from 1, on which the value at `path` begins, as in "obstacles[3].size"; where there
  /// is none, the value around it. Precondition: the text is JSON up to there.
  static std::int64_t line(std::string_view text, std::string_view path) {
    const JsonPlace place(text, path);
    const auto before = text.substr(0, place.found_);
    return 1 + std::count(before.begin(), before.end(), '\n');
  }

  /// The document. @throws Error(file_broken) naming line and byte of `file` where the text is not
  /// JSON, a number is too large, or lists and objects nest deeper than any of ours.
  static nlohmann::json parse(std::string_view text, const std::string& file) {
    if (const auto byte = too_deep(text)) {
      refuse(text, *byte, file, "the document nests too deep",
             "no list or object here goes deeper than " + std::to_string(kDeepestJson));
    }
    try {
      return nlohmann::json::parse(text);
    } catch (const nlohmann::json::exception& fault) {
      const bool syntax = dynamic_cast<const nlohmann::json::parse_error*>(&fault) != nullptr;
      refuse(text, JsonPlace(text, {}, true).fault_, file,
             syntax ? "this is not JSON" : "a number is too large",
             syntax ? "correct the text there or before it" : "numbers lie within 1e308");
    }
  }

 private:
  [[noreturn]] static void refuse(std::string_view text, std::size_t byte, const std::string& file,
                                  const std::string& problem, const std::string& remedy) {
    const auto line = 1 + std::count(text.begin(), text.begin() + byte, '\n');
    throw Error(ErrorCode::file_broken,
                {.file = file, .line = line, .offset = static_cast<std::int64_t>(byte)}, problem,
                remedy);
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
  };

  JsonPlace(std::string_view text, std::string_view path, bool whole = false)
      : begin_(text.data()), furthest_(begin_), whole_(whole), fault_(text.size()) {
    for (std::size_t from = 0; from < path.size();) {
      const auto to = std::min(path.find_first_of(".[", from + 1), path.size());
      const auto entry = path.substr(from, to - from);
      path_.emplace_back(entry.starts_with('.') ? entry.substr(1) : entry);
      from = to;
    }
    const char* const end = begin_ + text.size();
    nlohmann::json_sax<nlohmann::json>* const events = this;
    nlohmann::json::sax_parse(Cursor{begin_, &furthest_}, Cursor{end, &furthest_}, events);
  }

  /// Notes a value that is on the path; false once the last one is found.
  bool value() {
    bool on_path = open_.empty();
    if (!open_.empty()) {
      Open& top = open_.back();
      if (top.list) top.entry = "[" + std::to_string(top.index++) + "]";
      on_path = top.on_path && open_.size() <= path_.size() && top.entry == path_[open_.size() - 1];
    }
    last_on_path_ = on_path;
    if (!on_path) return true;
    // The parser has read the last byte of the value, or of its bracket; of a number, one more.
    found_ = static_cast<std::size_t>(furthest_ - begin_) - 1;
    return whole_ || open_.size() < path_.size();
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
    open_.back().entry = name;
    return true;
  }
  bool parse_error(std::size_t position, const std::string&,
                   const nlohmann::json::exception&) override {
    fault_ = position > 0 ? position - 1 : 0;
    return false;
  }

  const char* begin_;
  const char* furthest_;
  std::vector<std::string> path_;
  std::vector<Open> open_;
  bool whole_;
  bool last_on_path_ = false;
  std::size_t found_ = 0;
  std::size_t fault_;  ///< byte at which the parser gives up, be it for a number too large
};

}  // namespace lasius
