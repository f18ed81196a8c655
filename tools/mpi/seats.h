// How many ranks of a job are at work at once.
#pragma once

#include <sched.h>

#include <map>
#include <string>
#include <string_view>

namespace lasius::tool {

/// No more ranks of a host than it has cores: more would only push each other's work out of the
/// caches (docs/scale.md). The others wait, as those do for which there is no work.
class Seats {
 public:
  /// What a rank tells of itself: its host, and the cores that it may use.
  static std::string told();
  void learn(int rank, std::string_view told);

  /// All are free. @throws UsageError  for an LASIUS_MPI_CORES that is no number
  void clear();
  /// False where its host has none left. Precondition: learnt of.
  bool take(int rank);
  void leave(int rank);

 private:
  struct Host {
    cpu_set_t cores{};  ///< that any rank there may use: launchers may bind each to one of its own
    int taken = 0;
  };
  struct Rank {
    Host* host;
    bool sits = false;
  };
  std::map<std::string, Host> hosts_;
  std::map<int, Rank> ranks_;
  int asked_ = 0;  ///< seats of each host; 0: its cores
};

}  // namespace lasius::tool
