#include "core/colony/rank_talk.h"

#include <utility>

#include "core/base/invalid_parameter.h"
#include "core/base/number_text.h"

namespace lasius {

void require_ranks(const Ranks& ranks, bool passing) {
  require_parameter(ranks.count >= 1, "ranks.count", ranks.count, "it must be 1 or more");
  require_parameter(ranks.own >= 0 && ranks.own < ranks.count, "ranks.own", ranks.own,
                    "it must be from 0 to " + number_text(ranks.count - 1));
  if (!ranks.gather) refuse("ranks.gather is empty", "give it a function");
  if (passing && !ranks.pass)
    refuse("ranks.pass is empty", "give it a function, or exchange as scheduled");
}

std::vector<std::string> gather(const Ranks& ranks, const std::string& own) {
  std::vector<std::string> all = ranks.gather(own);
  if (std::ssize(all) != ranks.count)
    refuse("ranks.gather gave " + number_text(all.size()) + " texts for " +
               number_text(ranks.count) + " ranks",
           "it must give one for each, empty where a rank has ended");
  return all;
}

ArrayReader told_by(std::string_view text, std::optional<int> rank) {
  const std::string who = rank ? "rank " + number_text(*rank) : "another rank";
  return {text, "what " + who + " handed in", 0, "give all ranks the same request and parameters"};
}

std::vector<Point> best_of(const Ranks* ranks, FoundPath own) {
  if (ranks == nullptr) return std::move(own.points);
  ArrayWriter mine;
  mine.value(own.rank);
  mine.array(own.points);
  const std::vector<std::string> all = gather(*ranks, mine.text());
  FoundPath best;
  best.points = std::move(own.points);  // perhaps of a length that is no number
  for (int rank = 0; rank < ranks->count; ++rank) {
    ArrayReader from = told_by(all[static_cast<std::size_t>(rank)], rank);
    if (from.at_end()) continue;
    const auto found = from.value<FoundPath::Rank>();
    auto points = from.array<Point>();
    from.require(from.at_end());
    if (found < best.rank) best = {found, std::move(points)};
  }
  return std::move(best.points);
}

}  // namespace lasius
