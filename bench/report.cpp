#include "bench/report.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <functional>
#include <iostream>
#include <sstream>
#include <string_view>

#include "bench/statistics.h"
#include "core/base/output.h"
#include "lasius/version.h"

namespace lasius::bench {
namespace {

std::string cpu_name() {
  std::ifstream in("/proc/cpuinfo");
  for (std::string line; std::getline(in, line);) {
    if (line.rfind("model name", 0) == 0) return line.substr(line.find(':') + 2);
  }
  return "unknown CPU";
}

using Value = std::function<double(const MapComparison&, std::size_t planner)>;

// One line a map, then the geometric mean where it means something.
void write_table(std::ostream& out, std::span<const MapComparison> maps,
                 std::span<const peers::Peer> planners, const Value& value, bool mean) {
  out << "| map |";
  for (const auto& planner : planners) out << ' ' << planner.name << " |";
  out << "\n|---|";
  for (std::size_t i = 0; i < planners.size(); ++i) out << "--:|";
  out << '\n';
  std::vector<GeometricMean> means(planners.size());
  for (const MapComparison& map : maps) {
    std::vector<double> row;
    for (std::size_t p = 0; p < planners.size(); ++p) {
      row.push_back(value(map, p));
      means[p].add(row.back());
    }
    out << table_line(map.name, row);
  }
  if (mean && maps.size() > 1) {
    std::vector<double> row;
    for (const GeometricMean& one : means) row.push_back(one.value());
    out << table_line("**geometric mean**", row);
  }
  out << '\n';
}

void write_faults(std::ostream& out, std::span<const MapComparison> maps,
                  std::span<const peers::Peer> planners) {
  out << count_faults(maps) << " faults.\n";
  for (const MapComparison& map : maps) {
    for (std::size_t p = 0; p < planners.size(); ++p) {
      for (std::size_t q = 0; q < map.optima.size(); ++q) {
        const Measurement& m = map.planners[p].queries[q];
        if (m.fault.empty()) continue;
        out << "* " << map.name << ", query " << q << ", " << planners[p].name << ": " << m.fault
            << '\n';
      }
    }
  }
}

}  // namespace

std::string machine_line() {
#ifdef __clang__  // which names itself
  constexpr std::string_view kCompiler = __VERSION__;
#else
  constexpr std::string_view kCompiler = "GCC " __VERSION__;
#endif
  std::ostringstream line;
  line << cpu_name() << "; " << kCompiler << "; lasius " << LASIUS_VERSION;
  return line.str();
}

std::string short_number(double value) {
  if (!std::isfinite(value)) return "-";
  if (value == 0) return "0";
  const int digits =
      std::clamp(2 - static_cast<int>(std::floor(std::log10(std::abs(value)))), 0, 6);
  char text[40];
  std::snprintf(text, sizeof text, "%.*f", digits, value);
  return text;
}

std::string table_line(const std::vector<std::string>& cells) {
  std::string line = "|";
  for (const std::string& cell : cells) line += " " + cell + " |";
  return line + "\n";
}

std::string table_line(const std::string& name, const std::vector<double>& figures) {
  std::vector<std::string> cells{name};
  for (const double figure : figures) cells.push_back(short_number(figure));
  return table_line(cells);
}

void Output::write(const std::string& text) {
  std::cout << text << std::flush;
  text_ += text;
  if (!file_.empty()) write_file(file_, [&](std::ostream& out) { out << text_; });
}

Table::Table(const std::string& heading, const std::vector<Column>& columns, std::string file)
    : output_(std::move(file)) {
  output_.write(machine_line() + ". " + heading + "\n\n");
  begin(columns);
}

void Table::begin(const std::vector<Column>& columns) {
  std::vector<std::string> names;
  std::string rule = "|---|";
  for (const Column& column : columns) {
    if (!names.empty()) rule += column.align == Align::left ? "---|" : "--:|";
    names.push_back(column.name);
  }
  output_.write(table_line(names) + rule + "\n");
}

void Table::add(const std::vector<Figure>& figures) {
  for (const Figure& figure : figures) row({figure.what, figure.value, figure.aim});
}

void Table::next(const std::string& text, const std::vector<Column>& columns) {
  output_.write("\n" + text + "\n\n");
  begin(columns);
}

std::size_t count_faults(std::span<const MapComparison> maps) {
  std::size_t faults = 0;
  for (const MapComparison& map : maps) {
    for (const PlannerRun& run : map.planners) {
      for (const Measurement& m : run.queries) faults += m.fault.empty() ? 0 : 1;
    }
  }
  return faults;
}

void write_markdown(std::ostream& out, std::span<const MapComparison> maps,
                    std::span<const peers::Peer> planners, std::size_t subject,
                    const ComparisonOptions& options, const std::string& seeds) {
  std::size_t queries = 0;
  for (const MapComparison& map : maps) queries += map.optima.size();
  out << machine_line() << ". One thread; " << maps.size() << " maps, " << queries
      << " queries, the median of up to " << options.rounds
      << " rounds each, planners taking turns; wall clock, or processor time where a query was "
         "interrupted; "
      << seeds << ".\n\n";

  const auto table = [&](const std::string& title, bool mean, const auto& value) {
    write_table(out << title << ":\n\n", maps, planners, value, mean);
  };
  using Map = MapComparison;
  table("Mean time of a query, microseconds", true,
        [](const Map& m, std::size_t p) { return m.planners[p].mean_microseconds(); });
  table("Median time of a query, microseconds", true,
        [](const Map& m, std::size_t p) { return m.planners[p].median_microseconds(); });
  table("Mean time divided by that of " + std::string(planners[subject].name), true,
        [subject](const Map& m, std::size_t p) {
          return m.planners[p].mean_microseconds() / m.planners[subject].mean_microseconds();
        });
  table("Mean gap to the optimum, per cent", false, [](const Map& m, std::size_t p) {
    const double gap = 100 * m.mean_gap(p);
    return gap < 1e-6 ? 0 : gap;
  });
  table("Preparation of a map, milliseconds", false,
        [](const Map& m, std::size_t p) { return m.planners[p].preparation_ms; });
  const auto counts = [](const PlannerRun& run) { return std::isfinite(run.prepared_bytes); };
  if (std::ranges::any_of(maps,
                          [&](const Map& m) { return std::ranges::any_of(m.planners, counts); }))
    table("Held by the preparation, megabytes, where it is counted", false,
          [](const Map& m, std::size_t p) { return 1e-6 * m.planners[p].prepared_bytes; });
  write_faults(out, maps, planners);
}

}  // namespace lasius::bench
