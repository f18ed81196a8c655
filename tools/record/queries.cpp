#include "tools/record/queries.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <iterator>
#include <string_view>

#include "core/base/opening_pipe.h"
#include "lasius/base/error.h"
#include "tools/console/values.h"

namespace lasius::tool {
namespace {

constexpr const char* kRemedyMissing = "name a .scen, .tsv or .csv file of queries";

constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";  // some editors begin a text with it

/// The lines of a file that are not blank, with their numbers.
class Lines {
 public:
  Lines(std::istream& in, const std::string& file) : file_(file), in_(in) {}

  bool next() {
    while (next_of_any()) {
      if (number_++ == 0 && text_.starts_with(kByteOrderMark))
        text_.remove_prefix(kByteOrderMark.size());
      if (!trimmed(text_, kBlanksOfLines).empty()) return true;
    }
    if (in_.bad())
      throw Error(ErrorCode::file_broken, {.file = file_, .line = number_}, "cannot be read on",
                  "check the file and its disk");
    return false;
  }

  std::string_view text() const { return text_; }

  [[noreturn]] void fail(const std::string& problem, const std::string& remedy) const {
    throw Error(ErrorCode::file_broken, {.file = file_, .line = std::max<std::int64_t>(number_, 1)},
                problem, remedy);
  }

  double coordinate(std::string_view name, std::string_view field, bool whole,
                    bool metres = false) const {
    if (field.find('\0') != std::string_view::npos)
      fail(std::string(name) + " holds a zero byte", "leave it out");
    if (whole) {
      if (const auto value = parse_whole(field)) return *value;
    } else if (const auto value = parse_real(field)) {
      return *value;
    }
    fail(std::string(name) + " is '" + std::string(field) + "'",
         metres  ? "give a whole number, or metres with --frame world"
         : whole ? "give a whole number for a cell, or decimals for a point"
                 : "give a finite number");
  }

 private:
  /// The next line, be it blank; lines end in LF, CR LF or CR.
  bool next_of_any() {
    if (at_ >= block_.size()) {
      if (!std::getline(in_, block_)) return false;
      if (block_.ends_with('\r')) block_.pop_back();
      at_ = 0;
    }
    const auto end = std::min(block_.find('\r', at_), block_.size());
    text_ = std::string_view(block_).substr(at_, end - at_);
    at_ = end + 1;
    return true;
  }

  std::string file_;
  std::istream& in_;
  std::string block_;  ///< up to an LF
  std::size_t at_ = 0;
  std::string_view text_;
  std::int64_t number_ = 0;
};

constexpr std::array<std::string_view, 4> kColumnNames{"sx", "sy", "gx", "gy"};

QueryFile::Line make_line(const std::array<double, 4>& values, bool from_point = false,
                          bool to_point = false) {
  return {{{values[0], values[1]}, from_point}, {{values[2], values[3]}, to_point}};
}

/// By the first line.
bool is_scenario(const Lines& lines) {
  const auto first = words_of(lines.text(), kBlanksOfLines);
  constexpr std::size_t kLeastColumns = 4;  // of a table, one of which may be its version
  return first.front() == "version" && first.size() < kLeastColumns;
}

QueryFile read_scenario(Lines& lines, int width, int height) {
  const auto version = words_of(lines.text(), kBlanksOfLines);
  if (version.size() != 2 || (version[1] != "1" && version[1] != "1.0"))
    lines.fail("the first line is not 'version 1'", "only scenarios of version 1 are read");
  QueryFile file{.queries = {}, .scenario = true};
  while (lines.next()) {
    auto fields = words_of(lines.text(), kBlanksOfLines);
    constexpr std::size_t kFields = 9;
    const auto fail_count = [&, count = fields.size()] {
      lines.fail(
          std::to_string(count) + " fields instead of 9",
          "write: bucket map width height sx sy gx gy optimal; only the map may have blanks");
    };
    if (fields.size() < kFields) fail_count();
    // A map's name with blanks: the fields behind it are counted from the right.
    const bool blanks = fields.size() > kFields;
    fields.erase(fields.begin() + 2, fields.end() - (kFields - 2));
    if (blanks && (parse_whole(fields[2]) != width || parse_whole(fields[3]) != height ||
                   !parse_real(fields[8])))
      fail_count();
    if (!parse_whole(fields[0]) || !parse_real(fields[8]))
      lines.fail("bucket or optimal length is not a number", "write numbers there");
    const double w = lines.coordinate("width", fields[2], true);
    const double h = lines.coordinate("height", fields[3], true);
    if (w != width || h != height)
      lines.fail("made for a map of " + to_text(w) + " x " + to_text(h) + ", this one has " +
                     std::to_string(width) + " x " + std::to_string(height),
                 "name the map that the scenario is for");
    std::array<double, 4> values;
    for (std::size_t i = 0; i < 4; ++i)
      values[i] = lines.coordinate(kColumnNames[i], fields[4 + i], true);
    file.queries.push_back(make_line(values));
  }
  return file;
}

QueryFile read_rows(Lines& lines, bool whole, bool metres) {
  const char separator = separator_of(lines.text());
  const std::vector<std::string> header = fields_of(lines.text(), separator);
  std::array<std::size_t, 4> column;
  for (std::size_t i = 0; i < 4; ++i) {
    const auto found = std::find(header.begin(), header.end(), kColumnNames[i]);
    if (found == header.end())
      lines.fail("neither 'version 1' nor a header with columns sx sy gx gy",
                 "name a MovingAI .scen, or a table with such a header");
    if (std::find(found + 1, header.end(), kColumnNames[i]) != header.end())
      lines.fail("two columns are named " + std::string(kColumnNames[i]), "rename one of them");
    column[i] = static_cast<std::size_t>(found - header.begin());
  }
  QueryFile file;
  for (const std::string_view name : {"syaw", "gyaw"})
    file.yaws |= std::ranges::count(header, name) > 0;
  while (lines.next()) {
    auto fields = fields_of(lines.text(), separator);
    if (fields.empty()) lines.fail("a quote is not closed", "close it in its line");
    leave_out_empty(fields, header.size());
    if (fields.size() != header.size())
      lines.fail(std::to_string(fields.size()) + " fields, but the header has " +
                     std::to_string(header.size()),
                 "give every column a value");
    std::array<double, 4> values;
    std::array<bool, 2> point{!whole, !whole};
    for (std::size_t i = 0; i < 4; ++i) point[i / 2] |= is_point(fields[column[i]]);
    for (std::size_t i = 0; i < 4; ++i)
      values[i] = lines.coordinate(kColumnNames[i], fields[column[i]], !point[i / 2], metres);
    file.queries.push_back(make_line(values, point[0], point[1]));
  }
  return file;
}

}  // namespace

std::string table_text(const std::string& file, const std::string& remedy) {
  auto in = opened(file, remedy);
  std::string text(std::istreambuf_iterator<char>(in), {});
  if (text.starts_with(kByteOrderMark)) text.erase(0, kByteOrderMark.size());
  end_lines_in_lf(text);
  return text;
}

char separator_of(std::string_view first) {
  for (const char one : {'\t', ','})
    if (first.find(one) != first.npos) return one;
  return ' ';
}

std::vector<std::string> fields_of(std::string_view line, char separator, std::string_view blanks) {
  if (separator == ',') return csv_fields(line);
  std::vector<std::string> fields;
  for (const auto field : separator == ' ' ? words_of(line, blanks) : split(line, separator))
    fields.emplace_back(trimmed(field, kBlanksOfLines));
  return fields;
}

void leave_out_empty(std::vector<std::string>& fields, std::size_t most) {
  while (fields.size() > most && fields.back().empty()) fields.pop_back();
}

QueryFile read_queries(std::istream& in, const std::string& file, int width, int height, bool whole,
                       bool metres) {
  Lines lines(in, file);
  if (!lines.next())
    lines.fail("is empty", "name a MovingAI .scen, or a table with columns sx sy gx gy");
  if (is_scenario(lines)) return read_scenario(lines, width, height);
  return read_rows(lines, whole, metres);
}

std::ifstream opened(const std::string& file, const std::string& remedy) {
  std::ifstream in;
  std::error_code ignored;
  errno = 0;
  const OpeningPipe opening(file);
  if (!std::filesystem::is_directory(file, ignored)) in.open(file, std::ios::binary);
  if (!in.is_open())
    throw Error(ErrorCode::file_missing, {.file = file},
                std::string("cannot be opened: ") + std::strerror(errno != 0 ? errno : EISDIR),
                remedy);
  return in;
}

QueryFile read_queries(const std::string& file, int width, int height, bool whole, bool metres) {
  auto in = opened(file, kRemedyMissing);
  return read_queries(in, file, width, height, whole, metres);
}

QueryFile read_table(const std::string& file) {
  auto in = opened(file, kRemedyMissing);
  Lines lines(in, file);
  constexpr const char* kRemedy = "give a table with columns sx sy gx gy";
  if (!lines.next()) lines.fail("is empty", kRemedy);
  if (is_scenario(lines)) lines.fail("is a scenario, of a bitmap's cells", kRemedy);
  return read_rows(lines, false, false);
}

}  // namespace lasius::tool
