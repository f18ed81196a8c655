// The report of a study as one page of HTML.
#pragma once

#include <filesystem>
#include <iosfwd>
#include <span>
#include <string>

#include "tools/study/claims.h"

namespace lasius::study {

/// What the page is of.
struct PageInput {
  const Study& study;
  const Findings& findings;
  std::span<const Evidence> evidence;
  const std::filesystem::path& maps;  ///< folder of its maps
  const std::string& called;          ///< the command line
};

/// Tables, charts, and on bitmaps the best path of each contender on its map. Charts and maps
/// that would make the page larger than some megabytes are left out, and the page says how many.
void write_study_page(std::ostream& out, const PageInput& input);

}  // namespace lasius::study
