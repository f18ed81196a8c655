// `plan` and each query of `batch` on a bitmap.
#pragma once

#include <memory>
#include <optional>

#include "tools/bitmap/answer.h"
#include "tools/bitmap/map_file.h"
#include "tools/bitmap/picture_recorder.h"
#include "tools/bitmap/run_frames.h"
#include "tools/record/task.h"

namespace lasius::tool {

using SharedMap = std::shared_ptr<LoadedMap>;

class BitmapTask : public Task {
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
  const Algorithm& algorithm() const override;
  std::string parameter(std::string_view name) const override;
  std::int64_t iterations() const override { return options().params.iterations; }

  const Result& result() const override { return answer_.result; }
  std::string error() const override;
  std::optional<double> optimum() const override { return answer_.optimum; }
  double elapsed_ms() const override { return answer_.elapsed_ms; }

  double shown(double length) const override;
  std::string unit() const override { return in_metres() ? "m" : ""; }
  void remark() const override;
  void write_path(std::ostream& out, const char* between) const override;
  void write_picture(const std::string& file) const override;
  void write_report(std::ostream& out) const override;
  /// Start and goal as they were asked for, a coordinate a text.
  std::vector<std::string> end_texts() const;

  std::optional<std::size_t> index() const override { return answer_.index; }
  Json inputs() const override;
  std::pair<Json, Json> ends() const override;
  void add_settings(Json& json) const override;
  void add_path(Json& json) const override;
  void add_findings(Json& json) const override;

 private:
  bool in_metres() const { return options().frame == Frame::world; }

  PlanCommand command_;
  SharedMap map_;
  std::optional<PictureRecorder> recorder_;
  std::optional<RunFrames> frames_;
  Answer answer_;
};

/// A result's question again. `last` keeps its map for the next: the lines of a batch share one.
std::unique_ptr<Task> recorded_bitmap(const Recorded& recorded, SharedMap& last);

}  // namespace lasius::tool
