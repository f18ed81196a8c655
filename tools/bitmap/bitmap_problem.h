// `plan` and each query of `batch` on a bitmap.
#pragma once

#include <memory>
#include <optional>

#include "tools/bitmap/answer.h"
#include "tools/bitmap/picture_recorder.h"
#include "tools/bitmap/run_frames.h"
#include "tools/console/kinds.h"
#include "tools/record/problem.h"

namespace lasius::tool {

const ProblemKind& bitmap_kind();

/// Of results of bitmaps and drives, why a replay would come out other.
std::string unlike_radius(const Json& result);

/// What -v says of a map that was read, in how far --prepare has no effect, and what --prepared
/// names where a stop left it unwritten.
void note_map(const LoadedMap& map, RunOptions& run, const std::stop_token& token);

/// The files that the map and its costs name, among the inputs.
void note_files(const LoadedMap& map, SearchOptions& options);

/// An answer as its result tells it.
Record record_of(const LoadedMap& map, const RunOptions& run, const Answer& answer);

/// `batch`, and `plan` with several seeds. The exit code.
int run_bitmap_batch(const PlanCommand& command);

class BitmapProblem : public ProblemOf<PlanCommand> {
 public:
  /// `map` may be given, made ready for `command`; else it is read.
  explicit BitmapProblem(PlanCommand command, std::shared_ptr<LoadedMap> map = {})
      : ProblemOf(std::move(command)), map_(std::move(map)) {}

  std::optional<std::int64_t> read(const std::stop_token& token) override;
  void plan(const StopCondition& stop, const Watch& watch) override;
  Record record() const override { return record_of(*map_, command_.run, answer_); }
  Forms show(const Record& run) const override;

  const std::shared_ptr<LoadedMap>& map() const { return map_; }

 private:
  std::shared_ptr<LoadedMap> map_;
  std::optional<PictureRecorder> recorder_;
  std::optional<RunFrames> frames_;
  Answer answer_;
};

}  // namespace lasius::tool
