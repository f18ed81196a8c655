#include "bench/answer_files.h"

#include <cmath>
#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>
#include <utility>

#include "core/base/output.h"
#include "lasius/error.h"
#include "lasius/map_io.h"

namespace lasius::bench {
namespace {

namespace fs = std::filesystem;

void write_text(const fs::path& file, const auto& write) {
  write_file(file.string(), [&](std::ostream& out) {
    out.precision(std::numeric_limits<double>::max_digits10);
    write(out);
  });
}

}  // namespace

AnswerFiles::AnswerFiles(std::string folder) : folder_(std::move(folder)) {
  fs::create_directories(folder_);
  if (!fs::is_empty(folder_)) {
    throw Error(ErrorCode::output_failed, {folder_}, "not an empty folder", "name a new one");
  }
}

void AnswerFiles::write_map(const QuerySource& source, const QuerySet& set,
                            std::span<const double> optima) const {
  const std::string name = (fs::path(folder_) / set.name).string();
  if (source.map.empty()) {
    lasius::write_map(set.grid, name + ".map");
  } else {
    fs::copy_file(source.map, name + ".map");  // throws where another map has that name
  }
  write_text(name + ".tsv", [&](std::ostream& out) {
    out << "sx\tsy\tgx\tgy\teuclid\n";
    for (std::size_t i = 0; i < set.queries.size(); ++i) {
      const Query& q = set.queries[i];
      out << q.start.x << '\t' << q.start.y << '\t' << q.goal.x << '\t' << q.goal.y << '\t'
          << (std::isnan(q.optimum) ? optima[i] : q.optimum) << '\n';
    }
  });
}

void AnswerFiles::write_answers(const std::string& name, const std::string& algorithm,
                                std::span<const Result> answers) const {
  write_text(fs::path(folder_) / (name + "." + algorithm + ".jsonl"), [&](std::ostream& out) {
    for (const Result& answer : answers) {
      nlohmann::json path = nlohmann::json::array();
      for (const Point p : answer.path) path.push_back({p.x, p.y});
      out << nlohmann::json{{"status", to_string(answer.status)},
                            {"length", answer.length},
                            {"path", std::move(path)}}
          << '\n';
    }
  });
}

}  // namespace lasius::bench
