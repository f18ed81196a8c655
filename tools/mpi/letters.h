// Messages of MPI from point to point, of any length.
#pragma once

#include <mpi.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace lasius::tool {

/// Who waits for a message sleeps: longer the longer none comes, so that looking costs work little.
class Naps {
 public:
  std::chrono::microseconds next() { return std::exchange(next_, std::min(2 * next_, kLongest)); }
  void begin_anew() { next_ = kShortest; }

  static constexpr std::chrono::microseconds kShortest{100}, kLongest{2000};

 private:
  std::chrono::microseconds next_ = kShortest;
};

// What a letter holds, one behind the other.
void put(std::string& to, std::int64_t number);
void put(std::string& to, const std::string& text);
std::int64_t take_number(std::string_view& from);
std::string take_text(std::string_view& from);

struct Letter {
  int from;  ///< a rank
  std::string text;
};

/// A letter on its way.
class Sending {
 public:
  Sending(int to, const std::string& text);
  Sending(const Sending&) = delete;
  Sending& operator=(const Sending&) = delete;

  bool done();  ///< of a large one not until it is read

 private:
  std::string whole_;
  std::vector<MPI_Request> pieces_;
};
/// Waits until it is done.
void send(int to, const std::string& text);

/// The next letter that has come, if there is one.
std::optional<Letter> post();

}  // namespace lasius::tool
