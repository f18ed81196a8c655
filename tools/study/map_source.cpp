#include "tools/study/map_source.h"

#include <algorithm>
#include <sstream>

#include "lasius/error.h"
#include "lasius/io.h"

namespace lasius::study {

bool is_generated(const std::string& source) {
  const auto size = source.find(' ') + 1;  // a file's name may have blanks, too
  const auto by = source.find_first_not_of("0123456789", size);
  return size > 0 && by != std::string::npos && by > size && source[by] == 'x';
}

MadeMap made_map(const std::string& source) {
  std::istringstream words(source);
  std::string kind, density;
  char by = 0;
  MadeMap made;
  GenerateOptions& options = made.options;
  words >> kind >> options.width >> by >> options.height >> density >> options.seed;
  const auto kinds = map_kind_names();
  const auto at = std::ranges::find(kinds, kind);
  const bool usual = density == "default";
  if (!usual) std::istringstream(density) >> options.density;
  if (!words || by != 'x' || at == kinds.end() || (!usual && !(options.density >= 0)))
    throw Error(ErrorCode::invalid_parameter, "no map is made by \"" + source + "\"",
                "say KIND WxH DENSITY SEED, as in \"blobs 200x100 default 1\"");
  made.kind = static_cast<MapKind>(at - kinds.begin());
  return made;
}

Grid load_map(const std::string& source, const std::filesystem::path& folder) {
  if (!is_generated(source)) return read_any_map((folder / source).string()).grid;
  const MadeMap made = made_map(source);
  return generate(made.kind, made.options);
}

}  // namespace lasius::study
