// Ranks of MPI as a crew.
#pragma once

#include <deque>
#include <functional>
#include <list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tools/console/crew.h"
#include "tools/mpi/letters.h"
#include "tools/mpi/seats.h"

namespace lasius::tool {

/// Messages from point to point alone, all by the thread that made the object; who waits for one
/// sleeps. The leader, rank 0, works as well. Ranks may be more than cores: no more are at work at
/// once, but of islands.
class MpiCrew final : public Crew {
 public:
  MpiCrew(int* argc, char*** argv);  ///< MPI_Init_thread
  ~MpiCrew() override;               ///< MPI_Finalize

  std::optional<std::string> share(const Work& work) override;
  int number() const noexcept override { return rank_; }
  int size() const noexcept override { return ranks_; }
  std::vector<std::string> gather(const std::string& key, const std::string& own) override;
  std::vector<std::string> pass(const std::string& own) override;

  /// How many ranks of a host are to be at work. @throws UsageError
  void read_environment() { seats_.read_environment(); }
  /// The command has ended with this exit code. The leader waits for the others; where the command
  /// did not do its work only a while, and then it ends the job.
  void leave(int code);

 private:
  std::optional<std::string> lead(const Work& work);
  std::string follow(const Work& work);
  /// Another rank's: the leader's reply to what came of its last work. It hears of a stop.
  std::string ask(const std::string& key, const std::string& results, const std::stop_token& stop);
  /// The leader's: tells of each letter that has come to this sharing, which rank sent what. False
  /// where there was none. Where all are needed, none may end badly.
  bool read_post(const std::string& key, bool all_needed,
                 const std::function<void(int rank, std::string_view results)>& act);
  /// To all that wait.
  void bid_farewell(const std::string& text);
  /// The next one, if there is one; news come too late here.
  std::optional<Letter> next_letter();
  /// News that rank `from` tells: the leader sends them to all others, another rank its own to the
  /// leader. Nobody waits.
  void spread(const std::string& news, int from);
  void forget_sent();

  int rank_ = 0, ranks_ = 1;
  int shared_ = 0;                      ///< how often work was
  std::vector<std::string> farewells_;  ///< of the leader: what ended each sharing
  std::vector<bool> gone_;              ///< of the leader
  std::vector<int> waiting_;            ///< of the leader: ranks that it owes an answer
  Seats seats_;                         ///< of the leader: who is at work
  bool stopped_ = false;                ///< of the leader: another rank was told to stop
  std::list<Sending> spreading_;        ///< news on their way
  std::deque<Letter> unread_;           ///< of the leader: came while it looked for news alone
};

}  // namespace lasius::tool
