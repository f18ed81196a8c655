#include "tools/tour/stops_file.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>
#include <optional>

#include "core/base/json_place.h"
#include "core/base/text_lines.h"
#include "lasius/error.h"
#include "tools/console/exit_code.h"
#include "tools/console/values.h"
#include "tools/record/json_values.h"
#include "tools/record/outputs.h"
#include "tools/record/queries.h"

namespace lasius::tool {
namespace {

constexpr const char* kForms =
    "give a TSV with columns x and y, JSON [[x, y], ...] or GeoJSON points";

class Reader {
 public:
  Reader(const std::string& file, Frame frame) : file_(file), frame_(frame) {
    auto in = opened(file, "name a file of stops: .tsv, .json or .geojson");
    text_.assign(std::istreambuf_iterator<char>(in), {});
    if (text_.starts_with("\xef\xbb\xbf")) text_.erase(0, 3);
    end_lines_in_lf(text_);
  }

  std::vector<Point> read() {
    const auto first = text_.find_first_not_of(" \t\r\n");
    if (first == text_.npos) fail(1, "is empty", kForms);
    if (text_[first] == '[' || text_[first] == '{')
      read_json();
    else
      read_table();
    if (stops_.empty()) fail(1, "holds no stop", kForms);
    return std::move(stops_);
  }

 private:
  [[noreturn]] void fail(std::int64_t line, const std::string& problem,
                         const std::string& remedy) const {
    throw Error(ErrorCode::file_broken, {.file = file_, .line = line}, problem, remedy);
  }

  void refuse(std::string_view name) const {
    for (const char* unplanned : {"after", "load", "group"})
      if (name == unplanned)
        throw UsageError(file_ + ": \"" + unplanned +
                         "\" is not planned yet: tours have no order given in part, no loads and "
                         "no groups; leave it out");
  }

  // `whole`: both were written as whole numbers.
  void add(Point p, bool whole, std::int64_t line) {
    if (stops_.size() == kMostStops)
      fail(line, "has more than " + std::to_string(kMostStops) + " stops", "part them in tours");
    if (frame_ == Frame::cell && !whole) {
      const Point cell{p.x - 0.5, p.y - 0.5};
      if (cell.x != std::floor(cell.x) || cell.y != std::floor(cell.y))
        fail(line, "(" + to_text(p.x) + ", " + to_text(p.y) + ") is no middle of a cell",
             "give a cell's column and row, whole numbers, or metres with --frame world");
      p = cell;
    }
    stops_.push_back(p);
  }

  double number(std::string_view name, std::string_view field, std::int64_t line) const {
    const auto value = parse_real(field);
    if (!value || field.find('\0') != field.npos)
      fail(line, std::string(name) + " is '" + std::string(field) + "'", "give a finite number");
    return *value;
  }

  void read_table() {
    std::vector<std::string> header;
    std::size_t x = 0, y = 1;
    bool tabs = false;
    std::int64_t line = 0;
    for (const std::string_view row : split(text_, '\n')) {
      ++line;
      if (words_of(row, kBlanks).empty()) continue;
      if (header.empty()) tabs = row.find('\t') != row.npos;
      std::vector<std::string_view> fields;
      if (tabs)
        for (const auto field : split(row, '\t')) {
          const auto words = words_of(field, " \r\v\f");
          fields.push_back(words.empty() ? field.substr(0, 0)
                                         : field.substr(words.front().data() - field.data(),
                                                        words.back().data() + words.back().size() -
                                                            words.front().data()));
        }
      else
        fields = words_of(row, kBlanks);
      if (header.empty()) {
        header.assign(fields.begin(), fields.end());
        if (!parse_real(fields.front())) {
          x = column(header, "x", line);
          y = column(header, "y", line);
          for (const auto& name : header) refuse(name);
          continue;
        }
        if (header.size() < 2) fail(line, "has no y", kForms);
      }
      if (fields.size() != header.size())
        fail(line,
             counted(static_cast<std::int64_t>(fields.size()), "field") +
                 ", but the first line has " + std::to_string(header.size()),
             "give every column a value");
      const Point p{number("x", fields[x], line), number("y", fields[y], line)};
      add(p, parse_whole(fields[x]) && parse_whole(fields[y]), line);
    }
  }

  std::size_t column(const std::vector<std::string>& header, const char* name,
                     std::int64_t line) const {
    const auto found = std::ranges::find(header, name);
    if (found == header.end()) fail(line, std::string("no column is named ") + name, kForms);
    if (std::find(found + 1, header.end(), name) != header.end())
      fail(line, std::string("two columns are named ") + name, "rename one of them");
    return static_cast<std::size_t>(found - header.begin());
  }

  void read_json() {
    const Json json = json::read(text_, file_);
    if (json.is_array())
      read_list(json, "");
    else
      read_geometry(json, "");
  }

  void read_list(const Json& list, const std::string& at) {
    for (std::size_t i = 0; i < list.size(); ++i)
      read_pair(list[i], at + "[" + std::to_string(i) + "]");
  }

  void read_pair(const Json& pair, const std::string& at) {
    const auto finite = [](const Json& value) {
      return value.is_number() && std::isfinite(value.get<double>());
    };
    if (!pair.is_array() || pair.size() < 2 || !finite(pair[0]) || !finite(pair[1]))
      fail(JsonPlace::line(text_, at), at + " is no [x, y] of finite numbers", kForms);
    add({pair[0].get<double>(), pair[1].get<double>()},
        pair[0].is_number_integer() && pair[1].is_number_integer(), JsonPlace::line(text_, at));
  }

  void read_geometry(const Json& json, const std::string& at) {
    const std::string type =
        json.is_object() && json.contains("type") && json["type"].is_string() ? json["type"] : "";
    const std::string in = at.empty() ? "" : at + ".";
    const auto part = [&](const char* key) -> const Json& {
      if (!json.contains(key))
        fail(JsonPlace::line(text_, at), "a " + type + " lacks its \"" + key + "\"", kForms);
      return json[key];
    };
    const auto all = [&](const char* key) {
      const Json& parts = part(key);
      for (std::size_t i = 0; i < parts.size(); ++i)
        read_geometry(parts.is_array() ? parts[i] : parts,
                      in + key + "[" + std::to_string(i) + "]");
    };
    if (type == "FeatureCollection") return all("features");
    if (type == "GeometryCollection") return all("geometries");
    if (type == "Feature") {
      if (json.contains("properties") && json["properties"].is_object())
        for (const auto& property : json["properties"].items()) refuse(property.key());
      return read_geometry(part("geometry"), in + "geometry");
    }
    if (type == "Point") return read_pair(part("coordinates"), in + "coordinates");
    if (type == "MultiPoint") return read_list(part("coordinates"), in + "coordinates");
    fail(JsonPlace::line(text_, at),
         (at.empty() ? "the document" : at) + " is " +
             (type.empty() ? "no GeoJSON object" : "a " + type + ", no point"),
         kForms);
  }

  static constexpr std::string_view kBlanks = " \t\r\v\f,";
  const std::string& file_;
  Frame frame_;
  std::string text_;
  std::vector<Point> stops_;
};

}  // namespace

std::vector<Point> read_stops(const std::string& file, Frame frame) {
  return Reader(file, frame).read();
}

}  // namespace lasius::tool
