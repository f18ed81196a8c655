// Buffered reading of a stream that knows where it is, for error messages.
#pragma once

#include <cstdint>
#include <fstream>
#include <istream>
#include <string>
#include <string_view>
#include <vector>

#include "lasius/base/error.h"
#include "lasius/export.h"

namespace lasius {

// Exported for the components only; not part of the public API.
class LASIUS_EXPORT ByteReader {
 public:
  static constexpr int kEnd = -1;
  static constexpr std::size_t kBuffer = 65536;

  /// `name` is the file named in errors; `size` the bytes in the stream, -1 where unknown.
  ByteReader(std::istream& in, std::string name, std::int64_t size = -1);

  /// The next byte as 0 .. 255, or kEnd; get() also steps over it.
  int peek() { return at_ < end_ || fill() ? static_cast<unsigned char>(buffer_[at_]) : kEnd; }
  int get() {
    const int byte = peek();
    if (byte != kEnd) ++at_;
    if (byte == '\n' || (byte == '\r' && peek() != '\n')) ++line_;
    return byte;
  }
  /// Up to `count` bytes of binary data (no lines are counted); fewer only at the end.
  std::size_t read(char* target, std::size_t count);
  /// The next line without its end (LF, CR LF or CR); false at the end of the stream. A line longer
  /// than `longest` is cut one byte past it.
  bool get_line(std::string& line, std::size_t longest);
  /// Up to `count` <= kBuffer bytes to come.
  std::string_view ahead(std::size_t count);

  std::int64_t offset() const noexcept { return before_ + static_cast<std::int64_t>(at_); }
  std::int64_t line() const noexcept { return line_; }
  /// Bytes left, -1 where unknown.
  std::int64_t left() const noexcept { return size_ < 0 ? -1 : size_ - offset(); }
  /// left(), but where it is unknown, as of a pipe, up to kBuffer bytes are read ahead to learn it.
  std::int64_t find_left();
  const std::string& name() const noexcept { return name_; }

  [[noreturn]] void fail_at_line(std::int64_t line, std::string problem, std::string remedy,
                                 ErrorCode code = ErrorCode::file_broken) const;
  [[noreturn]] void fail_at_offset(std::int64_t offset, std::string problem, std::string remedy,
                                   ErrorCode code = ErrorCode::file_broken) const;

 private:
  bool fill() { return !ahead(1).empty(); }

  std::istream* in_;
  std::string name_;
  std::int64_t size_;
  std::vector<char> buffer_;
  std::size_t at_ = 0;
  std::size_t end_ = 0;
  std::int64_t before_ = 0;  // bytes of the stream before the buffer
  std::int64_t line_ = 1;
};

/// Whether a file without a byte can be what is wanted.
enum class Empty { refused, taken };

/// A file opened for reading, past its byte order mark if it has one. @throws Error(file_missing),
/// Error(file_broken) for a folder or, where that is refused, an empty file.
class LASIUS_EXPORT InputFile {
 public:
  explicit InputFile(const std::string& path, Empty empty = Empty::refused);
  InputFile(const InputFile&) = delete;  // the reader points into it
  InputFile& operator=(const InputFile&) = delete;
  ByteReader& reader() noexcept { return reader_; }

 private:
  std::ifstream stream_;
  ByteReader reader_;
};

/// A file read whole. @throws Error as InputFile, Error(file_unsupported) above `most` bytes.
LASIUS_EXPORT std::string read_text(const std::string& path, std::int64_t most,
                                    Empty empty = Empty::refused);

}  // namespace lasius
