// lasius::io from outside: a map written as PNG into the directory argv[1] reads back the same.
#include <lasius/io.h>

#include <string>

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  lasius::Grid grid(70, 3);
  grid.set_blocked({65, 1});
  const std::string file = std::string(argv[1]) + "/map.png";
  lasius::write_any_map(grid, file);
  return lasius::read_any_map(file).grid == grid ? 0 : 1;
}
