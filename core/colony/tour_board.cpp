#include "core/colony/tour_board.h"

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "core/base/stored_arrays.h"
#include "core/colony/rank_talk.h"

namespace lasius {

void TourBoard::offer(const Tour& tour) {
  const std::lock_guard lock(mutex_);
  best_.offer({&tour, 1});
}

void TourBoard::teach(GridColony& colony) {
  const std::lock_guard lock(mutex_);
  if (!best_.none() && !(colony.best_tour().length <= best_.length())) colony.welcome(best_.tour());
}

void TourBoard::stop(StopCondition::Cause cause) {
  auto none = StopCondition::Cause::none;
  cause_.compare_exchange_strong(none, cause);
}

StopCondition::Cause TourBoard::poll() {
  if (ranks_ != nullptr && std::this_thread::get_id() == talks_) talk();
  return cause_;
}

void TourBoard::talk() {
  ArrayWriter news;
  {
    const std::lock_guard lock(mutex_);
    const auto cause = cause_.load();
    if (best_.length() < passed_on_ || cause != told_) {
      news.value(cause);
      news.value(best_.length());
      news.array(best_.moves());
    }
    passed_on_ = best_.length();
    told_ = cause;
  }
  for (const std::string& text : ranks_->pass(news.text())) {
    if (text.empty()) {
      stop(StopCondition::Cause::deadline);
      continue;
    }
    ArrayReader from = told_by(text, {});
    const auto cause = from.value<StopCondition::Cause>();
    stop(cause);
    if (cause != StopCondition::Cause::none) told_ = cause_;
    const auto length = from.value<double>();
    const auto moves = from.array<std::uint8_t>();
    from.require(from.at_end());
    offer({moves, length});
    passed_on_ = std::min(passed_on_, length);
  }
}

}  // namespace lasius
