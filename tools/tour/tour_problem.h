// `lasius tour` as a question, whatever world it is asked of.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tools/bitmap/map_ends.h"
#include "tools/tour/tour_answer.h"
#include "tools/tour/tsplib_problem.h"

namespace lasius::tool {

/// On a map; what other worlds do in another way is virtual.
class TourProblem : public ProblemOf<TourCommand> {
 public:
  using ProblemOf::ProblemOf;

  std::optional<std::int64_t> read(const std::stop_token& token) override;
  void plan(const StopCondition& stop, const Watch& watch) override;
  Record record() const override;
  Forms show(const Record& run) const override;

 protected:
  /// The world, and what is said of it.
  virtual void read_world(const std::stop_token& token);
  virtual Place to_place(const End& end) const;
  virtual TourResult tour_of(const TourRequest& request, const Watch& watch);
  /// What else is told: in `json`, the answer.
  virtual void add_answer(Json&) const {}
  /// Why a stop is left out that is called so.
  virtual std::string why_not(const Place& place, const std::string& name) const;
  /// More of a start or goal that cannot be.
  virtual void look_at_ends();
  /// The record's beginning; what else is to be told of the answer goes to `findings`.
  virtual Record head(Json& findings) const;

  /// A sentence on the answer.
  virtual std::string summary(const Record& record) const;
  /// The stops in their order, by name or number, a line a robot; of many nothing.
  std::vector<std::string> orders() const;
  std::string stop_text(int stop) const;

  bool in_metres() const { return command_.run.frame == Frame::world; }
  std::string unit() const { return in_metres() ? "m" : ""; }
  bool is_end(int stop) const;
  const Place& place_at(int stop) const { return answer_.stops[static_cast<std::size_t>(stop)]; }

  TourAnswer answer_{};

 private:
  const Place& end_place(const std::optional<int>& end) const {
    static const Place kNowhere;
    return end ? place_at(*end) : answer_.stops.empty() ? kNowhere : answer_.stops.front();
  }
  std::optional<int> index_of(const std::optional<PoseEnd>& end);
  std::vector<int> groups() const;
  void check_ends_of_groups() const;
  std::string group_name(const LeftOut& out) const {
    return command_.stops.groups[static_cast<std::size_t>(out.stop)];
  }
  std::string why_left_out(const LeftOut& out) const;
  void look_at_end(int stop, bool start);
  Json answer_of(const Record& record, const Json& findings) const;

  std::optional<int> bad_start_;  ///< of the answer's ends
};

/// `lasius tour WORLD.geojson`.
std::unique_ptr<Problem> polygon_tour(TourCommand command);
/// `lasius tour MAP --vehicle`. @param recorded  the result that is made again
std::unique_ptr<Problem> vehicle_tour(TourCommand command, const Json* recorded = nullptr);
/// The polygon world of a result. @throws UsageError
void read_recorded_world(const Recorded& from, TourCommand& command);

}  // namespace lasius::tool
