// What a shell may complete, from the same tables as --help.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "tools/options/manual.h"

namespace lasius::tool {

struct Candidate {
  std::string word;     ///< in place of the last one; more is to be typed behind a final "="
  std::string meaning;  ///< a line; may be empty
  friend bool operator==(const Candidate&, const Candidate&) = default;
};

struct Completion {
  std::vector<Candidate> candidates;  ///< all of them begin with the last word
  bool files = false;                 ///< files with `endings`, too; behind "=", where it has one
  bool folders = false;
  std::vector<std::string> endings;
};

/// For the words behind the program's name, of which the last one, empty or not, is being typed.
Completion complete(const Manual& manual, std::span<const std::string> words);

}  // namespace lasius::tool
