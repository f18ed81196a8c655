// What `lasius help` tells beside the commands.
#pragma once

#include <array>
#include <span>
#include <string_view>

#include "tools/manual/blocks.h"

namespace lasius::tool {

struct Topic {
  std::string_view name, summary;
  std::array<std::string_view, 5> sections;  ///< of docs/; none: it is made of the algorithms
  bool in_man_page;  ///< of the program; the others are long, and in its documents

  /// Its sections one after another, the later ones below their headings.
  Blocks blocks() const;
};

std::span<const Topic> topics();

}  // namespace lasius::tool
