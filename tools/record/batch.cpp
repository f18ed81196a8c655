#include "tools/record/batch.h"

#include <chrono>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <sstream>

#include "tools/console/exit_code.h"
#include "tools/console/progress.h"
#include "tools/console/streams.h"
#include "tools/console/values.h"
#include "tools/record/outputs.h"

namespace lasius::tool {
namespace {

std::string header(const std::string& unit, bool poses, bool costs) {
  const std::string m = unit.empty() ? "" : "_" + unit;
  std::string row = "index";
  for (const std::string end : {"s", "g"})
    row += "," + end + "x" + m + "," + end + "y" + m + (poses ? "," + end + "yaw" : "");
  return row + ",status,length" + m + (costs ? ",cost,lower_bound" : ",lower_bound" + m) +
         ",gap,iterations,elapsed_ms,seed,optimum" + m + ",optimum_gap\n";
}

std::string row(const Record& run, const std::vector<std::string>& ends) {
  const SearchResult& result = run.result;
  std::ostringstream row;
  const auto add = [&](const std::optional<double>& value) {
    row << "," << finite_text(value.value_or(std::nan("")));
  };
  const auto shown = [&](const std::optional<double>& length) {
    add(length ? std::optional(run.scale * *length) : length);
  };
  row << run.index.value_or(0);
  for (const std::string& end : ends) row << "," << end;
  row << "," << to_string(result.status);
  shown(result.length);
  if (run.cost) {
    add(run.cost);
    add(result.lower_bound);
  } else {
    shown(result.lower_bound);
  }
  add(run.gap);
  row << "," << result.iterations << "," << to_text(run.elapsed_ms) << "," << run.seed;
  shown(run.optimum);
  add(gap_to(run.optimum, result.length));
  row << "\n";
  return row.str();
}

/// Prints answers as they come, and keeps what the files that are asked for need of them.
class BatchOutput {
 public:
  explicit BatchOutput(const Batch& batch)
      : batch_(batch),
        total_(static_cast<std::int64_t>(batch.queries) * batch.options.seeds),
        delivery_(batch.options.outputs),
        bar_(std::in_place, wants_progress(batch.options.messages), total_),
        rows_(header(batch.unit, batch.poses, batch.costs)) {
    for (const auto& file : batch.options.outputs) {
      csv_ |= is_table(file);
      paths_ |= is_picture(file);
      json_ |= !is_table(file) && !is_picture(file);
    }
  }

  void add(const Record& run, const std::vector<std::string>& ends,
           const std::vector<Point>& path) {
    const std::string text = json_line(run);
    delivery_.print(text);
    bar_->update(++done_, "queries");
    if (json_) lines_ += text;
    ++answers_[run.result.status];
    if (paths_ && run.has_path()) kept_.push_back(path);
    if (csv_) rows_ += row(run, ends);
    if (code_ == kFound) return;
    code_ = exit_code(run);
    why_ = explain(run);
  }

  /// Tells of answers that are missing or not final. The exit code.
  int finish(bool interrupted) {
    bar_.reset();
    const auto say = [&](const char* what, std::int64_t count) {
      if (!batch_.options.messages.quiet)
        message(what + std::to_string(count) + " of " + counted(total_, "answer"));
    };
    if (const auto cut = answers_[Status::limit]) say("the time limit ended ", cut);
    if (interrupted) say("interrupted after ", done_ - answers_[Status::interrupted]);
    if (interrupted) return kInterrupted;
    if (!batch_.is_plan || code_ == kFound) return kFound;
    message(why_);
    return code_;
  }

  void write_files() {
    delivery_.write([&](const std::string& file) {
      write_output(file, {.json = [&](auto& out) { out << lines_; },
                          .csv = [&](auto& out) { out << rows_; },
                          .picture = [&](auto& name) { batch_.draw(name, kept_, caption()); }});
    });
  }

 private:
  std::string caption() const {
    std::string text = counted(static_cast<std::int64_t>(kept_.size()), "path") + "; answers:";
    for (const auto& [status, count] : answers_)
      text.append(text.back() == ':' ? " " : ", ").append(to_string(status)) +=
          printed(" %lld", static_cast<long long>(count));
    return text;
  }

  const Batch& batch_;
  std::int64_t total_;
  Delivery delivery_;
  std::optional<ProgressLine> bar_;
  std::int64_t done_ = 0;
  std::map<Status, std::int64_t> answers_;  ///< how many, by their status
  int code_ = kNoPath;
  std::string why_;
  bool json_ = false, csv_ = false, paths_ = false;
  std::string lines_, rows_;
  Batch::Paths kept_;
};

}  // namespace

int run_batch(const Batch& batch, const SignalWatcher& signals) {
  const SearchOptions& options = batch.options;
  if (!options.messages.quiet)
    for (const auto& note : options.notes) message(note);
  BatchOptions how{.threads = options.threads, .token = signals.token(), .seeds = options.seeds};
  if (options.time_limit) how.time_limit = std::chrono::duration<double>(*options.time_limit);
  BatchOutput output(batch);
  batch.answer(how, [&](const auto&... answer) { output.add(answer...); });
  output.write_files();
  return output.finish(signals.interrupted());
}

}  // namespace lasius::tool
