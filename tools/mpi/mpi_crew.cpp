#include "tools/mpi/mpi_crew.h"

#include <mpi.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <exception>
#include <future>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <thread>
#include <utility>

#include "lasius/base/error.h"
#include "tools/console/exit_code.h"
#include "tools/console/streams.h"

namespace lasius::tool {
namespace {

using namespace std::chrono_literals;

// A message begins with one of these. To the leader: where a rank is; work is wanted, and what
// became of the last; it is told to stop, with nothing to do; it failed; the rank has ended. To
// anybody: news.
constexpr char kHere = 'h', kWant = 'w', kStop = 's', kFailed = 'f', kGone = 'g', kNews = 'n';
// To others: items; the end of a sharing, with its summary; the end of all.
constexpr char kItems = 'i', kEnd = 'e', kDismissed = 'd';

std::string packed(std::span<const int> items, const std::vector<std::string>& texts) {
  std::string all;
  for (std::size_t i = 0; i < items.size(); ++i) {
    put(all, items[i]);
    put(all, texts[i]);
  }
  return all;
}

/// Work of the leader's own, beside the thread that answers the others.
class OwnWork {
 public:
  explicit OwnWork(const Crew::Work& work) : work_(work) {}

  bool idle() const noexcept { return !under_way_.valid(); }
  void begin(std::vector<int> items) {
    under_way_ = std::async(std::launch::async, [this, items = std::move(items)] {
      return packed(items, work_.act(items));
    });
  }
  /// Until it ends, so long at most.
  void wait(std::chrono::microseconds longest) const {
    if (idle())
      std::this_thread::sleep_for(longest);
    else
      under_way_.wait_for(longest);
  }
  /// What became of it, once it has ended.
  std::optional<std::string> ended() {
    if (idle() || under_way_.wait_for(0s) != std::future_status::ready) return std::nullopt;
    return under_way_.get();
  }

 private:
  const Crew::Work& work_;
  std::future<std::string> under_way_;
};

/// The items of one sharing, as its leader sees them.
class Ledger {
 public:
  explicit Ledger(const Crew::Work& work) : work_(work), open_(work.items.size()) {}

  bool stopping() const { return stopped_ || work_.stop.stop_requested(); }
  void stop() { stopped_ = true; }
  bool done() const { return open_ == 0; }

  std::vector<int> next() {
    std::vector<int> items;
    if (stopping()) return items;
    const auto count =
        std::min(work_.items.size() - given_, static_cast<std::size_t>(work_.at_a_time));
    const auto first = work_.items.begin() + static_cast<std::ptrdiff_t>(given_);
    items.assign(first, first + static_cast<std::ptrdiff_t>(count));
    given_ += count;
    return items;
  }

  void enter(std::string_view results) {
    while (!results.empty()) {
      const int item = static_cast<int>(take_number(results));
      std::string text = take_text(results);
      if (text.empty()) {
        stopped_ = true;
        continue;
      }
      work_.receive(item, std::move(text));
      --open_;
    }
  }

 private:
  const Crew::Work& work_;
  std::size_t given_ = 0, open_;
  bool stopped_ = false;
};

}  // namespace

MpiCrew::MpiCrew(int* argc, char*** argv) {
  int provided = 0;
  MPI_Init_thread(argc, argv, MPI_THREAD_FUNNELED, &provided);
  MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
  MPI_Comm_size(MPI_COMM_WORLD, &ranks_);
  gone_.resize(static_cast<std::size_t>(ranks_));
  if (leads())
    seats_.learn(rank_, Seats::told());
  else
    send(0, kHere + Seats::told());
}

MpiCrew::~MpiCrew() {
  forget_sent();
  MPI_Finalize();
}

std::optional<std::string> MpiCrew::share(const Work& work) {
  auto summary = leads() ? lead(work) : follow(work);
  ++shared_;
  return summary;
}

std::string MpiCrew::ask(const std::string& key, const std::string& results,
                         const std::stop_token& stop) {
  std::string wanted(1, kWant);
  put(wanted, shared_);
  put(wanted, key);
  send(0, wanted + results);
  std::optional<Letter> reply;
  bool told = false;
  for (Naps naps; !(reply = next_letter());) {
    std::this_thread::sleep_for(naps.next());
    if (told || !stop.stop_requested()) continue;
    send(0, std::string(1, kStop));
    told = true;
  }
  if (reply->text[0] == kDismissed) throw Dismissed{};
  return reply->text;
}

std::string MpiCrew::follow(const Work& work) {
  std::string results;
  for (;;) {
    const std::string reply = ask(work.key, results, work.stop);
    if (reply[0] == kEnd) return reply.substr(1);
    std::vector<int> items;
    for (std::string_view left = std::string_view(reply).substr(1); !left.empty();)
      items.push_back(static_cast<int>(take_number(left)));
    try {
      results = packed(items, work.act(items));
    } catch (const std::exception& fault) {
      send(0, kFailed + std::string(fault.what()));
      throw Dismissed{};
    }
  }
}

bool MpiCrew::read_post(const std::string& key, bool all_needed,
                        const std::function<void(int, std::string_view)>& act) {
  bool any = false;
  while (const auto letter = next_letter()) {
    any = true;
    std::string_view text = std::string_view(letter->text).substr(1);
    const std::string rank = "rank " + std::to_string(letter->from);
    if (letter->text[0] == kGone) {
      gone_[static_cast<std::size_t>(letter->from)] = true;
      if (text == "0") continue;
      const std::string how = rank + " ended with exit code " + std::string(text);
      if (all_needed) throw std::runtime_error(how);
      message(how + " before it was at work; the others go on");
      continue;
    }
    if (letter->text[0] == kHere) {
      seats_.learn(letter->from, text);
      continue;
    }
    if (letter->text[0] == kStop) {
      stopped_ = true;
      continue;
    }
    if (letter->text[0] == kFailed) throw std::runtime_error(rank + ": " + std::string(text));
    const auto sharing = static_cast<std::size_t>(take_number(text));
    if (sharing < farewells_.size()) {  // it comes late: that work is done
      send(letter->from, farewells_[sharing]);
      continue;
    }
    waiting_.push_back(letter->from);
    if (take_text(text) != key)
      throw Error(ErrorCode::file_broken, {}, rank + " has other input than rank 0",
                  "give all ranks the same files and the same lasius");
    act(letter->from, text);
  }
  return any;
}

std::optional<Letter> MpiCrew::next_letter() {
  for (;;) {
    std::optional<Letter> letter;
    if (unread_.empty()) {
      letter = post();
    } else {
      letter = std::move(unread_.front());
      unread_.pop_front();
    }
    if (!letter || letter->text[0] != kNews) return letter;
    spread(letter->text, letter->from);
  }
}

void MpiCrew::forget_sent() {
  std::erase_if(spreading_, [](Sending& one) { return one.done(); });
}

void MpiCrew::spread(const std::string& news, int from) {
  for (int to = 0; to < (leads() ? ranks_ : 1); ++to)
    if (to != from && to != rank_ && !gone_[static_cast<std::size_t>(to)])
      spreading_.emplace_back(to, news);
}

std::vector<std::string> MpiCrew::pass(const std::string& own) {
  if (!own.empty()) spread(kNews + own, rank_);
  std::vector<std::string> heard;
  while (auto letter = post()) {
    if (letter->text[0] == kNews) {
      spread(letter->text, letter->from);
      heard.push_back(letter->text.substr(1));
    } else {
      if (letter->text[0] == kGone) heard.emplace_back();
      unread_.push_back(std::move(*letter));
    }
  }
  forget_sent();
  return heard;
}

std::vector<std::string> MpiCrew::gather(const std::string& key, const std::string& own) {
  std::vector<std::string> all;
  if (!leads()) {
    const std::string reply = ask(key, own, {});
    for (std::string_view left = std::string_view(reply).substr(1); !left.empty();)
      all.push_back(take_text(left));
    return all;
  }
  all.resize(static_cast<std::size_t>(ranks_));
  all[0] = own;
  const auto read = [&](int rank, std::string_view text) {
    all[static_cast<std::size_t>(rank)] = text;
  };
  const auto missing = [&] {
    return ranks_ - 1 - std::ranges::count(gone_, true) - std::ssize(waiting_);
  };
  for (Naps naps; missing() > 0;) {
    if (!read_post(key, true, read)) std::this_thread::sleep_for(naps.next());
  }
  std::string reply(1, kEnd);
  for (const std::string& text : all) put(reply, text);
  bid_farewell(reply);
  return all;
}

std::optional<std::string> MpiCrew::lead(const Work& work) {
  Ledger ledger(work);
  OwnWork own(work);
  Naps naps;
  seats_.clear();
  seats_.take(rank_);
  const auto give = [&](int rank) {  // the last that waits
    if (!seats_.take(rank)) return;
    const std::vector<int> items = ledger.next();
    if (items.empty()) return;
    std::string text(1, kItems);
    for (const int item : items) put(text, item);
    send(rank, text);
    waiting_.pop_back();
  };
  // Once it stops what others have under way is not waited for: it is done again.
  while (!ledger.done() && !(ledger.stopping() && own.idle())) {
    if (own.idle())
      if (auto items = ledger.next(); !items.empty()) own.begin(std::move(items));
    bool rest = true;
    if (const auto results = own.ended()) {
      ledger.enter(*results);
      rest = false;
    }
    const auto read = [&](int rank, std::string_view results) {
      ledger.enter(results);
      seats_.leave(rank);
      give(rank);
    };
    if (read_post(work.key, false, read)) rest = false;
    if (stopped_) ledger.stop();
    if (rest)
      own.wait(naps.next());
    else
      naps.begin_anew();
  }
  std::optional<std::string> summary;
  if (ledger.done()) summary = work.summary ? work.summary() : std::string();
  farewells_.push_back(summary && !ledger.stopping() ? kEnd + *summary
                                                     : std::string(1, kDismissed));
  bid_farewell(farewells_.back());
  return summary;
}

void MpiCrew::bid_farewell(const std::string& text) {
  for (const int rank : std::exchange(waiting_, {})) send(rank, text);
}

void MpiCrew::leave(int code) {
  if (!leads()) return send(0, kGone + std::to_string(code));
  bid_farewell(std::string(1, kDismissed));  // what ended the command left them waiting
  const bool whole = code == kFound || (!farewells_.empty() && farewells_.back()[0] == kEnd);
  const auto until = std::chrono::steady_clock::now() + 10s;
  while (std::ranges::count(gone_, true) < ranks_ - 1) {
    const auto letter = next_letter();
    if (letter && letter->text[0] == kWant)
      send(letter->from, std::string(1, kDismissed));
    else if (letter && letter->text[0] == kGone)
      gone_[static_cast<std::size_t>(letter->from)] = true;
    else if (!whole && std::chrono::steady_clock::now() > until)
      MPI_Abort(MPI_COMM_WORLD, code);  // others are at work that nobody waits for
    else if (!letter)
      std::this_thread::sleep_for(Naps::kLongest);
  }
}

}  // namespace lasius::tool
