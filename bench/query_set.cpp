#include "bench/query_set.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <random>
#include <string_view>

#include "core/base/number_text.h"
#include "core/base/text_lines.h"
#include "core/grid/components.h"
#include "lasius/base/error.h"
#include "lasius/grid/map_io.h"

namespace lasius::bench {
namespace {

namespace fs = std::filesystem;

// Where the fields of a query stand in a line.
struct Columns {
  std::size_t sx = 4, sy = 5, gx = 6, gy = 7;  // of a .scen
  std::size_t optimum = ~std::size_t{0};
};

constexpr std::string_view kBlanks = " \t\r\v\f";

Columns columns_of(const std::vector<std::string_view>& header, const std::string& path) {
  const auto find = [&](const char* name) {
    const auto it = std::find(header.begin(), header.end(), name);
    return static_cast<std::size_t>(it - header.begin());
  };
  Columns columns{find("sx"), find("sy"), find("gx"), find("gy")};
  if (std::max({columns.sx, columns.sy, columns.gx, columns.gy}) == header.size()) {
    throw Error(ErrorCode::file_broken, {path, 1}, "the header lacks one of sx sy gx gy",
                "name these columns in the first line");
  }
  if (find("euclid") < header.size()) columns.optimum = find("euclid");
  return columns;
}

// A field as a number; false where there is none.
template <class Number>
bool take(const std::vector<std::string_view>& fields, std::size_t column, Number& to) {
  if (column >= fields.size()) return false;
  const auto number = number_of<Number>(fields[column]);
  if (number) to = *number;
  return number.has_value();
}

// The table that belongs to a map: NAME.tsv, else NAME.map.scen or NAME.scen; empty without one.
std::string table_of(const fs::path& map) {
  for (const fs::path& table : {fs::path(map).replace_extension(".tsv"), fs::path(map) += ".scen",
                                fs::path(map).replace_extension(".scen")}) {
    if (fs::exists(table)) return table.string();
  }
  return {};
}

void add_map(const fs::path& map, std::vector<QuerySource>& sources) {
  sources.push_back({.name = map.stem().string(), .map = map.string(), .table = table_of(map)});
}

// Two different cells that are joined; tries a bounded number of pairs.
Query random_query(const Grid& grid, const Components& components, std::mt19937_64& random) {
  const auto cell = [&] {
    return Cell{static_cast<int>(random() % static_cast<std::uint64_t>(grid.width())),
                static_cast<int>(random() % static_cast<std::uint64_t>(grid.height()))};
  };
  for (int i = 0; i < 1'000'000; ++i) {
    const Cell a = cell(), b = cell();
    if (a != b && grid.free(a) && grid.free(b) && components.connected(grid, a, b)) return {a, b};
  }
  throw Error(ErrorCode::invalid_parameter, "a map has no two joined cells", "use another map");
}

}  // namespace

std::vector<Query> read_queries(const std::string& path) {
  std::ifstream in(path);
  if (!in) throw Error(ErrorCode::file_missing, {path}, "cannot be opened", "check the name");
  std::string line;
  std::getline(in, line);
  const auto header = words_of(line, kBlanks);
  const bool scen = !header.empty() && header[0] == "version";
  const Columns columns = scen ? Columns{} : columns_of(header, path);
  std::vector<Query> queries;
  for (std::int64_t number = 2; std::getline(in, line); ++number) {
    const auto fields = words_of(line, kBlanks);
    if (fields.empty()) continue;
    Query q;
    bool good = take(fields, columns.sx, q.start.x) && take(fields, columns.sy, q.start.y) &&
                take(fields, columns.gx, q.goal.x) && take(fields, columns.gy, q.goal.y);
    if (columns.optimum < fields.size()) good = take(fields, columns.optimum, q.optimum) && good;
    if (!good)
      throw Error(ErrorCode::file_broken, {path, number}, "not a query", "give sx sy gx gy");
    queries.push_back(q);
  }
  return queries;
}

std::vector<QuerySource> find_sources(const std::vector<std::string>& names) {
  std::vector<QuerySource> sources;
  for (const std::string& name : names) {
    const fs::path path(name);
    if (fs::is_directory(path)) {
      std::vector<fs::path> maps;
      for (const auto& entry : fs::directory_iterator(path)) {
        if (entry.path().extension() == ".map" && !table_of(entry.path()).empty()) {
          maps.push_back(entry.path());
        }
      }
      std::sort(maps.begin(), maps.end());
      for (const auto& map : maps) add_map(map, sources);
    } else if (!fs::exists(path)) {
      throw Error(ErrorCode::file_missing, {name}, "no such file or folder", "check the name");
    } else if (path.extension() == ".tsv" || path.extension() == ".scen") {
      fs::path map = fs::path(path).replace_extension(".map");
      if (!fs::exists(map)) map = fs::path(path).replace_extension();  // NAME.map.scen
      sources.push_back({.name = map.stem().string(), .map = map.string(), .table = name});
    } else {
      add_map(path, sources);
    }
  }
  return sources;
}

std::vector<QuerySource> generated_sources(const std::vector<int>& sides, std::uint64_t seed) {
  std::vector<QuerySource> sources;
  const auto names = map_kind_names();
  for (const int side : sides) {
    for (std::size_t k = 0; k < names.size(); ++k) {
      const auto kind = static_cast<MapKind>(k);
      const auto add = [&](double density, const std::string& suffix) {
        sources.push_back({.name = std::string(names[k]) + suffix + "-" + std::to_string(side),
                           .kind = kind,
                           .options = {side, side, density, seed}});
      };
      if (kind != MapKind::random) {
        add(-1, "");
        continue;
      }
      for (const int percent : {10, 20, 30, 40}) add(percent / 100.0, std::to_string(percent));
    }
  }
  return sources;
}

std::vector<QuerySource> noise_sources(const std::vector<int>& sides, std::uint64_t seed) {
  std::vector<QuerySource> sources;
  for (const int side : sides) {
    for (const char* percent : {"0.5", "1", "2", "5", "10", "20", "30", "40"}) {
      sources.push_back({.name = std::string("noise") + percent + "-" + std::to_string(side),
                         .kind = MapKind::random,
                         .options = {side, side, std::stod(percent) / 100, seed}});
    }
  }
  return sources;
}

QuerySet load(const QuerySource& source, std::size_t count) {
  const auto grid = [&] {
    return source.map.empty() ? generate(source.kind, source.options) : read_map(source.map).grid;
  };
  QuerySet set{source.name, grid(), {}};
  if (!source.table.empty()) {
    const auto all = read_queries(source.table);
    const std::size_t n = count == 0 ? all.size() : std::min(count, all.size());
    for (std::size_t i = 0; i < n; ++i) set.queries.push_back(all[i * all.size() / n]);
    return set;
  }
  const Components components(set.grid, Components::Connectivity::four);
  std::mt19937_64 random(source.options.seed);
  for (std::size_t i = 0; i < (count == 0 ? 30 : count); ++i) {
    set.queries.push_back(random_query(set.grid, components, random));
  }
  return set;
}

}  // namespace lasius::bench
