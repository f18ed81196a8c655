// What is an answer and what is an error.
#include <lasius/lasius.h>

#include <iostream>

int main() {
  using namespace lasius;
  Grid grid(40, 40);
  grid.fill({20, 0, 1, 40}, true);  // a wall from top to bottom
  const Planner planner(std::move(grid));

  const Result closed = planner.plan({.start = {2, 2}, .goal = {38, 38}});
  std::cout << to_string(closed.status) << ": " << closed.error << '\n';

  const Result blocked = planner.plan({.start = {20, 5}, .goal = {38, 38}});
  std::cout << to_string(blocked.status) << ", " << to_string(blocked.fault) << ": "
            << blocked.error << '\n';

  try {
    read_map("no-such-file.map");
  } catch (const Error& error) {
    std::cout << error.problem() << " / " << error.remedy() << '\n';
    return closed.status == Status::unreachable && blocked.fault == Fault::start_blocked &&
                   error.code() == ErrorCode::file_missing
               ? 0
               : 1;
  }
  return 1;
}
