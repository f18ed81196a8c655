// The kinds of problem that there are: who plans on each, and whose saved results are whose.
#pragma once

#include <array>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lasius/params/params.h"

namespace lasius::tool {

class Problem;
struct Recorded;

/// A kind of problem. A new one is a folder, and a row of tools/kinds.cpp.
struct ProblemKind {
  using Json = nlohmann::ordered_json;

  // Who plans. A kind that this program was built without has no algorithms, nor has one that plans
  // by those of another.
  std::string_view key = {};                    ///< in the JSON of `algorithms`
  std::string_view title = {};                  ///< in its text; empty for bitmaps
  std::string_view plans = {};                  ///< what its algorithms do, as in "among polygons"
  std::string_view detail = {};                 ///< said behind that
  std::string_view advice = {};                 ///< for those who ask one of them elsewhere
  std::vector<std::string_view> commands = {};  ///< that run them
  bool (*takes)(std::string_view file) =
      nullptr;  ///< where commands are of several kinds: its maps
  std::span<const Algorithm> algorithms = {};
  std::string (*default_text)(const Algorithm&, std::string_view parameter, Preset) = nullptr;
  std::vector<std::string> (*formulas)(const Algorithm&) = nullptr;

  // Saved results.
  std::string_view format = {};
  bool (*wrote)(const Json& result) = nullptr;  ///< of several kinds of one format
  /// Its question. `last`, perhaps null, is the one before, whose map the lines of a batch share.
  /// @throws Error, UsageError for what is missing or no such value
  std::unique_ptr<Problem> (*again)(const Recorded&, const Problem* last) = nullptr;
  std::string (*unlike)(const Json& result) = nullptr;  ///< why it would come out other; or empty
  /// Leaves out of a result of an older version what this one does not tell. Null: nothing.
  void (*forget)(Json& result) = nullptr;
  /// No clock took part in its Status::limit. Null: one does.
  bool (*counted)(const Json& result) = nullptr;
};

/// All of them, bitmaps first: tools/kinds.cpp.
std::span<const ProblemKind* const> kinds();
inline const ProblemKind& bitmaps() { return *kinds().front(); }

/// The name asked for, or of the kind's first algorithm where it is empty. @throws UsageError for
/// one that plans elsewhere, and for an unknown one, with the nearest.
std::string_view algorithm_of(const ProblemKind& kind, std::string_view name);

/// Endings of the names of files that hold polygon worlds.
inline constexpr std::array<std::string_view, 3> kPolygonFileEndings{".geojson", ".json", ".wkt"};
/// True for a name with one of these endings.
bool is_polygon_file(std::string_view file);

}  // namespace lasius::tool
