#include "tools/record/batch.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <sstream>

#include "tools/console/exit_code.h"
#include "tools/console/progress.h"
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
        delivery_(task.options().outputs),
        bar_(wants_progress(task.options().messages), static_cast<std::int64_t>(total)) {
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
    bar_.update(++done_, "queries");
    if (json_) lines_ += text;
    if (paths_ && task_.has_path()) kept_.push_back(path);
    if (csv_) rows_ += row(ends);
  }

  void write_files(const Batch& batch) {
    delivery_.write([&](const std::string& file) {
      write_output(file, {.json = [&](auto& out) { out << lines_; },
                          .csv = [&](auto& out) { out << rows_; },
                          .picture = [&] { batch.draw(file, kept_); }});
    });
  }

 private:
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
  Delivery delivery_;
  ProgressLine bar_;
  std::int64_t done_ = 0;
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
  // The optimum is asked beside each chunk, so that answers still stream.
  const std::size_t chunk = options.with_optimum ? 256 : std::max<std::size_t>(batch.queries, 1);
  for (std::size_t from = 0; from < batch.queries && !signals.interrupted(); from += chunk)
    batch.answer(from, std::min(chunk, batch.queries - from), how,
                 [&](const auto& ends, const auto& path) { output.add(ends, path); });
  output.write_files(batch);
  return signals.interrupted() ? kInterrupted : kFound;
}

}  // namespace lasius::tool
