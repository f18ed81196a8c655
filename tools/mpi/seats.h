// How many ranks of a job are at work at once.
#pragma once

#include <sched.h>

#include <map>
#include <string>
#include <string_view>

namespace lasius::tool {

/// No more ranks of a host than it has cores: more would only push each other's work out of the
/// caches (docs/scale.md). Each sits on a core that it may use, since launchers may bind ranks. The
/// others wait, as those do for which there is no work.
class Seats {
 public:
  /// So many a host, by LASIUS_MPI_CORES, instead. @throws UsageError  where that is no number
  void read_environment();

  /// What a rank tells of itself: its host, and the cores that it may use.
  static std::string told();
  void learn(int rank, std::string_view told);

  void clear();  ///< all are free
  /// False where its host has none left. Precondition: learnt of.
  bool take(int rank);
  void leave(int rank);

 private:
  struct Host {
    cpu_set_t taken{};
    int seated = 0;
  };
  struct Rank {
    Host* host = nullptr;
    cpu_set_t cores{};  ///< none where the kernel counts more than it holds: any number may sit
    int core = 0;       ///< on which it sits
    bool sits = false;
  };
  std::map<std::string, Host> hosts_;
  std::map<int, Rank> ranks_;
  int asked_ = 0;  ///< 0: not
};

}  // namespace lasius::tool
