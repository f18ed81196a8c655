#include "core/map_files/byte_reader.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <system_error>
#include <utility>

#include "core/base/file_kind.h"
#include "core/base/opening_pipe.h"

namespace lasius {
namespace {

namespace fs = std::filesystem;

std::ifstream open(const std::string& path) {
  std::error_code error;
  if (const auto zero = path.find('\0'); zero != path.npos)
    throw Error(ErrorCode::file_missing, Error::Place{path.substr(0, zero)},
                "its name goes on after a zero byte", "no file has such a name");
  if (fs::is_directory(path, error))
    throw Error(ErrorCode::file_broken, Error::Place{path}, "is a folder", "name a file in it");
  const OpeningPipe opening(path);
  errno = 0;
  std::ifstream stream(path, std::ios::binary);
  if (!stream)
    throw Error(ErrorCode::file_missing, Error::Place{path},
                "cannot be opened (" + std::generic_category().message(errno) + ")",
                "check its name and that it may be read");
  return stream;
}

std::int64_t size_of(const std::string& path) {
  std::error_code error;
  if (!fs::is_regular_file(path, error) || error) return -1;
  const auto size = fs::file_size(path, error);
  // Files of the kernel, as in /proc, are regular, say 0 and still hold bytes.
  return error || size == 0 ? -1 : static_cast<std::int64_t>(size);
}

}  // namespace

ByteReader::ByteReader(std::istream& in, std::string name, std::int64_t size)
    : in_(&in), name_(std::move(name)), size_(size), buffer_(kBuffer) {}

std::size_t ByteReader::read(char* target, std::size_t count) {
  std::size_t done = 0;
  while (done < count && (at_ < end_ || fill())) {
    const std::size_t part = std::min(count - done, end_ - at_);
    std::memcpy(target + done, buffer_.data() + at_, part);
    at_ += part;
    done += part;
  }
  return done;
}

bool ByteReader::get_line(std::string& line, std::size_t longest) {
  line.clear();
  if (peek() == kEnd) return false;
  while (at_ < end_ || fill()) {
    std::string_view part(buffer_.data() + at_, std::min(end_ - at_, longest + 1 - line.size()));
    const std::size_t most = part.size();
    for (const char end : {'\n', '\r'}) part = part.substr(0, part.find(end));
    line.append(part);
    at_ += part.size();
    if (part.size() < most) {
      if (get() == '\r' && peek() == '\n') get();
      break;
    }
    if (line.size() > longest) break;
  }
  return true;
}

std::int64_t ByteReader::find_left() {
  if (size_ < 0) {
    const std::size_t coming = ahead(kBuffer).size();
    if (coming < kBuffer) size_ = offset() + static_cast<std::int64_t>(coming);
  }
  return left();
}

std::string_view ByteReader::ahead(std::size_t count) {
  if (end_ - at_ < count) {
    std::memmove(buffer_.data(), buffer_.data() + at_, end_ - at_);
    before_ += static_cast<std::int64_t>(at_);
    end_ -= at_;
    at_ = 0;
    if (in_->good()) {
      in_->read(buffer_.data() + end_, static_cast<std::streamsize>(kBuffer - end_));
      end_ += static_cast<std::size_t>(in_->gcount());
    }
    if (in_->bad()) fail_at_offset(offset(), "reading failed", "check the disk");
  }
  return {buffer_.data() + at_, std::min(count, end_ - at_)};
}

void ByteReader::fail_at_line(std::int64_t line, std::string problem, std::string remedy,
                              ErrorCode code) const {
  throw Error(code, Error::Place{name_, line, -1}, std::move(problem), std::move(remedy));
}

void ByteReader::fail_at_offset(std::int64_t offset, std::string problem, std::string remedy,
                                ErrorCode code) const {
  throw Error(code, Error::Place{name_, -1, offset}, std::move(problem), std::move(remedy));
}

InputFile::InputFile(const std::string& path, Empty empty)
    : stream_(open(path)), reader_(stream_, path, size_of(path)) {
  constexpr std::string_view kMark = "\xef\xbb\xbf";  // UTF-8, as some editors begin a text with
  std::array<char, kMark.size()> mark;
  if (reader_.ahead(mark.size()) == kMark) reader_.read(mark.data(), mark.size());
  if (empty == Empty::refused && reader_.peek() == ByteReader::kEnd)
    reader_.fail_at_offset(0, "is empty", "write it again");
}

std::string read_text(const std::string& path, std::int64_t most, Empty empty) {
  InputFile file(path, empty);
  ByteReader& in = file.reader();
  const auto check = [&](std::int64_t size) {
    if (size <= most) return;
    throw Error(ErrorCode::file_unsupported, Error::Place{path},
                "is larger than " + std::to_string(most) + " bytes",
                "this is " + told(kind_of(in.ahead(ByteReader::kBuffer))));
  };
  check(in.left());
  std::string text;
  while (in.peek() != ByteReader::kEnd) {
    const std::size_t before = text.size();
    text.resize(before + ByteReader::kBuffer);
    text.resize(before + in.read(text.data() + before, ByteReader::kBuffer));
    check(static_cast<std::int64_t>(text.size()));
  }
  return text;
}

}  // namespace lasius
