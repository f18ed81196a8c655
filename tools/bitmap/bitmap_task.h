// `plan` and each query of `batch` on a bitmap.
#pragma once

#include <memory>
#include <optional>

#include "tools/bitmap/answer.h"
#include "tools/bitmap/map_task.h"
#include "tools/bitmap/picture_recorder.h"
#include "tools/bitmap/run_frames.h"

namespace lasius::tool {

using SharedMap = std::shared_ptr<LoadedMap>;

class BitmapTask : public MapTask {
 public:
  /// `map` may be given, made ready for `command`; else `load` makes it.
  explicit BitmapTask(PlanCommand command, SharedMap map = {});

  void load(const std::stop_token& token) override;
  void announce() const override;
  void plan(const StopCondition& stop, const Watch& watch) override;
  void set_seed(std::uint64_t seed) { command_.run.seed = command_.run.params.seed = seed; }
  /// Takes an answer that was found elsewhere.
  void take(Answer answer) { answer_ = std::move(answer); }

  const RunOptions& options() const override { return command_.run; }
  std::vector<std::string> input_files() const override;
  std::int64_t iterations() const override { return options().params.iterations; }

  const Result& result() const override { return answer_.result; }
  std::optional<double> optimum() const override { return answer_.optimum; }
  double elapsed_ms() const override { return answer_.elapsed_ms; }

  void remark() const override;
  void write_path(std::ostream& out, const char* between) const override;
  void write_picture(const std::string& file) const override;
  void write_report(std::ostream& out) const override;
  /// Start and goal as they were asked for, a coordinate a text.
  std::vector<std::string> end_texts() const;

  Json inputs() const override;
  void add_path(Json& json) const override;
  void add_findings(Json& json) const override;

 private:
  Json curve_json(const LoadedMap* frame) const;

  const LoadedMap& map() const override { return *map_; }
  const Place& start() const override { return answer_.start; }
  const Place& goal() const override { return answer_.goal; }
  const std::optional<Cell>& nearest_free() const override { return result().nearest_free; }
  const Remedy* remedy() const override { return answer_.remedy ? &*answer_.remedy : nullptr; }
  const std::optional<Cell>& nearest_reachable() const override {
    return result().nearest_reachable;
  }
  const std::optional<Cell>& goal_reached() const override { return result().goal_reached; }
  std::optional<Point> way_out() const override { return result().way_out; }
  Point path_end() const override {
    return has_path() ? result().path.back() : MapTask::path_end();
  }

  PlanCommand command_;
  SharedMap map_;
  std::optional<PictureRecorder> recorder_;
  std::optional<RunFrames> frames_;
  Answer answer_;
};

/// A result's question again. `last` keeps its map for the next: the lines of a batch share one.
std::unique_ptr<Task> recorded_bitmap(const Recorded& recorded, SharedMap& last);

}  // namespace lasius::tool
