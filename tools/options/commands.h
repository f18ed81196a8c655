// What each subcommand does. All return the exit code.
#pragma once

#include "tools/options/options.h"

namespace lasius::tool {

int run_plan(const PlanCommand& command);
int run_drive(const DriveCommand& command);
int run_batch(const BatchCommand& command);
int run_info(const InfoCommand& command);
int run_algorithms(const AlgorithmsCommand& command);
int run_generate(const GenerateCommand& command);
int run_verify(const VerifyCommand& command);
int run_study(const StudyCommand& command);
int run_tune(const TuneCommand& command);
int run_arm(const ArmCommand& command);
int run_polygon(const PolygonCommand& command);
int run_polygon_batch(const PolygonBatchCommand& command);
int run_world_info(const WorldInfoCommand& command);

int run_help(const HelpCommand& command);
int run_complete(const CompleteCommand& command);

}  // namespace lasius::tool
