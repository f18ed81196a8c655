// Files made by tests in a folder of their own, and maps drawn as text.
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "lasius/grid.h"
#include "lasius/map_io.h"

namespace lasius {

namespace fs = std::filesystem;

class Files : public testing::Test {
 protected:
  Files() {
    std::string name = (fs::temp_directory_path() / "lasius-map-io-XXXXXX").string();
    folder_ = ::mkdtemp(name.data());
  }
  ~Files() override { fs::remove_all(folder_); }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  std::string file(const std::string& content, const std::string& name = "map") const {
    std::ofstream(path(name), std::ios::binary) << content;
    return path(name);
  }
  Grid read(const std::string& content, const ReadOptions& options = {}) const {
    return read_map(file(content), options).grid;
  }
  std::vector<std::string> files() const {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder_)) {
      names.push_back(entry.path().filename().string());
    }
    return names;
  }

 private:
  fs::path folder_;
};

// Rows of '#' (blocked) and '.'.
inline Grid grid_of(const std::vector<std::string>& rows) {
  Grid grid(static_cast<int>(rows[0].size()), static_cast<int>(rows.size()));
  for (int y = 0; y < grid.height(); ++y) {
    for (int x = 0; x < grid.width(); ++x) grid.set_blocked({x, y}, rows[y][x] == '#');
  }
  return grid;
}

}  // namespace lasius
