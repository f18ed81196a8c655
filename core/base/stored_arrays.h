// Arrays as they are in memory, for files and messages.
#pragma once

#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "lasius/base/error.h"

namespace lasius {

/// Each array is its number of elements, 8 bytes, and the elements.
class ArrayWriter {
 public:
  template <class T>
  void array(std::span<const T> values) {
    static_assert(std::is_trivially_copyable_v<T>);
    value(std::uint64_t{values.size()});
    text_.append(reinterpret_cast<const char*>(values.data()), values.size_bytes());
  }
  template <class T>
  void array(const std::vector<T>& values) {
    array(std::span<const T>(values));
  }
  template <class T>
  void value(const T& v) {
    static_assert(std::is_trivially_copyable_v<T>);
    text_.append(reinterpret_cast<const char*>(&v), sizeof v);
  }
  const std::string& text() const noexcept { return text_; }

 private:
  std::string text_;
};

/// Reads what an ArrayWriter wrote. @throws Error(file_broken) where the file says what cannot be.
class ArrayReader {
 public:
  /// @param file  its name; `before`: bytes of it that lie before `text`; `remedy`, which outlives
  ///              this: what to do where it is broken
  ArrayReader(std::string_view text, std::string file, std::size_t before,
              std::string_view remedy = "remove it, to have it made anew")
      : text_(text), file_(std::move(file)), before_(before), remedy_(remedy) {}

  template <class T>
  std::vector<T> array() {
    const auto count = value<std::uint64_t>();
    require(count <= (text_.size() - at_) / sizeof(T));
    std::vector<T> values(static_cast<std::size_t>(count));
    if (!values.empty()) std::memcpy(values.data(), text_.data() + at_, values.size() * sizeof(T));
    at_ += values.size() * sizeof(T);
    return values;
  }
  template <class T>
  T value() {
    require(sizeof(T) <= text_.size() - at_);
    T v;
    std::memcpy(&v, text_.data() + at_, sizeof v);
    at_ += sizeof v;
    return v;
  }
  void require(bool holds) const {
    if (holds) return;
    throw Error(ErrorCode::file_broken,
                {.file = file_, .offset = static_cast<std::int64_t>(before_ + at_)},
                "is damaged: its numbers do not agree", std::string(remedy_));
  }
  bool at_end() const noexcept { return at_ == text_.size(); }

 private:
  std::string_view text_;
  std::string file_;
  std::size_t before_;
  std::string_view remedy_;
  std::size_t at_ = 0;
};

}  // namespace lasius
