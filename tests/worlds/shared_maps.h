// The real maps with their exact optima, where this machine has them.
#pragma once

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "lasius/grid/grid.h"
#include "lasius/grid/map_io.h"

namespace lasius::bench_test {

struct Query {
  Cell start, goal;
  double octile, euclid;
};

struct SharedMap {
  std::string name;
  Grid grid;
  std::vector<Query> queries;
};

inline std::filesystem::path shared_dir() {
  return std::filesystem::path(LASIUS_SHARED_DIR) / "data" / "movingai";
}

/// The tables of queries, sorted by name; empty without the shared folder.
inline std::vector<std::filesystem::path> shared_tables() {
  std::vector<std::filesystem::path> found;
  if (!std::filesystem::is_directory(shared_dir())) return found;
  for (const auto& entry : std::filesystem::directory_iterator(shared_dir())) {
    if (entry.path().extension() == ".tsv") found.push_back(entry.path());
  }
  std::sort(found.begin(), found.end());
  return found;
}

inline SharedMap load_shared(const std::filesystem::path& table) {
  SharedMap map{table.stem().string(),
                read_map(std::filesystem::path(table).replace_extension(".map").string()).grid,
                {}};
  std::string word, line;
  std::ifstream queries(table);
  std::getline(queries, line);
  while (std::getline(queries, line)) {
    std::istringstream fields(line);
    Query q;
    fields >> word >> q.start.x >> q.start.y >> q.goal.x >> q.goal.y >> q.octile >> q.euclid;
    map.queries.push_back(q);
  }
  return map;
}

}  // namespace lasius::bench_test
