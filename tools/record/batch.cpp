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

/// Prints answers as they come, and keeps what the files that are asked for need of them.
class BatchOutput {
 public:
  /// `total`: answers that will come.
  BatchOutput(const Task& task, std::size_t total)
      : task_(task),
        total_(static_cast<std::int64_t>(total)),
        delivery_(task.options().outputs),
        bar_(std::in_place, wants_progress(task.options().messages), total_) {
    for (const auto& file : task.options().outputs) {
      csv_ |= is_table(file);
      paths_ |= is_picture(file);
      json_ |= !is_table(file) && !is_picture(file);
    }
    const std::string m = task.unit().empty() ? "" : "_" + task.unit();
    rows_ = "index";
    for (const char* column : {"sx", "sy", "gx", "gy"}) rows_ += std::string(",") + column + m;
    rows_ += ",status,length" + m + ",lower_bound" + m + ",gap,iterations,elapsed_ms,seed,optimum" +
             m + ",optimum_gap\n";
  }

  void add(const std::vector<std::string>& ends, const std::vector<Point>& path) {
    const std::string text = json_line(task_);
    delivery_.print(text);
    bar_->update(++done_, "queries");
    if (json_) lines_ += text;
    ++answers_[task_.result().status];
    if (paths_ && task_.has_path()) kept_.push_back(path);
    if (csv_) rows_ += row(ends);
    if (code_ == kFound) return;
    code_ = exit_code(task_);
    why_ = explain(task_);
  }

  /// Tells of answers that are missing or not final. The exit code.
  int finish(const Batch& batch, bool interrupted) {
    bar_.reset();
    const auto say = [&](const char* what, std::int64_t count) {
      if (!task_.options().messages.quiet)
        message(what + std::to_string(count) + " of " + counted(total_, "answer"));
    };
    if (const auto cut = answers_[Status::limit]) say("the time limit ended ", cut);
    if (interrupted) say("interrupted after ", done_ - answers_[Status::interrupted]);
    if (interrupted) return kInterrupted;
    if (!batch.is_plan || code_ == kFound) return kFound;
    message(why_);
    return code_;
  }

  void write_files(const Batch& batch) {
    delivery_.write([&](const std::string& file) {
      write_output(file, {.json = [&](auto& out) { out << lines_; },
                          .csv = [&](auto& out) { out << rows_; },
                          .picture = [&] { batch.draw(file, kept_, caption()); }});
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
  std::string row(const std::vector<std::string>& ends) const {
    const SearchResult& result = task_.result();
    const double none = std::nan("");
    std::ostringstream row;
    row << task_.index().value_or(0);
    for (const std::string& end : ends) row << "," << end;
    row << "," << to_string(result.status) << "," << finite_text(task_.shown(result.length)) << ","
        << finite_text(task_.shown(result.lower_bound.value_or(none))) << ","
        << finite_text(result.gap().value_or(none)) << "," << result.iterations << ","
        << to_text(task_.elapsed_ms()) << "," << task_.options().seed << ","
        << finite_text(task_.shown(task_.optimum().value_or(none))) << ","
        << finite_text(gap_to(task_.optimum(), result.length).value_or(none)) << "\n";
    return row.str();
  }

  const Task& task_;
  std::int64_t total_;
  Delivery delivery_;
  std::optional<ProgressLine> bar_;
  std::int64_t done_ = 0;
  std::map<Status, std::int64_t> answers_;  ///< how many, by their status
  int code_ = kNoPath;
  std::string why_;
  bool json_ = false, csv_ = false, paths_ = false;
  std::string lines_, rows_;
  std::vector<std::vector<Point>> kept_;
};

}  // namespace

int run_batch(const Batch& batch, const SignalWatcher& signals) {
  const SearchOptions& options = batch.task.options();
  if (!options.messages.quiet) batch.task.announce();
  BatchOptions how{.threads = options.threads, .token = signals.token(), .seeds = options.seeds};
  if (options.time_limit) how.time_limit = std::chrono::duration<double>(*options.time_limit);
  BatchOutput output(batch.task, batch.queries * static_cast<std::size_t>(options.seeds));
  batch.answer(how, [&](const auto& ends, const auto& path) { output.add(ends, path); });
  output.write_files(batch);
  return output.finish(batch, signals.interrupted());
}

}  // namespace lasius::tool
