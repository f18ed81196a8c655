#include "tools/record/outcome.h"

#include "tools/console/exit_code.h"
#include "tools/console/values.h"

namespace lasius::tool {

int exit_code(const Outcome& outcome) {
  switch (outcome.status) {
    case Status::invalid:
      return kInvalidQuery;
    case Status::unreachable:
      return kUnreachable;
    case Status::interrupted:
      return kInterrupted;
    case Status::solved:
    case Status::limit:
    case Status::no_path:
      break;
  }
  return outcome.has_path ? kFound : kNoPath;
}

std::string explain(const Outcome& outcome) {
  const std::string after =
      outcome.iterations ? " after " + counted(*outcome.iterations, "iteration") : "";
  const std::string held = outcome.has_path ? ", the best path so far is kept" : ", no path yet";
  switch (outcome.status) {
    case Status::solved:
      return {};
    case Status::limit:
      return "the time limit ended the run" + after + held;
    case Status::interrupted:
      return "interrupted" + after + held;
    case Status::no_path:
      return "no path" + after + "; try more --iterations, more --ants or another --seed";
    case Status::unreachable:
    case Status::invalid:
      return outcome.error;
  }
  return {};
}

}  // namespace lasius::tool
