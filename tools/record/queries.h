// Files of queries: MovingAI scenarios, and tables with columns sx sy gx gy.
#pragma once

#include <cstddef>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/text_lines.h"
#include "lasius/grid/geometry.h"
#include "tools/options/options.h"
#include "tools/record/json_values.h"

namespace lasius::tool {

/// A table's text: lines end in LF, no byte order mark. @throws as opened().
std::string table_text(const std::string& file, const std::string& remedy);
/// What may part fields of tables that have neither tabs nor a header with commas.
inline constexpr std::string_view kBlanksAndCommas = " \t\r\v\f,";
/// How the fields of a table's lines are parted, by its first: '\t', ',' for CSV, else ' ', any
/// blanks.
char separator_of(std::string_view first);
/// The fields of a line, without blanks about them; nothing where a quote of CSV is not closed.
std::vector<std::string> fields_of(std::string_view line, char separator,
                                   std::string_view blanks = kBlanksOfLines);
/// Leaves out empty fields beyond `most` at the end of a line, as spreadsheets write them.
void leave_out_empty(std::vector<std::string>& fields, std::size_t most);

struct QueryFile {
  struct Line {
    End start, goal;
  };
  std::vector<Line> queries;
  bool scenario = false;  ///< coordinates are cells whatever the frame
  bool yaws = false;      ///< has columns syaw or gyaw, which are not read
};

/// Notes that the yaws of a file of ends are not read, where there are any.
inline void note_yaws(bool any, const std::string& file, SearchOptions& options) {
  if (any) options.notes.push_back(file + ": its yaws have no effect without --vehicle");
}

/// Reads all of a file before anything is returned.
///   .scen  "version 1" or "version 1.0", then bucket map width height sx sy gx gy optimal a line,
///          split at any blanks; the map's name is not looked at, its size must be width x height
///   table  a header that names sx, sy, gx and gy among others, and lines as fields_of()
/// Coordinates are whole numbers of any size, cells; in a table any finite ones, all of them points
/// unless `whole`: then those of a pair with a decimal point or an exponent. `metres`: whether
/// these could be given instead, which a refusal then says.
/// @throws Error(file_missing, file_broken) naming file and line.
QueryFile read_queries(const std::string& file, int width, int height, bool whole,
                       bool metres = false);

/// A table of finite coordinates, whatever a map's size; no scenario.
QueryFile read_table(const std::string& file);

/// The same from a stream; `file` is named in errors.
QueryFile read_queries(std::istream& in, const std::string& file, int width, int height, bool whole,
                       bool metres = false);

/// Leaves of a file's queries those of a part, and tells it how many there were.
template <class Query>
void keep_part(std::vector<Query>& queries, const std::string& file, Part& part) {
  if (!part.divided()) return;
  part.whole = queries.size();
  part.queries = hash_text(file_hash(file));
  std::size_t i = 0;
  std::erase_if(queries, [&](const Query&) { return !part.holds(i++); });
}

/// A file to read. @throws Error(file_missing) with the reason and `remedy`, also for a folder.
std::ifstream opened(const std::string& file, const std::string& remedy);

}  // namespace lasius::tool
