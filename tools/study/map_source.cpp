#include "tools/study/map_source.h"

#include <algorithm>
#include <sstream>

#include "lasius/error.h"
#include "lasius/generate.h"
#include "lasius/map_io.h"

namespace lasius::study {

bool is_generated(const std::string& source) { return source.find(' ') != std::string::npos; }

Grid load_map(const std::string& source, const std::filesystem::path& folder) {
  if (!is_generated(source)) return read_map((folder / source).string()).grid;
  std::istringstream words(source);
  std::string kind;
  char by = 0;
  GenerateOptions options;
  words >> kind >> options.width >> by >> options.height >> options.density >> options.seed;
  const auto kinds = map_kind_names();
  const auto at = std::find(kinds.begin(), kinds.end(), kind);
  if (!words || by != 'x' || at == kinds.end())
    throw Error(ErrorCode::invalid_parameter, "no map is made by \"" + source + "\"",
                "say KIND WxH DENSITY SEED");
  return generate(static_cast<MapKind>(at - kinds.begin()), options);
}

}  // namespace lasius::study
