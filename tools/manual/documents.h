// The commands' tables as blocks.
#pragma once

#include <string>

#include "tools/manual/blocks.h"
#include "tools/options/manual.h"

namespace lasius::tool {

/// "lasius plan MAP [options]": arguments, and the options that must be there.
std::string usage(const CommandText& command);

/// Arguments and options as items, below headings.
Blocks option_blocks(const std::vector<OptionText>& options);

/// The rest of what is told of a command: examples, JSON, exit codes.
Blocks note_blocks(const Notes& notes);

/// What `lasius help` says without a topic: commands and topics.
Blocks command_list(const Manual& manual);
Blocks topic_list();

}  // namespace lasius::tool
