#include "tools/tour/stops_file.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>

#include "core/base/did_you_mean.h"
#include "core/base/json_place.h"
#include "core/base/text_lines.h"
#include "core/tour/order/partial_order.h"
#include "lasius/base/error.h"
#include "tools/command_line/search_options.h"
#include "tools/console/exit_code.h"
#include "tools/console/values.h"
#include "tools/record/json_values.h"
#include "tools/record/outputs.h"
#include "tools/record/queries.h"
#include "tools/vehicle/vehicle_json.h"

namespace lasius::tool {
namespace {

constexpr const char* kForms =
    "give a TSV with columns x and y, JSON [[x, y], ...] or GeoJSON points";

constexpr const char* kPoses =
    "give x, y and, where it has one, the yaw; other members by their names";

constexpr const char* kNoPoses =
    "give x and y; a third number is the yaw of a vehicle's stop, with --vehicle";

// Where something is in the file: a line, or the path of a JSON value.
struct At {
  std::int64_t line = 1;
  std::string path = {};
};

// What a stop has beside its coordinates.
struct Details {
  std::string name = {};
  std::vector<std::string> after = {};
  std::optional<int> load = {};
  std::string group = {};
  std::optional<double> yaw = {};
};

class Reader {
 public:
  Reader(const std::string& file, Frame frame, bool poses)
      : file_(file), frame_(frame), poses_(poses) {
    auto in = opened(file, "name a file of stops: .tsv, .json or .geojson");
    text_.assign(std::istreambuf_iterator<char>(in), {});
    if (text_.starts_with("\xef\xbb\xbf")) text_.erase(0, 3);
    end_lines_in_lf(text_);
  }

  TourStops read() {
    const auto first = text_.find_first_not_of(" \t\r\n");
    if (first == text_.npos) fail({}, "is empty", kForms);
    if (text_[first] == '[' || text_[first] == '{')
      read_json();
    else
      read_table();
    if (stops_.points.empty()) fail({}, "holds no stop", kForms);
    add_details();
    return std::move(stops_);
  }

 private:
  static constexpr std::string_view kSeparators = " \t\r\v\f,";
  static std::string bare(std::string_view text) { return std::string(trimmed(text, " \t\r\v\f")); }

  [[noreturn]] void fail(const At& at, const std::string& problem,
                         const std::string& remedy) const {
    const auto line = at.path.empty() ? at.line : JsonPlace::line(text_, at.path);
    throw Error(ErrorCode::file_broken, {.file = file_, .line = line}, problem, remedy);
  }

  // `whole`: both were written as whole numbers.
  void add(Point p, bool whole, Details details, At at) {
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
           "give a whole number, as 1 where something is picked and -1 where it is delivered");
    return static_cast<int>(value);
  }
  double yaw(const std::string& text, const At& at) const {
    try {
      return angle_value("yaw", text, -kMostTurned, kMostTurned);
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
    bool tabs = false;
    At at{.line = 0};
    for (const std::string_view row : split(text_, '\n')) {
      ++at.line;
      if (words_of(row, kSeparators).empty()) continue;
      if (header.empty()) tabs = row.find('\t') != row.npos;
      std::vector<std::string> fields;
      if (tabs)
        for (const auto field : split(row, '\t')) fields.push_back(bare(field));
      else
        for (const auto field : words_of(row, kSeparators)) fields.emplace_back(field);
      if (header.empty()) {
        header = fields;
        if (!parse_real(fields.front())) {
          x = *column(header, "x", at);
          y = *column(header, "y", at);
          name = column(header, "name", at);
          after = column(header, "after", at);
          loads = column(header, "load", at);
          group = column(header, "group", at);
          if (poses_) yaw = column(header, "yaw", at);
          stops_.yaws_unread = !poses_ && std::ranges::count(header, "yaw") > 0;
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
        fail(at,
             counted(static_cast<std::int64_t>(fields.size()), "field") +
                 ", but the first line has " + std::to_string(header.size()),
             after ? "split columns at tabs, each name in \"after\" from the next at a comma"
                   : "give every column a value, or split at tabs, between which may be none");
      Details details;
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
      if (text_[text_.find_first_not_of(" \t\r\n")] != '[' || error.place().offset < 0) throw;
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

  void read_list(const Json& list, const std::string& path, const Details& details) {
    for (std::size_t i = 0; i < list.size(); ++i)
      read_pair(list[i], path + "[" + std::to_string(i) + "]", details);
  }

  void read_pair(const Json& pair, const std::string& path, const Details& details) {
    const auto finite = [](const Json& value) {
      return value.is_number() && std::isfinite(value.get<double>());
    };
    const auto both = [&](const Json& x, const Json& y, Details more) {
      if (!finite(x) || !finite(y))
        fail({.path = path}, path + " is no [x, y] of finite numbers", kForms);
      add({x.get<double>(), y.get<double>()}, x.is_number_integer() && y.is_number_integer(),
          std::move(more), {.path = path});
    };
    if (pair.is_object() && pair.contains("x") && pair.contains("y"))
      return both(pair["x"], pair["y"], details_of(pair, path));
    const bool long_enough = pair.is_array() && pair.size() >= 2;
    Details more = details;
    if (text_[text_.find_first_not_of(" \t\r\n")] == '[' && pair.is_array()) {  // no GeoJSON
      if (pair.size() > (poses_ ? 3 : 2))
        fail({.path = path}, path + (poses_ ? " is no [x, y, yaw]" : " is no [x, y]"),
             poses_ ? kPoses : kNoPoses);
      if (pair.size() == 3) more.yaw = yaw_of(pair[2], path);
    }
    both(long_enough ? pair[0] : Json(), long_enough ? pair[1] : Json(), std::move(more));
  }

  std::optional<double> yaw_of(const Json& value, const std::string& path) const {
    if (value.is_null()) return std::nullopt;
    return yaw(value.is_string() ? value.get<std::string>() : value.dump(), {.path = path});
  }

  Details details_of(const Json& object, const std::string& path) {
    Details details;
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
    stops_.yaws_unread |= turned != nullptr && !poses_;
    if (const Json* value = given("load"))
      details.load =
          load(value->is_number() ? value->get<double>() : 0.5, value->dump(), {.path = path});
    return details;
  }

  void read_geometry(const Json& json, const std::string& path, const Details& details) {
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
      return read_geometry(part("geometry"), in + "geometry",
                           more ? details_of(json["properties"], in + "properties") : Details{});
    }
    if (type == "Point") return read_pair(part("coordinates"), in + "coordinates", details);
    if (type == "MultiPoint") return read_list(part("coordinates"), in + "coordinates", details);
    fail({.path = path},
         (path.empty() ? "the document" : path) + " is " +
             (type.empty() ? "no GeoJSON object" : "a " + type + ", no point"),
         kForms);
  }

  // Names become indices, once all are known.
  void add_details() {
    const std::size_t n = details_.size();
    const auto any = [&](const auto& has) { return std::ranges::any_of(details_, has); };
    if (any([](const Details& one) { return !one.name.empty(); }))
      for (const Details& one : details_) stops_.names.push_back(one.name);
    if (any([](const Details& one) { return one.load.has_value(); }))
      for (const Details& one : details_) stops_.loads.push_back(one.load.value_or(0));
    if (any([](const Details& one) { return !one.group.empty(); }))
      for (const Details& one : details_) stops_.groups.push_back(one.group);
    if (any([](const Details& one) { return one.yaw.has_value(); }))
      for (const Details& one : details_) stops_.yaws.push_back(one.yaw);
    if (!any([](const Details& one) { return !one.after.empty(); })) return;
    std::map<std::string_view, std::vector<int>> named;
    std::vector<std::string_view> known;
    for (std::size_t i = 0; i < n; ++i)
      if (!details_[i].name.empty()) named[details_[i].name].push_back(static_cast<int>(i));
    for (const auto& [name, stops] : named) known.push_back(name);
    std::vector<tour::Before> relation;
    stops_.after.resize(n);
    for (std::size_t i = 0; i < n; ++i)
      for (const std::string& name : details_[i].after) {
        const auto found = named.find(name);
        if (found == named.end())
          fail(places_[i], "\"after\": no stop is named \"" + name + "\"",
               known.empty() ? "give each stop its name" : did_you_mean(name, known));
        if (found->second.size() > 1)
          fail(places_[i],
               "\"after\": stops " + std::to_string(found->second[0]) + " and " +
                   std::to_string(found->second[1]) + " are both named \"" + name + "\"",
               "give each its own name");
        stops_.after[i].push_back(found->second.front());
        relation.emplace_back(found->second.front(), static_cast<int>(i));
      }
    const std::vector<int> circle = tour::circle_of(static_cast<int>(n), relation);
    if (circle.empty()) return;
    const auto shown = [&](int stop) {
      const std::string& name = details_[static_cast<std::size_t>(stop)].name;
      return name.empty() ? "stop " + std::to_string(stop) : name;
    };
    std::string text = "\"after\" is a circle: ";
    for (const int stop : circle) text += shown(stop) + " before ";
    fail(places_[static_cast<std::size_t>(circle.front())], text + shown(circle.front()),
         "leave one of these out");
  }

  const std::string& file_;
  Frame frame_;
  bool poses_;
  std::string text_;
  TourStops stops_;
  std::vector<Details> details_;  // of the stops
  std::vector<At> places_;        // of the stops
};

}  // namespace

TourStops read_stops(const std::string& file, Frame frame, bool poses) {
  return Reader(file, frame, poses).read();
}

}  // namespace lasius::tool
