// The tables of a study, one row as a list of texts: for Markdown and CSV alike.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "tools/study/claims.h"

namespace lasius::study {

struct Table {
  std::vector<std::string> header;
  std::vector<std::vector<std::string>> rows = {};

  std::string markdown() const;  ///< a cell's bars are escaped, its line breaks blanks
  /// The first column as headings, below each what the others say of it as a list.
  std::string markdown_lists() const;
  std::string csv() const;  ///< as RFC 4180 quotes it; lines end in LF
};

/// The command that runs a study, by what it takes.
std::string called(const std::string& study, Seeds seeds);

/// Paper and ours, a row a question and contender.
Table result_table(const Findings& findings, const Experiment& experiment);

/// A row a claim, with all that there is to say, or with what came out of it alone.
Table claim_table(std::span<const Evidence> evidence);
Table outcome_table(std::span<const Evidence> evidence);

/// A row a run.
Table run_table(const Findings& findings);

/// A row a claim, with unrounded figures and the command that made them.
Table evidence_table(std::span<const Evidence> evidence);

}  // namespace lasius::study
