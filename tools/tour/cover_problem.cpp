#include "tools/tour/cover_problem.h"

#include <cmath>
#include <utility>

#include "lasius/base/error.h"
#include "lasius/tour/cover.h"
#include "tools/bitmap/answer.h"
#include "tools/bitmap/bitmap_problem.h"
#include "tools/bitmap/map_ends.h"
#include "tools/bitmap/reasons.h"
#include "tools/console/values.h"
#include "tools/record/recorded.h"
#include "tools/tour/cover_picture.h"
#include "tools/tour/tour_problem.h"

namespace lasius::tool {
namespace {

/// The stops of its answer are the ends of swaths, and the start.
class CoverProblem : public TourProblem {
 public:
  using TourProblem::TourProblem;

  Forms show(const Record& run) const override {
    Forms forms = TourProblem::show(run);
    forms.picture = [&](auto& file) {
      write_cover_picture(file, command_.run, answer_, cover_, width_);
    };
    return forms;
  }

 protected:
  void read_world(const std::stop_token& token) override {
    TourProblem::read_world(token);
    width_ = answer_.map.cells_of(command_.run.map.radius_metres, *command_.cover);
    check_width();
  }
  TourResult tour_of(const TourRequest& asked, const Watch& watch) override {
    const RunOptions& run = command_.run;
    cover_.tour.status = Status::interrupted;
    if (!answer_.map.planner) return cover_.tour;
    CoverRequest request{.width = width_,
                         .open = asked.open,
                         .seed = asked.seed,
                         .generations = asked.generations,
                         .threads = asked.threads,
                         .stop = asked.stop};
    std::optional<Place> start;
    if (answer_.start) start = place_at(*answer_.start), request.start = start->at();
    const TourObserver observer = told_to(watch, answer_.map.length_in(run.frame, 1), unit());
    in_metres_asked(answer_.map, run,
                    [&] { cover_ = plan_cover(*answer_.map.planner, request, observer); });
    if (cover_.stops.empty()) return cover_.tour;
    answer_.stops.clear();
    for (const Point p : cover_.stops) answer_.stops.push_back(place_of(p));
    if (start) {
      answer_.start = static_cast<int>(answer_.stops.size()) - 1;
      answer_.stops.back() = *start;
    }
    return cover_.tour;
  }
  // A path may lead out from a start that a tool which keeps its radius has no place at.
  void look_at_ends() override {
    TourProblem::look_at_ends();
    if (!answer_.start || answer_.ends.fault != Fault::none) return;
    const Place& start = place_at(*answer_.start);
    if (answer_.map.planner->clear_at(start.at())) return;
    const Frame frame = command_.run.frame;
    const bool curved = route_of(answer_.map, command_.run).curved;
    answer_.tour.error =
        "start " + place_text(start, frame) +
        obstruction_text(answer_.map, frame, obstruction_of(answer_.map, start, curved));
  }
  std::string summary(const Record& record) const override {
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
  void add_answer(Json& json) const override {
    json["stops"] = points(cover_.stops);
    if (in_metres() && cover_.stops.empty()) json["stops_world"] = Json::array();
    json["cover"] = cover_json(!cover_.stops.empty());
  }

 private:
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
  Place place_of(Point p) const {
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

  double width_ = 0;  // cells
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
