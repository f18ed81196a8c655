// The processes that share the work of one command.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

namespace lasius::tool {

/// A scheduler over processes ("ranks"), as parallel_for is one over threads: all ranks run the
/// same command on the same input, up to where its independent items of work are shared. One rank
/// leads: it gives items out, takes what became of them, and goes on alone.
class Crew {
 public:
  virtual ~Crew() = default;
  bool leads() const noexcept { return number() == 0; }

  struct Work {
    /// What the leader gives out, in this order; unread elsewhere. Items mean the same to all.
    std::vector<int> items = {};
    /// Tells the input from all others: ranks with another one are refused.
    std::string key = {};
    int at_a_time = 1;          ///< items that a rank takes at once
    std::stop_token stop = {};  ///< the leader's: nothing more is given out
    /// Of any rank: does items, and tells of each what became of it, not empty; empty: stopped.
    std::function<std::vector<std::string>(std::span<const int> items)> act = {};
    /// Of the leader, on the thread that shares: what became of an item, in no order.
    std::function<void(int item, std::string text)> receive = {};
    /// Of the leader: what the others go on with, too.
    std::function<std::string()> summary = {};
  };
  /// The summary when all items are done. Nothing, to the leader alone, where a stop of any rank
  /// ended it before; the others are dismissed then. @throws Dismissed; Error(file_broken) for a
  /// rank with another key; std::runtime_error for what another rank met with.
  virtual std::optional<std::string> share(const Work& work) = 0;

  virtual int number() const noexcept = 0;  ///< of this rank, the leader's is 0
  virtual int size() const noexcept = 0;
  /// What each rank has handed in, by number; empty of one that has ended well without. Every rank
  /// calls it as often. `key` as of work. @throws as share.
  virtual std::vector<std::string> gather(const std::string& key, const std::string& own) = 0;
  /// Tells all other ranks a text, if it is not empty, and gets those that have arrived since, in
  /// no order; an empty one: a rank has ended. Waits for nobody. A gather leaves none behind.
  virtual std::vector<std::string> pass(const std::string& own) = 0;
};

/// Thrown where a rank's work is done.
struct Dismissed {};

/// Null in a process of its own.
Crew* crew() noexcept;
void set_crew(Crew* one) noexcept;

/// Is there a crew that another rank leads?
bool follows() noexcept;
/// From here on a crew's leader goes on alone. @throws Dismissed where another rank leads.
void leave_to_leader();

}  // namespace lasius::tool
