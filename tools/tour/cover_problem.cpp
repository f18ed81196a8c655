#include "tools/tour/cover_problem.h"

#include <cmath>
#include <utility>

#include "lasius/error.h"
#include "lasius/tour/cover.h"
#include "tools/bitmap/answer.h"
#include "tools/bitmap/bitmap_problem.h"
#include "tools/bitmap/map_ends.h"
#include "tools/bitmap/reasons.h"
#include "tools/console/elapsed.h"
#include "tools/console/exit_code.h"
#include "tools/console/parameters.h"
#include "tools/console/values.h"
#include "tools/record/recorded.h"
#include "tools/tour/cover_picture.h"
#include "tools/tour/tour_answer.h"
#include "tools/tour/tour_files.h"
#include "tools/tour/tsplib_problem.h"

namespace lasius::tool {
namespace {

class CoverProblem : public Problem {
 public:
  explicit CoverProblem(TourCommand command) : command_(std::move(command)) {}

  std::optional<std::int64_t> read(const std::stop_token& token) override {
    RunOptions& run = command_.run;
    answer_.map = load_map(run.map, run.frame, run.params.corners, run.threads, token);
    run.inputs.push_back(answer_.map.image);
    check_radius(answer_.map, run);
    width_ = answer_.map.cells_of(run.map.radius_metres, *command_.cover);
    check_width();
    if (command_.start) start_ = end_place(answer_.map, *command_.start, run.frame);
    note_map(answer_.map, run);
    return std::nullopt;
  }
  void plan(const StopCondition& stop, const Watch& watch) override {
    const RunOptions& run = command_.run;
    answer_.tour.status = Status::interrupted;
    if (!answer_.map.planner) return;
    const TourRequest asked = request_of(command_, stop);
    CoverRequest request{.width = width_,
                         .open = asked.open,
                         .seed = asked.seed,
                         .generations = asked.generations,
                         .threads = asked.threads,
                         .stop = asked.stop};
    if (start_) request.start = start_->at();
    const TourObserver observer = told_to(watch, answer_.map.length_in(run.frame, 1), unit());
    in_metres_asked(answer_.map, run, [&] {
      const auto begin = Clock::now();
      cover_ = plan_cover(*answer_.map.planner, request, observer);
      answer_.elapsed_ms = ms_since(begin);
    });
    answer_.tour = cover_.tour;
    for (const Point p : cover_.stops) answer_.stops.push_back(place_at(p));
    if (start_ && !answer_.stops.empty()) {
      answer_.start = static_cast<int>(answer_.stops.size()) - 1;
      answer_.stops.back() = *start_;
    }
    if (start_ && answer_.tour.status == Status::invalid) look_at_start();
  }
  Record record() const override {
    const TourResult& tour = answer_.tour;
    const Place nowhere;
    const Place& start = start_ ? *start_ : nowhere;
    const MapEnds ends(answer_.map, command_.run, start, start, answer_.ends);
    Record record =
        map_record(ends, search_result(tour), tour::find_algorithm(command_.ants.algorithm()));
    record.format = kTourFormat;
    if (answer_.ends.fault == Fault::none) record.error = tour.error;
    record.inputs = {{"map", map_json(answer_.map)}};
    if (!start_) record.start = Json();
    record.goal = Json();
    add_parameters(record.parameters, command_);
    record.elapsed_ms = answer_.elapsed_ms;
    for (const auto& path : tour_paths(answer_, in_metres())) record.path = coordinates(path);
    if (!command_.run.json && record.has_path()) record.remarks.push_back(summary(record));
    if (wants_json(command_.run)) record.answer = answer_of(ends, record);
    return record;
  }
  Forms show(const Record& run) const override {
    return {
        .picture =
            [&](auto& file) { write_cover_picture(file, command_.run, answer_, cover_, width_); },
        .yaml = [&](std::ostream& out) { write_tour_poses(out, answer_, command_.run); },
        .page = [&](std::ostream& out) { write_tour_page(out, run, answer_, command_.run); }};
  }
  SearchOptions& options() override { return command_.run; }

 private:
  bool in_metres() const { return command_.run.frame == Frame::world; }
  std::string unit() const { return in_metres() ? "m" : ""; }
  double told_length(double cells) const {
    return answer_.map.length_in(command_.run.frame, cells);
  }

  /// The library speaks of cells.
  void check_width() const {
    const Grid& grid = answer_.map.as_read();
    const int longest = std::max(grid.width(), grid.height());
    const std::string given = "--cover " + to_text(*command_.cover);
    const std::string in = command_.run.map.radius_metres ? " m" : " cells";
    const double most = command_.run.map.radius_metres ? answer_.map.metres(longest) : longest;
    if (!(width_ > 0) || width_ > longest)
      throw UsageError(given + " is no width: give more than 0 and at most the map's " +
                       to_text(most) + in);
  }
  Place place_at(Point p) const {
    const auto whole = [](double v, int side) {
      return std::min(static_cast<int>(std::floor(v)), side - 1);
    };
    const Grid& grid = answer_.map.as_read();
    const Cell cell{whole(p.x, grid.width()), whole(p.y, grid.height())};
    return {.cell = cell,
            .number = {1.0 * cell.x, 1.0 * cell.y},
            .asked = in_metres() ? answer_.map.to_world(p) : p,
            .point = p};
  }
  /// Asks for what `plan` says of an invalid start.
  void look_at_start() {
    const Request ends = lasius::tool::request_of(answer_.map, command_.run, *start_, *start_);
    Result said = answer_.map.planner->plan(ends, command_.run.params);
    if (said.fault == Fault::start_outside || said.fault == Fault::start_blocked) {
      answer_.ends = of_tour(std::move(said), true);
      return;
    }
    // A path may lead out from there, a tool that keeps its radius may not.
    const Frame frame = command_.run.frame;
    const bool curved = route_of(answer_.map, command_.run).curved;
    answer_.tour.error =
        "start " + place_text(*start_, frame) +
        obstruction_text(answer_.map, frame, obstruction_of(answer_.map, *start_, curved));
  }
  std::string summary(const Record& record) const {
    std::string text =
        counted(cover_.swaths(), "swath") + printed(", %.2f%%", 100 * cover_.covered) +
        " covered of what the tool can come to, " +
        printed("%.2f%% of the free area is out of its reach", 100 * cover_.unreachable);
    if (!cover_.tour.lower_bound) return text;
    text += "; no order of these swaths is below " +
            decimal_text(record.scale * *cover_.tour.lower_bound, 3);
    if (in_metres()) text += " m";
    return text;
  }
  Json cover_json(bool found) const {
    Json json = {{"width", number(width_)}};
    const auto add = [&](const char* key, double value) {
      json[key] = found ? number(value) : Json();
    };
    add("angle", cover_.angle);
    json["swaths"] = cover_.swaths();
    add("swept", cover_.swept);
    add("covered", cover_.covered);
    add("overlap", cover_.overlap);
    add("unreachable", cover_.unreachable);
    add("resolution", cover_.resolution);
    if (in_metres()) {
      json["width_m"] = number(told_length(width_));
      add("swept_m", told_length(cover_.swept));
    }
    return json;
  }
  Json answer_of(const MapEnds& ends, const Record& record) const {
    const bool found = record.has_path();
    Json json = {{"stops", points(cover_.stops)}};
    if (in_metres()) {
      Json world = Json::array();
      for (const Place& stop : answer_.stops) world.push_back(point(stop.asked));
      json["stops_world"] = std::move(world);
      json["start_world"] = start_ ? point(start_->asked) : Json();
    }
    json.update(order_json(answer_.tour));
    json["legs"] = found ? legs_json(answer_, in_metres()) : Json();
    json["length"] = number(record.result.length);
    if (in_metres()) json["length_m"] = number(record.scale * record.result.length);
    add_proof(json, record.result);
    json["cover"] = cover_json(found);
    json["left_out"] = Json::array();
    json["priced"] = answer_.tour.priced;
    if (answer_.ends.fault != Fault::none) json.update(end_findings(ends));
    return json;
  }

  TourCommand command_;
  double width_ = 0;  // cells
  std::optional<Place> start_;
  TourAnswer answer_{};  // its stops are the ends of swaths, and the start
  CoverResult cover_;
};

}  // namespace

std::unique_ptr<Problem> cover_problem(TourCommand command) {
  return std::make_unique<CoverProblem>(std::move(command));
}

void read_recorded_cover(const Json& result, TourCommand& command) {
  command.cover = recorded_real(result, "cover/width", 0, 1e9);
}

}  // namespace lasius::tool
