// Maps, queries and answers as files, for a checker that shares nothing with this program.
#pragma once

#include <span>
#include <string>

#include "bench/query_set.h"
#include "lasius/planner.h"

namespace lasius::bench {

/// Writes into one folder, for each map NAME:
///   NAME.map              the file that was read, byte for byte, or the generated map
///   NAME.tsv              sx sy gx gy euclid; the exact any-angle length of each query
///   NAME.ALGORITHM.jsonl  an object a query, in order: status, length, path as [x, y] in cells
class AnswerFiles {
 public:
  /// Makes the folder. @throws Error(output_failed) when it is there and not empty.
  explicit AnswerFiles(std::string folder);

  /// `optima` stands in where a query has no length of its own.
  void write_map(const QuerySource& source, const QuerySet& set,
                 std::span<const double> optima) const;
  void write_answers(const std::string& name, const std::string& algorithm,
                     std::span<const Result> answers) const;

 private:
  std::string folder_;
};

}  // namespace lasius::bench
