#include "tools/record/batch_output.h"

#include <cmath>
#include <sstream>

#include "tools/console/values.h"

namespace lasius::tool {

BatchOutput::BatchOutput(const Task& task, std::int64_t total)
    : delivery_(task.options().outputs), bar_(wants_progress(task.options().messages), total) {
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

void BatchOutput::add(const Task& task, const std::vector<std::string>& ends,
                      const std::vector<Point>& path) {
  const std::string text = json_line(task);
  delivery_.print(text);
  bar_.update(++done_, "queries");
  if (json_) lines_ += text;
  if (paths_ && task.has_path()) kept_.push_back(path);
  if (!csv_) return;
  const SearchResult& result = task.result();
  const double none = std::nan("");
  std::ostringstream row;
  row << task.index().value_or(0);
  for (const std::string& end : ends) row << "," << end;
  row << "," << to_string(result.status) << "," << finite_text(task.shown(result.length)) << ","
      << finite_text(task.shown(result.lower_bound.value_or(none))) << ","
      << finite_text(result.gap().value_or(none)) << "," << result.iterations << ","
      << to_text(task.elapsed_ms()) << "," << task.options().seed << ","
      << finite_text(task.shown(task.optimum().value_or(none))) << ","
      << finite_text(gap_to(task.optimum(), result.length).value_or(none)) << "\n";
  rows_ += row.str();
}

void BatchOutput::write_files(const Draw& draw) {
  delivery_.write([&](const std::string& file) {
    write_output(file, {.json = [&](auto& out) { out << lines_; },
                        .csv = [&](auto& out) { out << rows_; },
                        .picture = [&] { draw(file, kept_); }});
  });
}

}  // namespace lasius::tool
