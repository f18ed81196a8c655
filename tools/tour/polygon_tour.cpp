// `lasius tour WORLD.geojson`.
#include <memory>
#include <utility>

#include "lasius/polygon/plan.h"
#include "lasius/tour/tour.h"
#include "tools/console/values.h"
#include "tools/draw/text.h"
#include "tools/polygon/polygon_answer.h"
#include "tools/polygon/polygon_picture.h"
#include "tools/tour/stops_file.h"
#include "tools/tour/tour_picture.h"
#include "tools/tour/tour_problem.h"

namespace lasius::tool {
namespace {

class PolygonTour final : public TourProblem {
 public:
  using TourProblem::TourProblem;

  Forms show(const Record& run) const override {
    Forms forms = TourProblem::show(run);
    forms.yaml = {};
    forms.page = {};
    forms.picture = [&](const std::string& file) { write_picture(file, run.algorithm.name); };
    return forms;
  }

 private:
  void read_world(const std::stop_token&) override {
    const EndAtOnce unpolled;
    command_.world.file = command_.run.map.file;
    world_ = std::make_unique<const LoadedWorld>(load_world(command_.world));
    if (!command_.stops_file.empty())
      command_.stops = read_stops(command_.stops_file, Frame::world);
    note_world(*world_, tour::find_algorithm(command_.ants.algorithm()), command_.run);
  }
  Place to_place(const End& end) const override { return {.asked = end, .point = end}; }
  TourResult tour_of(const TourRequest& request, const Watch& watch) override {
    return polygon::plan_tour(world_->planner, request, told_to(watch, 1, ""));
  }
  std::string why_not(const Place& place, const std::string& name) const override {
    const polygon::Planner& planner = world_->planner;
    const Point p = place.at();
    if (planner.free(p))
      return name + "(" + to_text(p.x) + ", " + to_text(p.y) +
             ") cannot be reached from the others";
    constexpr std::size_t kRole = 6;  // "start "
    return name + planner.plan({.start = p, .goal = p}).error.substr(kRole);
  }
  void look_at_ends() override {}  // the error says it all
  Record head(Json&) const override {
    Record record{.options = command_.run,
                  .algorithm = tour::find_algorithm(command_.ants.algorithm()),
                  .inputs = inputs_json(*world_),
                  .result = search_result(answer_.tour)};
    if (answer_.start) record.start = point(place_at(*answer_.start).at());
    if (answer_.goal) record.goal = point(place_at(*answer_.goal).at());
    record.parameters = parameters_of(*world_, command_.run, record.algorithm);
    return record;
  }
  void write_picture(const std::string& file, std::string_view algorithm) const {
    const auto axes = [&](const Box& box) { return axes_of(*world_, box); };
    const auto at = [&](std::optional<int> stop) {
      return stop ? std::optional(place_at(*stop).at()) : std::nullopt;
    };
    const TourGround ground{
        .paint = [&](Canvas& canvas, const Box& box) { return draw_ground(canvas, box, *world_); },
        .path = [&](Canvas& canvas, const Box& box, const std::vector<Point>& path,
                    Colour colour) { canvas.polyline(axes(box).at(path), colour, 2.5); },
        .marks =
            [&](Canvas& canvas, const Box& box, std::optional<int> start, std::optional<int> goal) {
              draw_ends(canvas, axes(box), at(start), at(goal));
            },
        .length = [](double length) { return fixed(length, 3); },
        .shows = [](const Place&) { return true; }};
    write_tour_picture(file,
                       world_page(*world_, "tour, " + std::string(algorithm) + " on " +
                                               file_name(world_->options.file)),
                       ground, answer_);
  }

  std::unique_ptr<const LoadedWorld> world_;
};

}  // namespace

std::unique_ptr<Problem> polygon_tour(TourCommand command) {
  return std::make_unique<PolygonTour>(std::move(command));
}

void read_recorded_world(const Recorded& from, TourCommand& command) {
  command.world = recorded_world(from);
}

}  // namespace lasius::tool
