#include "tools/study/map_source.h"

#include <algorithm>
#include <iterator>
#include <sstream>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/number_text.h"
#include "lasius/base/error.h"
#include "lasius/io.h"
#include "lasius/plan/planner.h"
#include "tools/bitmap/cost_layers.h"
#include "tools/console/values.h"

namespace lasius::study {

bool is_generated(const std::string& source) {
  const auto size = source.find(' ') + 1;  // a file's name may have blanks, too
  const auto by = source.find_first_not_of("0123456789", size);
  return size > 0 && by != std::string::npos && by > size && source[by] == 'x';
}

GeneratedMap generated_map(const std::string& source) {
  std::istringstream in(source);
  const std::vector<std::string> words(std::istream_iterator<std::string>(in), {});
  GeneratedMap made;
  GenerateOptions& options = made.options;
  const auto is_made = [&] {
    if (words.size() != 4) return false;
    const auto kinds = map_kind_names();
    const auto at = std::ranges::find(kinds, words[0]);
    const std::string_view size = words[1];
    const auto by = size.find('x');
    if (at == kinds.end() || by == size.npos) return false;
    made.kind = static_cast<MapKind>(at - kinds.begin());
    const bool usual = words[2] == "default";
    const auto width = number_of<int>(size.substr(0, by));
    const auto height = number_of<int>(size.substr(by + 1));
    const auto density = usual ? options.density : tool::parse_real(words[2]).value_or(-1);
    const auto seed = number_of<std::uint64_t>(words[3]);
    if (!width || !height || !(usual || density >= 0) || !seed) return false;
    options = {*width, *height, density, *seed};
    return true;
  };
  if (!is_made())
    throw Error(ErrorCode::invalid_parameter, "no map is made by \"" + source + "\"",
                "say KIND WxH DENSITY SEED, as in \"blobs 200x100 default 1\"");
  return made;
}

Map load_framed_map(const std::string& source, const std::filesystem::path& folder) {
  if (!is_generated(source)) return read_any_map((folder / source).string());
  const GeneratedMap made = generated_map(source);
  return {generate(made.kind, made.options), std::nullopt};
}

Grid load_map(const std::string& source, const std::filesystem::path& folder) {
  return load_framed_map(source, folder).grid;
}

WeightedMap load_weighted_map(const Question& question, const std::filesystem::path& folder) {
  Map map = load_framed_map(question.map, folder);
  tool::CostLayers asked;
  for (const auto& [file, factor] : question.layers)
    asked.layers.push_back({(folder / file).string(), factor});
  CostField costs = tool::load_costs(map.grid, map.frame, asked, false, 0).field;
  return {std::move(map), std::move(costs)};
}

Grid load_map(const Question& question, const std::filesystem::path& folder) {
  Grid grid = load_weighted_map(question, folder).map.grid;
  return Planner(std::move(grid), Disc{question.radius}).passable();
}

std::pair<std::string, double> Question::ground() const {
  std::string source = map;
  for (const auto& [file, factor] : layers) source += " cost " + file + '*' + tool::to_text(factor);
  return {source, radius};
}

}  // namespace lasius::study
