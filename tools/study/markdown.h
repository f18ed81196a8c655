// The report of a study as one Markdown page.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "tools/study/claims.h"

namespace lasius::study {

/// A picture that the page shows, by the name of its file without the ending.
struct Figure {
  const Experiment* experiment;
  std::string file;  ///< relative to the page
  std::string caption;
};

/// The evidence is that of the study's claims.
std::string report_page(const Study& study, const Findings& findings,
                        std::span<const Evidence> evidence, Seeds seeds,
                        const std::vector<Figure>& figures);

/// One table of the claims of several studies, and how to read it.
std::string claims_page(std::span<const Evidence> evidence, const std::string& command);

}  // namespace lasius::study
