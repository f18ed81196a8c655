#include "tools/command_line/program.h"

int main(int argc, char** argv) { return lasius::tool::run_program(argc, argv); }
