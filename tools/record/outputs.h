// What a run gives: data on standard output, then files.
#pragma once

#include <exception>
#include <functional>
#include <string>
#include <vector>

#include "tools/options/options.h"
#include "tools/record/outcome.h"

namespace lasius::tool {

/// The forms of one result, each made when it is asked for.
struct Forms {
  std::function<std::string()> text;
  std::function<std::string()> json;  ///< one line
  std::function<std::string()> csv;
  std::function<void(const std::string& file)> write_picture;
};

/// Says on standard error how a run ended, where that is worth a word or it has no path.
void report(const Outcome& outcome, const Messages& messages);

/// Prints text, or JSON where `json`, and writes the files by their endings, as Delivery does.
void deliver(const Forms& forms, bool json, const std::vector<std::string>& files,
             const Messages& messages);

/// Standard output and files: what one of them refuses the others still get.
class Delivery {
 public:
  /// `files` must outlive it.
  explicit Delivery(const std::vector<std::string>& files) : files_(files) {}

  /// Prints data, unless that failed before. Throws ClosedOutput or Error(output_failed) at once
  /// where there are no files.
  void print(const std::string& text);
  /// Calls `write` for each file. @throws Error(output_failed), the first one of all; further ones
  /// are messages.
  void write(const std::function<void(const std::string& file)>& write);

 private:
  const std::vector<std::string>& files_;
  bool closed_ = false;
  std::exception_ptr fault_;
};

}  // namespace lasius::tool
