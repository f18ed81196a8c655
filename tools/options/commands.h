// What commands do that several files call. All return the exit code.
#pragma once

#include "tools/options/manual.h"
#include "tools/options/options.h"

namespace lasius::tool {

int run_command(const DriveCommand& command);
int run_command(const TourCommand& command);
int run_command(const VehicleCommand& command);
int run_command(const StudyCommand& command);
int run_command(const TuneCommand& command);
int run_command(const PolygonCommand& command);
int run_command(const WorldInfoCommand& command);

int run_command(const HelpCommand& command);
int run_command(const CompleteCommand& command);

}  // namespace lasius::tool
