// One study from its first run to its report.
#pragma once

#include <functional>

#include "tools/options/options.h"
#include "tools/study/runner.h"

namespace lasius::tool {

/// Runs the study with a line of progress and until a signal, then calls `write`, which makes
/// report.md in the folder and what it shows. Returns the program's exit code.
int conduct(const StudyCommand& command, const study::Study& study, const study::Domain& domain,
            const std::function<void(const study::Findings&, const StopCondition&)>& write);

}  // namespace lasius::tool
