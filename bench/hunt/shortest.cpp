// Shortest paths of a point, in every way in which the library finds them.
#include <array>
#include <map>
#include <optional>

#include "bench/hunt/drawing.h"
#include "lasius/plan/batch.h"
#include "lasius/plan/planner.h"
#include "tests/oracle/visibility_graph.h"

namespace lasius::bench {
namespace {

std::vector<Planner::Edit> draw_edits(HuntDraw& draw, const Grid& grid,
                                      std::span<const Cell> places) {
  std::vector<Planner::Edit> edits;
  for (int i = draw.between(1, 4); i > 0; --i) {
    const int x = draw.between(0, grid.width() - 1);
    const Cell cell{x, draw.between(0, grid.height() - 1)};
    bool place = false;
    for (const Cell p : places) place = place || p == cell;
    edits.push_back({cell, !place && draw.one_in(2)});
  }
  return edits;
}

// The answers about one map, and what is right.
class ShortestJudge {
 public:
  ShortestJudge(const Grid& grid, HuntVerdict& verdict)
      : grid_(grid), oracle_(grid), verdict_(verdict) {}

  void judge(std::string_view who, const Result& got, Point start, Point goal) {
    const auto& best = shortest(start, goal);
    verdict_.expect(right(got, best, start, goal), [&] {
      return sentence(who, " from ", told(start), " to ", told(goal), ": ", why_);
    });
    for (const Alternative& other : got.alternatives)
      verdict_.expect(!(why_ = path_fault(grid_, other.path, start, goal, other.length)).size() &&
                          other.length >= best->length - 1e-9 &&
                          other.length <= 1.3 * best->length + 1e-9,
                      [&] { return sentence(who, ": an alternative, ", why_); });
  }

  void judge_distance(double got, Point start, Point goal) {
    const auto& best = shortest(start, goal);
    verdict_.expect(best ? same_length(got, best->length) : std::isinf(got), [&] {
      return sentence("distance ", got, " from ", told(start), " to ", told(goal));
    });
  }

 private:
  const std::optional<oracle::Shortest>& shortest(Point start, Point goal) {
    const std::array key{start.x, start.y, goal.x, goal.y};
    const auto found = known_.find(key);
    if (found != known_.end()) return found->second;
    return known_.emplace(key, oracle_.shortest(start, goal)).first->second;
  }

  bool right(const Result& got, const std::optional<oracle::Shortest>& best, Point start,
             Point goal) {
    if (!best) {
      why_ = "a path where there is none";
      return got.status == Status::unreachable && got.path.empty();
    }
    why_ = sentence(to_string(got.status), ' ', got.length, " in place of ", best->length);
    if (got.status != Status::solved || !got.optimal || !same_length(got.length, best->length) ||
        !got.lower_bound || *got.lower_bound > best->length * (1 + 1e-9))
      return false;
    why_ = path_fault(grid_, got.path, start, goal, got.length);
    return why_.empty();
  }

  const Grid& grid_;
  oracle::VisibilityGraph oracle_;
  std::map<std::array<double, 4>, std::optional<oracle::Shortest>> known_;
  HuntVerdict& verdict_;
  std::string why_;
};

}  // namespace

void judge_shortest(const HuntCase& problem, HuntDraw& draw, HuntVerdict& verdict) {
  const auto& places = problem.places;
  const Planner plain(Grid(problem.grid)), graph = plain.prepared({.threads = 1});
  const Planner labels = plain.prepared({.threads = 1, .labels = true});
  std::vector<Point> points;
  const bool centres = draw.one_in(2);
  for (const Cell place : places) {
    const double x = centres ? 0.5 : draw.real(0, 1);
    points.push_back({place.x + x, place.y + (centres ? 0.5 : draw.real(0, 1))});
  }
  const int alternatives = draw.one_in(4) ? 3 : 0;
  const auto edits = draw_edits(draw, problem.grid, places);
  const Planner edited = *plain.edited(edits);
  const Planner stale_graph = *graph.edited(edits), stale_labels = *labels.edited(edits);

  ShortestJudge now(problem.grid, verdict), then(edited.grid(), verdict);
  std::vector<Request> requests;
  for (std::size_t a = 0; a < places.size(); ++a)
    for (std::size_t b = 0; b < places.size(); ++b) {
      Request request{.start = places[a], .goal = places[b], .alternatives = alternatives};
      if (!centres) request.start_point = points[a], request.goal_point = points[b];
      const auto ask = [&](ShortestJudge& judge, std::string_view who, const Planner& planner) {
        judge.judge(who, planner.plan(request), points[a], points[b]);
      };
      ask(now, "unprepared", plain);
      ask(now, "graph", graph);
      ask(now, "labels", labels);
      ask(then, "edited", edited);
      ask(then, "edited graph", stale_graph);
      ask(then, "edited labels", stale_labels);
      requests.push_back(request);
    }
  std::size_t next = 0;
  plan_batch(plain, requests, {}, {.threads = 1}, [&](const BatchAnswer& answer) {
    now.judge("batch", answer.result, points[next / places.size()], points[next % places.size()]);
    ++next;
  });
  for (const Planner* planner : {&plain, &graph, &labels}) {
    const auto rows = planner->distances(points, points, 1);
    for (std::size_t i = 0; i < rows->size(); ++i)
      now.judge_distance((*rows)[i], points[i / points.size()], points[i % points.size()]);
  }
}

}  // namespace lasius::bench
