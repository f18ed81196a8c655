// A run as one page of HTML that needs nothing else: see docs/program.md.
#pragma once

#include <iosfwd>
#include <string>
#include <string_view>

#include "tools/record/json_values.h"
#include "tools/record/record.h"

namespace lasius::tool {

/// Most bytes of a page that frames may take, packed: so that a page stays below 5 MB.
inline constexpr std::size_t kMostPackedBytes = 3'000'000;
/// Most vertices of a path that a page holds.
inline constexpr std::size_t kMostVertices = 50'000;

/// What pages of all worlds show of a run:
///   kind, title, command           `kind` says which view of page/ shows it
///   result                         as the program's JSON has it, without the curves
///   curves {iteration, best, ...}  by iteration; of long runs every second, fourth ... one
///   unit, scale                    of lengths: name, and how many a unit of the result is
/// A path of more than kMostVertices is thinned, and `thinned` says to each how many-th vertex.
Json run_json(const Record& run, std::string_view kind, std::string title);

/// Writes the page of `content`: an object of run_json with a view's own keys. Text from outside is
/// only in its JSON, where no character can end the script that holds it, and escaped in the title.
void write_report_page(std::ostream& out, const Json& content);

}  // namespace lasius::tool
