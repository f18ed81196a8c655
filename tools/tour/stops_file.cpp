#include "tools/tour/stops_file.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>

#include "core/base/did_you_mean.h"
#include "core/base/json_place.h"
#include "core/base/text_lines.h"
#include "lasius/base/error.h"
#include "tools/command_line/search_options.h"
#include "tools/console/exit_code.h"
#include "tools/console/values.h"
#include "tools/record/json_values.h"
#include "tools/record/outputs.h"
#include "tools/record/queries.h"
#include "tools/tour/stop_details.h"
#include "tools/vehicle/vehicle_json.h"

namespace lasius::tool {
namespace {

constexpr const char* kForms =
    "give a table with columns x and y, JSON [[x, y], ...] or GeoJSON points";

constexpr const char* kPoses =
    "give x, y and, where it has one, the yaw; other members by their names";

constexpr const char* kNoPoses =
    "give x and y; a third number is the yaw of a vehicle's stop, with --vehicle";

// Where something is in the file: a line, or the path of a JSON value.
struct At {
  std::int64_t line = 1;
  std::string path = {};
};

class Reader {
 public:
  Reader(const std::string& file, Frame frame, bool poses)
      : file_(file),
        frame_(frame),
        poses_(poses),
        text_(table_text(file, "name a file of stops: .tsv, .json or .geojson")) {}

  TourStops read() {
    if (first() == text_.size()) fail({}, "is empty", kForms);
    if (is_list() || text_[first()] == '{')
      read_json();
    else
      read_table();
    if (stops_.points.empty()) fail({}, "holds no stop", kForms);
    add_details(details_, stops_,
                [this](int stop, const std::string& problem, const std::string& remedy) {
                  fail(places_[static_cast<std::size_t>(stop)], problem, remedy);
                });
    note_unread();
    return std::move(stops_);
  }

 private:
  static constexpr std::string_view kNames[] = {"x", "y", "name", "after", "load", "group", "yaw"};
  static std::string bare(std::string_view text) {
    return std::string(trimmed(text, kBlanksOfLines));
  }

  [[noreturn]] void fail(const At& at, const std::string& problem,
                         const std::string& remedy) const {
    const auto line = at.path.empty() ? at.line : JsonPlace::line(text_, at.path);
    throw Error(ErrorCode::file_broken, {.file = file_, .line = line}, problem, remedy);
  }

  std::size_t first() const { return std::min(text_.find_first_not_of(" \t\r\n"), text_.size()); }
  bool is_list() const { return text_[first()] == '['; }  // of JSON, no GeoJSON

  // `whole`: both were written as whole numbers.
  void add(Point p, bool whole, StopDetails details, At at) {
    if (stops_.points.size() == kMostStops)
      fail(at, "has more than " + std::to_string(kMostStops) + " stops", "part them in tours");
    stops_.points.push_back({p, frame_ == Frame::world || !whole});
    details_.push_back(std::move(details));
    places_.push_back(std::move(at));
  }

  double number(std::string_view name, std::string_view field, const At& at) const {
    const auto value = parse_real(field);
    if (!value || field.find('\0') != field.npos)
      fail(at, std::string(name) + " is '" + std::string(field) + "'", "give a finite number");
    return *value;
  }
  int load(double value, std::string_view text, const At& at) const {
    if (value != std::floor(value) || std::abs(value) > TourCommand::kMostLoad)
      fail(at, "load is '" + std::string(text) + "'",
           "give a whole number of at most " + std::to_string(TourCommand::kMostLoad) +
               ", as 1 where something is picked and -1 where it is delivered");
    return static_cast<int>(value);
  }
  double yaw(const std::string& text, const At& at) {
    try {
      const double yaw = angle_value("yaw", text, -kMostTurned, kMostTurned);
      if (turned_.empty()) turned_ = turns_hint(text, yaw);
      return yaw;
    } catch (const UsageError& error) {
      fail(at, error.what(), "leave it empty where any will do");
    }
  }
  static std::vector<std::string> names_in(std::string_view list) {
    std::vector<std::string> names;
    for (const auto part : split(list, ','))
      if (std::string name = bare(part); !name.empty()) names.push_back(std::move(name));
    return names;
  }

  void read_table() {
    std::vector<std::string> header;
    std::size_t x = 0, y = 1;
    std::optional<std::size_t> name, after, loads, group, yaw;
    char separator = ' ';
    bool named = false;
    At at{.line = 0};
    for (const std::string_view row : split(text_, '\n')) {
      ++at.line;
      if (words_of(row, kBlanksAndCommas).empty()) continue;
      if (header.empty()) separator = separator_of(row);
      std::vector<std::string> fields = fields_of(row, separator, kBlanksAndCommas);
      if (fields.empty()) fail(at, "a quote is not closed", "close it in its line");
      const bool numbers = header.empty() && parse_real(fields.front());
      if (numbers || !header.empty())
        leave_out_empty(fields, numbers ? (poses_ ? 3 : 2) : header.size());
      if (header.empty()) {
        header = fields;
        named = !numbers;
        if (named) {
          x = *column(header, "x", at);
          y = *column(header, "y", at);
          name = column(header, "name", at);
          after = column(header, "after", at);
          loads = column(header, "load", at);
          group = column(header, "group", at);
          if (poses_) yaw = column(header, "yaw", at);
          for (const std::string& one : header) note_name(one, true);
          continue;
        }
        if (header.size() < 2) fail(at, "has no y", kForms);
        if (header.size() > (poses_ ? 3 : 2))
          fail(at,
               poses_ ? "names no columns, and has more than x y yaw"
                      : "names no columns, and has more than x y",
               poses_ ? kPoses : kNoPoses);
        if (poses_ && header.size() == 3) yaw = 2;
      }
      if (fields.size() != header.size())
        fail(
            at,
            counted(static_cast<std::int64_t>(fields.size()), "field") +
                ", but the first line has " + std::to_string(header.size()),
            separator == ',' && fields.size() > header.size()
                ? "put quotes about a field that has commas in it"
            : after
                ? "split columns at tabs, each name in \"after\" from the next at a comma"
                : "give every column a value, or split columns at tabs, between which may be none");
      StopDetails details;
      if (name) details.name = fields[*name];
      if (after) details.after = names_in(fields[*after]);
      if (loads && !fields[*loads].empty())
        details.load = load(number("load", fields[*loads], at), fields[*loads], at);
      if (group) details.group = fields[*group];
      if (yaw && !fields[*yaw].empty()) details.yaw = this->yaw(fields[*yaw], at);
      add({number("x", fields[x], at), number("y", fields[y], at)},
          parse_whole(fields[x]) && parse_whole(fields[y]), std::move(details), at);
    }
  }

  std::optional<std::size_t> column(const std::vector<std::string>& header, const std::string& name,
                                    const At& at) const {
    const auto found = std::ranges::find(header, name);
    if (found == header.end()) {
      if (name == "x" || name == "y") fail(at, "no column is named " + name, kForms);
      return std::nullopt;
    }
    if (std::find(found + 1, header.end(), name) != header.end())
      fail(at, "two columns are named " + name, "rename one of them");
    return static_cast<std::size_t>(found - header.begin());
  }

  void read_json() {
    Json json;
    try {
      json = json::read(text_, file_);
    } catch (const Error& error) {
      if (!is_list() || error.place().offset < 0) throw;
      fail({.line = error.place().line},
           error.problem() + ", in or behind stop " +
               std::to_string(stops_up_to(error.place().offset)),
           error.remedy());
    }
    if (json.is_array())
      read_list(json, "", {});
    else
      read_geometry(json, "", {});
  }

  // The index of the entry of the list at a byte.
  std::int64_t stops_up_to(std::int64_t byte) const {
    std::int64_t index = 0;
    int depth = 0;
    bool quoted = false;
    for (std::size_t i = 0; i < std::min<std::size_t>(static_cast<std::size_t>(byte), text_.size());
         ++i) {
      const char c = text_[i];
      if (quoted && c == '\\') ++i;
      if (c == '"') quoted = !quoted;
      if (quoted) continue;
      depth += (c == '[' || c == '{') - (c == ']' || c == '}');
      if (c == ',' && depth == 1) ++index;
    }
    return index;
  }

  void read_list(const Json& list, const std::string& path, const StopDetails& details) {
    for (std::size_t i = 0; i < list.size(); ++i)
      read_pair(list[i], path + "[" + std::to_string(i) + "]", details);
  }

  void read_pair(const Json& pair, const std::string& path, const StopDetails& details) {
    const auto finite = [](const Json& value) {
      return value.is_number() && std::isfinite(value.get<double>());
    };
    const auto both = [&](const Json& x, const Json& y, StopDetails more) {
      if (!finite(x) || !finite(y))
        fail({.path = path}, path + " is no [x, y] of finite numbers", kForms);
      add({x.get<double>(), y.get<double>()}, x.is_number_integer() && y.is_number_integer(),
          std::move(more), {.path = path});
    };
    if (pair.is_object() && pair.contains("x") && pair.contains("y"))
      return both(pair["x"], pair["y"], details_of(pair, path));
    const bool long_enough = pair.is_array() && pair.size() >= 2;
    StopDetails more = details;
    if (is_list() && pair.is_array()) {
      if (pair.size() > (poses_ ? 3 : 2))
        fail({.path = path}, path + (poses_ ? " is no [x, y, yaw]" : " is no [x, y]"),
             poses_ ? kPoses : kNoPoses);
      if (pair.size() == 3) more.yaw = yaw_of(pair[2], path);
    }
    both(long_enough ? pair[0] : Json(), long_enough ? pair[1] : Json(), std::move(more));
  }

  std::optional<double> yaw_of(const Json& value, const std::string& path) {
    if (value.is_null()) return std::nullopt;
    return yaw(value.is_string() ? value.get<std::string>() : value.dump(), {.path = path});
  }

  StopDetails details_of(const Json& object, const std::string& path) {
    StopDetails details;
    const auto given = [&](const char* key) -> const Json* {
      return object.contains(key) && !object[key].is_null() ? &object[key] : nullptr;
    };
    const auto text_of = [&](const Json& value, const char* key) -> std::string {
      if (value.is_string()) return value.get<std::string>();
      if (value.is_number_integer()) return value.dump();
      fail({.path = path}, std::string("\"") + key + "\" is " + value.dump(),
           "give a name, or with \"after\" a list of names");
    };
    if (const Json* name = given("name")) details.name = bare(text_of(*name, "name"));
    if (const Json* group = given("group")) details.group = bare(text_of(*group, "group"));
    if (const Json* after = given("after")) {
      if (after->is_array())
        for (const Json& one : *after) details.after.push_back(bare(text_of(one, "after")));
      else
        details.after = names_in(text_of(*after, "after"));
    }
    const Json* const turned = given("yaw");
    if (turned != nullptr && poses_) details.yaw = yaw_of(*turned, path);
    for (const auto& [member, value] : object.items())
      if (!value.is_null()) note_name(member, is_list());
    if (const Json* value = given("load"))
      details.load =
          load(value->is_number() ? value->get<double>() : 0.5, value->dump(), {.path = path});
    return details;
  }

  void read_geometry(const Json& json, const std::string& path, const StopDetails& details) {
    const std::string type =
        json.is_object() && json.contains("type") && json["type"].is_string() ? json["type"] : "";
    const std::string in = path.empty() ? "" : path + ".";
    const auto part = [&](const char* key) -> const Json& {
      if (!json.contains(key))
        fail({.path = path}, "a " + type + " lacks its \"" + key + "\"", kForms);
      return json[key];
    };
    const auto all = [&](const char* key) {
      const Json& parts = part(key);
      for (std::size_t i = 0; i < parts.size(); ++i)
        read_geometry(parts.is_array() ? parts[i] : parts, in + key + "[" + std::to_string(i) + "]",
                      details);
    };
    if (type == "FeatureCollection") return all("features");
    if (type == "GeometryCollection") return all("geometries");
    if (type == "Feature") {
      const bool more = json.contains("properties") && json["properties"].is_object();
      if (part("geometry").is_null())
        fail({.path = in + "geometry"}, in + "geometry is null: the stop has no place",
             "give a point, or leave the feature out");
      return read_geometry(
          part("geometry"), in + "geometry",
          more ? details_of(json["properties"], in + "properties") : StopDetails{});
    }
    if (type == "Point") return read_pair(part("coordinates"), in + "coordinates", details);
    if (type == "MultiPoint") return read_list(part("coordinates"), in + "coordinates", details);
    fail({.path = path},
         (path.empty() ? "the document" : path) + " is " +
             (type.empty() ? "no GeoJSON object" : "a " + type + ", no point"),
         kForms);
  }

  // A column or member that is not read; of GeoJSON's, which others made, no more than those that
  // may be meant.
  void note_name(const std::string& name, bool ours) {
    if (name.empty() || !named_.insert(name).second) return;
    if ((poses_ || name != "yaw") && std::ranges::count(kNames, name) > 0) return;
    const auto meant = nearest_name(name, kNames);
    const auto nearly = [&] {
      std::string small = name;
      for (char& c : small) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
      return small == *meant ||
             (meant->size() > 3 && small[0] == (*meant)[0] && edit_distance(small, *meant) < 2);
    };
    if (ours || (meant && nearly())) unread_.insert(name);
  }
  void note_unread() {
    if (!turned_.empty()) stops_.notes.push_back(file_ + ": a yaw" + turned_);
    if (unread_.erase("yaw") > 0)
      stops_.notes.push_back(file_ + ": its yaws have no effect without --vehicle");
    std::string text;
    constexpr std::size_t kTold = 10;
    std::size_t told = 0;
    for (const std::string& name : unread_) {
      if (told++ == kTold) {
        text += " and " + std::to_string(unread_.size() - kTold) + " more";
        break;
      }
      text += (text.empty() ? "\"" : ", \"") + name + "\"";
      if (const auto meant = nearest_name(name, kNames))
        text.append(" (did you mean \"").append(*meant).append("\"?)");
    }
    if (!text.empty()) stops_.notes.push_back(file_ + ": not read: " + text);
  }

  const std::string& file_;
  Frame frame_;
  bool poses_;
  std::string text_;
  TourStops stops_;
  std::vector<StopDetails> details_;      // of the stops
  std::vector<At> places_;                // of the stops
  std::set<std::string> named_, unread_;  // columns and members, and those to be told
  std::string turned_;                    // of the first yaw of several turns
};

}  // namespace

TourStops read_stops(const std::string& file, Frame frame, bool poses) {
  return Reader(file, frame, poses).read();
}

}  // namespace lasius::tool
