// lasius_bench quality: gap to the optimum over many seeds, with and without pheromone.
#include <sstream>

#include "bench/commands.h"
#include "bench/quality.h"
#include "bench/report.h"
#include "lasius/error.h"
#include "lasius/map_io.h"

namespace lasius::bench {
namespace {

struct Options {
  std::string algorithm = "fan2004";
  int seeds = 30;
  int blobs = 20;
  std::uint64_t first_blobs = 1001;
  bool fan = true;
  std::vector<std::string> courses;  // FILE,X,Y,X,Y
  std::string markdown;
};

Course parse_course(const std::string& text) {
  const auto parts = CLI::detail::split(text, ',');
  if (parts.size() != 5) {
    throw Error(ErrorCode::invalid_parameter, "course " + text, "give FILE,X,Y,X,Y");
  }
  Course course{parts[0].substr(parts[0].find_last_of('/') + 1), read_map(parts[0]).grid, {}, {}};
  course.start = {std::stoi(parts[1]), std::stoi(parts[2])};
  course.goal = {std::stoi(parts[3]), std::stoi(parts[4])};
  return course;
}

std::string percent(double share) { return short_number(100 * share); }

void write_row(std::ostream& out, const Quality& with, const Quality& without) {
  out << "| " << with.course << " | " << short_number(with.optimum);
  for (const Quality* q : {&with, &without}) {
    out << " | " << percent(q->median_gap()) << " | " << percent(q->worst_gap()) << " | "
        << short_number(q->median_last_improvement()) << " | "
        << short_number(q->median_last_as_walked());
  }
  out << " | " << percent(with.least_arrived()) << " |" << std::endl;
}

void run(const Options& options) {
  std::vector<Course> courses;
  if (options.fan) courses.push_back(fan_course());
  for (const std::string& text : options.courses) courses.push_back(parse_course(text));
  auto blobs = blobs_courses(options.blobs, options.first_blobs);
  for (Course& course : blobs) courses.push_back(std::move(course));

  const Params params(options.algorithm);
  std::ostringstream table;
  Output output(options.markdown);
  const auto flush = [&] {
    output.write(table.str());
    table.str({});
  };
  table << machine_line() << ". `" << options.algorithm << "`, its defaults, seeds 1 to "
        << options.seeds
        << "; gap to the exact optimum in per cent, iteration of the last improvement and of that "
           "of the shortest tour as walked, both in the median, least share of ants that arrived "
           "in a run; then the same with pheromone switched off.\n\n"
        << "| map | optimum | median gap | worst gap | last improvement | as walked | no "
           "pheromone: median | worst | last improvement | as walked | arrived, % |\n"
        << "|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|\n";
  flush();
  Quality all, all_without;
  for (const Course& course : courses) {
    const Quality with = measure_quality(course, params, options.seeds);
    const Quality without = measure_quality(course, without_pheromone(params), options.seeds);
    write_row(table, with, without);
    flush();
    if (!course.name.starts_with("blobs")) continue;
    all.runs.insert(all.runs.end(), with.runs.begin(), with.runs.end());
    all_without.runs.insert(all_without.runs.end(), without.runs.begin(), without.runs.end());
  }
  if (!all.runs.empty()) {
    all.course = "**all blobs**";
    all.optimum = std::numeric_limits<double>::quiet_NaN();
    write_row(table, all, all_without);
    flush();
  }
}

}  // namespace

void add_quality_command(CLI::App& app) {
  const auto [command, options] =
      add_command(app, "quality", "Gap to the optimum over many seeds", run);
  command.add_option("--algorithm", options.algorithm, "Of the colony")->capture_default_str();
  add_number(command, "--seeds", options.seeds, "Runs of each course", 1, 100000);
  add_number(command, "--blobs", options.blobs, "Generated blobs maps of 400 x 200", 0, 10000);
  add_number(command, "--first-blobs", options.first_blobs, "Seed of the first of them");
  command.add_flag("!--no-fan", options.fan, "Leave out maps/fan400x200.map");
  command.add_option("--course", options.courses, "More courses: FILE,X,Y,X,Y");
  add_output(command, options.markdown);
}

}  // namespace lasius::bench
