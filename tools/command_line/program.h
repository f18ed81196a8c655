// The program, whoever its main is.
#pragma once

namespace lasius::tool {

/// Runs a command line; whatever it throws becomes a message and an exit code.
int run_program(int argc, const char* const* argv);

}  // namespace lasius::tool
