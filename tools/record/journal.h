// What is done of a long command, on disk before it counts: another run goes on from there.
#pragma once

#include <map>
#include <string>
#include <string_view>

#include "core/base/descriptor.h"

namespace lasius::tool {

/// A file that is only appended to. Each entry has its length and a checksum of number and text; an
/// entry that a crash left in pieces, and what stands behind it, is cut off when the file is opened
/// again.
class Journal {
 public:
  /// Opens or makes the file of a command that `key` tells from all others; a file with another key
  /// is begun anew. @throws Error(output_failed), also while another job has it open.
  Journal(std::string file, const std::string& key);

  /// The entries that were there, by number; they are the caller's to move from.
  std::map<int, std::string>& kept() noexcept { return kept_; }

  /// Returns when the entry is on the disk. @throws Error(output_failed)
  void add(int number, std::string_view text);

  /// The command has ended: nothing is left to go on with.
  void remove();

 private:
  void write(std::string_view bytes);

  std::string file_;
  Descriptor descriptor_;
  std::map<int, std::string> kept_;
};

}  // namespace lasius::tool
