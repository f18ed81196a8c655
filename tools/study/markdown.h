// The report of a study as one Markdown page.
#pragma once

#include <string>
#include <vector>

#include "tools/study/findings.h"

namespace lasius::study {

/// A picture that the page shows, by the name of its file without the ending.
struct Figure {
  const Experiment* experiment;
  std::string file;  ///< relative to the page
  std::string caption;
};

/// As the tables of claims say it.
std::string verdict_text(Verdict verdict);

std::string report_page(const Study& study, const Findings& findings, int seeds,
                        const std::vector<Figure>& figures);

}  // namespace lasius::study
