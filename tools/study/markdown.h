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

/// The evidence of each study, where it is of several, one after another.
std::vector<std::span<const Evidence>> by_study(std::span<const Evidence> evidence);

/// The claims of several studies, a line each, and how to read them: claims.md.
std::string claims_page(std::span<const Evidence> evidence, const std::string& command);

/// All that there is to say of the claims of one study: claims/NAME.md.
std::string claim_details(std::span<const Evidence> evidence);

}  // namespace lasius::study
