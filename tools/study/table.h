// The tables of a study, one row as a list of texts: for Markdown and CSV alike.
#pragma once

#include <string>
#include <vector>

#include "tools/study/findings.h"

namespace lasius::study {

struct Table {
  std::vector<std::string> header;
  std::vector<std::vector<std::string>> rows;

  std::string markdown() const;
  std::string csv() const;
};

/// Paper and ours, a row a question and contender.
Table result_table(const Findings& findings, const Experiment& experiment);

/// The first contender against each other one, a row a question; equal and tenfold budget side by
/// side.
Table test_table(const Findings& findings, const Experiment& experiment);

/// A row a run.
Table run_table(const Findings& findings);

}  // namespace lasius::study
