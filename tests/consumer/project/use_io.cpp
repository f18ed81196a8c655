// lasius::io from outside: a map written as PNG into the directory argv[1] reads back the same,
// and so do parameters as JSON.
#include <lasius/io.h>

#include <string>

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  lasius::Grid grid(70, 3);
  grid.set_blocked({65, 1});
  const std::string file = std::string(argv[1]) + "/map.png";
  lasius::write_any_map(grid, file);
  const std::string json = lasius::params_to_json(lasius::Params("fan2004"));
  const bool same = lasius::params_to_json(lasius::params_from_json(json)) == json;
  return same && lasius::read_any_map(file).grid == grid ? 0 : 1;
}
