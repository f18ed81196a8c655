// What `lasius help` tells beside the commands.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "tools/manual/blocks.h"

namespace lasius::tool {

struct Topic {
  std::string_view name, summary;
  Blocks blocks;
  bool in_man_page;  ///< of the program; the others are long, and in its documents
};

const std::vector<Topic>& topics();

/// What tools/manual/make_manual writes of the documents: a block, a topic of such blocks, and the
/// names of the fields that a heading lists, given as "program/JSON of a plan".
struct DocumentBlock {
  Block::Kind kind;
  std::string_view text, label;
  int depth;
};
struct DocumentTopic {
  std::string_view name, summary;
  std::span<const DocumentBlock> blocks;
  bool in_man_page;
};
struct FieldNames {
  std::string_view heading, names;
};
std::span<const DocumentTopic> document_topics();
std::span<const FieldNames> field_names();

}  // namespace lasius::tool
