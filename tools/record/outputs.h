// What a run gives: data on standard output, then files.
#pragma once

#include <exception>
#include <functional>
#include <iosfwd>
#include <string>
#include <string_view>
#include <vector>

#include "tools/console/signals.h"
#include "tools/options/options.h"

namespace lasius::tool {

/// By their ending.
bool is_picture(std::string_view file);
bool is_table(std::string_view file);  ///< .csv
bool is_yaml(std::string_view file);   ///< .yaml, .yml
bool is_film(std::string_view file);   ///< .gif
bool is_page(std::string_view file);   ///< .html
bool is_proof(std::string_view file);  ///< .proof.json, .proof.cbor

/// The forms of a file, each made when it is asked for.
struct Forms {
  using Write = std::function<void(std::ostream&)>;
  Write json = {}, csv = {};
  std::function<void(const std::string& file)> picture = {};
  Write yaml = {}, film = {}, page = {};  ///< of those that have it
  using WriteProof = std::function<void(std::ostream&, bool binary)>;
  WriteProof proof = {};  ///< likewise
};

/// What check_outputs refuses of a command's files, before work; of a crew's leader alone, who
/// writes. @throws Error
void check_files(const SearchOptions& options);

/// Writes a file in the form that its ending asks for, JSON where it asks for none. @throws
/// Error(output_failed)
void write_output(const std::string& file, const Forms& forms);

/// Standard output and files: what one of them refuses the others still get.
class Delivery {
 public:
  /// From here on a signal that ends the program at once names the files that are not written.
  explicit Delivery(const std::vector<std::string>& files);

  /// Prints data, unless that failed before. Throws ClosedOutput or Error(output_failed) at once
  /// where there are no files.
  void print(const std::string& text);
  /// Calls `write` for each file: pictures, films, pages and proofs, which take long, after the
  /// others, unless a reader of a pipe may wait for one of them. The first signal ends none of it.
  /// `verbose`: says which are written. @throws Error(output_failed), the first one of all; further
  /// ones are messages.
  void write(const std::function<void(const std::string& file)>& write, bool verbose = false);

 private:
  void name_left();

  std::vector<std::string> left_;  ///< to be written, in this order
  LastWords unwritten_;
  bool closed_ = false;
  std::exception_ptr fault_;
};

}  // namespace lasius::tool
