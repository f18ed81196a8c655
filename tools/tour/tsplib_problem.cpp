#include "tools/tour/tsplib_problem.h"

#include "lasius/tour/tsplib.h"
#include "tools/console/elapsed.h"
#include "tools/record/queries.h"

namespace lasius::tool {
namespace {

class TsplibProblem : public ProblemOf<TourCommand> {
 public:
  using ProblemOf::ProblemOf;

  std::optional<std::int64_t> read(const std::stop_token&) override {
    const std::string& file = command_.run.map.file;
    auto in = opened(file, "name a problem of TSPLIB, .tsp or .sop");
    problem_ = read_tsplib(in, file);
    command_.open = command_.open || problem_.ordered;
    hash_ = file_hash(file);
    return std::nullopt;
  }
  void plan(const StopCondition& stop, const Watch& watch) override {
    const auto begin = Clock::now();
    tour_ = plan_tour(problem_, request_of(command_, stop), told_to(watch, 1, ""));
    elapsed_ms_ = ms_since(begin);
  }
  Record record() const override {
    Record record{.options = command_.run,
                  .algorithm = tour::find_algorithm(command_.ants.algorithm()),
                  .format = kTourFormat,
                  .inputs = {{"map",
                              {{"file", command_.run.map.file},
                               {"hash", hash_text(hash_)},
                               {"width", nullptr},
                               {"height", nullptr}}}},
                  .result = search_result(tour_),
                  .elapsed_ms = elapsed_ms_,
                  .path = {tour_.order.begin(), tour_.order.end()},
                  .axes = 1};
    record.parameters = parameters_json(record.algorithm, command_.run);
    add_limits(record.parameters, command_.run);
    add_parameters(record.parameters, command_);
    record.answer = {{"stops", problem_.places.empty() ? Json::array() : points(problem_.places)}};
    record.answer.update(order_json(tour_));
    record.answer["length"] = number(record.result.length);
    add_proof(record.answer, record.result);
    record.answer["left_out"] = Json::array();
    record.answer["priced"] = tour_.priced;
    add_course(record.answer, record);
    return record;
  }
  Forms show(const Record&) const override {
    return {.csv = [&](std::ostream& out) {
      out << "stop\n";
      for (const int stop : tour_.order) out << stop << "\n";
    }};
  }

 private:
  Tsplib problem_;
  std::uint64_t hash_ = 0;
  TourResult tour_;
  double elapsed_ms_ = 0;
};

}  // namespace

std::unique_ptr<Problem> tsplib_problem(TourCommand command) {
  return std::make_unique<TsplibProblem>(std::move(command));
}

}  // namespace lasius::tool
