#include "tools/record/batch.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <sstream>
#include <string_view>
#include <system_error>
#include <utility>

#include "core/io/json_values.h"
#include "lasius/base/error.h"
#include "lasius/version.h"
#include "tools/console/crew.h"
#include "tools/console/exit_code.h"
#include "tools/console/progress.h"
#include "tools/console/streams.h"
#include "tools/console/values.h"
#include "tools/record/journal.h"
#include "tools/record/json_values.h"
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
  row << "," << result.curves.iterations << "," << to_text(run.elapsed_ms) << "," << run.seed;
  shown(run.optimum);
  add(gap_to(run.optimum, result.length));
  row << "\n";
  return row.str();
}

/// What is told of an answer.
struct Told {
  std::string line, row;  ///< the row where a table is asked for
  Status status = {};
  int code = kFound;
  std::string why;
  std::vector<Point> path;  ///< where a picture is asked for
};

std::string text_of(const Told& told) {
  json::Json path = json::Json::array();
  for (const Point p : told.path) path.push_back({p.x, p.y});
  return json::line({{"line", told.line},
                     {"row", told.row},
                     {"status", static_cast<int>(told.status)},
                     {"code", told.code},
                     {"why", told.why},
                     {"path", std::move(path)}});
}

Told told_of(const std::string& text) {
  const json::Json json = json::read(text, "an answer");
  Told told{.line = json.at("line"),
            .row = json.at("row"),
            .status = static_cast<Status>(json.at("status").get<int>()),
            .code = json.at("code"),
            .why = json.at("why"),
            .path = {}};
  for (const json::Json& p : json.at("path")) told.path.push_back({p.at(0), p.at(1)});
  return told;
}

/// Prints answers as they come, and keeps what the files that are asked for need of them.
class BatchOutput {
 public:
  BatchOutput(const Batch& batch, Delivery& delivery)
      : batch_(batch),
        total_(static_cast<std::int64_t>(batch.queries) * batch.options.seeds),
        delivery_(delivery),
        bar_(std::in_place, wants_progress(batch.options.messages), total_),
        rows_(header(batch.unit, batch.poses, batch.costs)) {
    for (const auto& file : batch.options.outputs) {
      csv_ |= is_table(file);
      paths_ |= is_picture(file);
      json_ |= !is_table(file) && !is_picture(file);
    }
  }

  /// By any thread.
  Told told(Record&& run, const std::vector<std::string>& ends,
            const std::vector<Point>& path) const {
    Told told{.line = {},
              .row = csv_ ? row(run, ends) : "",
              .status = run.result.status,
              .code = exit_code(run),
              .why = explain(run),
              .path = paths_ && run.has_path() ? path : std::vector<Point>()};
    told.line = json_line(std::move(run));
    return told;
  }

  void add(Told&& told) {
    delivery_.print(told.line);
    bar_->update(++done_, "queries");
    if (json_) lines_ += told.line;
    rows_ += told.row;
    ++answers_[told.status];
    if (!told.path.empty()) kept_.push_back(std::move(told.path));
    if (code_ == kFound) return;
    code_ = told.code;
    why_ = std::move(told.why);
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
  Delivery& delivery_;
  std::optional<ProgressLine> bar_;
  std::int64_t done_ = 0;
  std::map<Status, std::int64_t> answers_;  ///< how many, by their status
  int code_ = kNoPath;
  std::string why_;
  bool json_ = false, csv_ = false, paths_ = false;
  std::string lines_, rows_;
  Batch::Paths kept_;
};

/// A batch whose chunks a crew shares. They do not depend on the ranks, so that others may go on.
class SharedBatch {
 public:
  SharedBatch(Crew& crew, const Batch& batch, const BatchOptions& how, BatchOutput& output)
      : crew_(crew),
        batch_(batch),
        how_(how),
        output_(output),
        seeds_(static_cast<std::size_t>(how.seeds)) {
    const auto root = std::sqrt(static_cast<double>(batch.queries * seeds_));
    const auto answers = std::clamp<std::size_t>(static_cast<std::size_t>(root / 4), 1, 1024);
    chunk_ = std::max<std::size_t>(answers / seeds_, 1);
    seeds_at_once_ = std::min(answers, seeds_);
    pieces_ = (seeds_ + seeds_at_once_ - 1) / seeds_at_once_;
  }

  /// False where it was stopped before all is done.
  bool run() {
    Crew::Work work{.key = shared_key(batch_.options, std::to_string(batch_.queries) + "\n" +
                                                          std::to_string(chunk_) + " " +
                                                          std::to_string(seeds_at_once_)),
                    .stop = how_.token};
    if (crew_.leads()) {
      ready_ =
          std::move(journal_.emplace("lasius-batch-" + work.key + ".journal", work.key).kept());
      const auto chunks = static_cast<int>((batch_.queries + chunk_ - 1) / chunk_ * pieces_);
      for (int i = 0; i < chunks; ++i)
        if (!ready_.contains(i)) work.items.push_back(i);
      give_on();
    }
    work.act = [this](std::span<const int> chunks) {
      std::vector<std::string> texts;
      for (const int chunk : chunks) texts.push_back(answered(static_cast<std::size_t>(chunk)));
      return texts;
    };
    work.receive = [this](int chunk, std::string text) {
      journal_->add(chunk, text);
      ready_.emplace(chunk, std::move(text));
      give_on();
    };
    const bool whole = crew_.share(work).has_value();
    leave_to_leader();
    return whole;
  }

  void end() { journal_->remove(); }

 private:
  /// A line an answer; nothing where it was stopped.
  std::string answered(std::size_t chunk) const {
    std::string text;
    const std::size_t first = chunk / pieces_ * chunk_, seed = chunk % pieces_ * seeds_at_once_;
    BatchOptions how = how_;
    how.seeds = static_cast<int>(std::min(seeds_at_once_, seeds_ - seed));
    batch_.answer({.first = first,
                   .count = std::min(chunk_, batch_.queries - first),
                   .seed = batch_.options.seed + seed},
                  how, [&](Record&& run, const auto&... shown) {
                    text += text_of(output_.told(std::move(run), shown...));
                  });
    return how_.token.stop_requested() ? std::string() : text;
  }

  /// Prints the chunks whose turn it is.
  void give_on() {
    for (auto first = ready_.begin(); first != ready_.end() && first->first == next_; ++next_) {
      std::istringstream lines(first->second);
      for (std::string line; std::getline(lines, line);) output_.add(told_of(line));
      first = ready_.erase(first);
    }
  }

  Crew& crew_;
  const Batch& batch_;
  const BatchOptions& how_;
  BatchOutput& output_;
  std::size_t seeds_;          ///< of each query
  std::size_t chunk_;          ///< queries, of which a chunk has all seeds but where it is of one:
  std::size_t seeds_at_once_;  ///< then it may have so many, and the query
  std::size_t pieces_;         ///< such chunks
  std::optional<Journal> journal_;
  std::map<int, std::string> ready_;
  int next_ = 0;
};

}  // namespace

std::string shared_key(const SearchOptions& options, const std::string& more) {
  std::string called = options.called;
  if (const auto at = called.find(" --threads"); at != called.npos) {
    const auto value = called.find_first_not_of(" =", at + std::string_view(" --threads").size());
    called.erase(at, std::min(called.find(' ', value), called.size()) - at);
  }
  std::uint64_t hash = bytes_hash(called + "\n" + more + "\n" + LASIUS_VERSION);
  for (const std::string& file : options.inputs) {
    std::error_code none;
    if (!file.empty() && !std::filesystem::is_regular_file(file, none))
      throw Error(ErrorCode::file_unsupported, {.file = file},
                  "is no regular file, and each rank has to read it",
                  "write it to one, or use lasius");
    hash = file_hash(file, hash);
  }
  return hash_text(hash);
}

int run_batch(const Batch& batch, const SignalWatcher& signals, Delivery& delivery) {
  const SearchOptions& options = batch.options;
  if (!options.messages.quiet)
    for (const auto& note : options.notes) message(note);
  BatchOptions how{.threads = options.threads, .token = signals.token(), .seeds = options.seeds};
  if (options.time_limit) how.time_limit = std::chrono::duration<double>(*options.time_limit);
  BatchOutput output(batch, delivery);
  std::optional<SharedBatch> shared;
  bool whole = true;
  if (crew() != nullptr)
    whole = shared.emplace(*crew(), batch, how, output).run();
  else
    batch.answer({.count = batch.queries, .seed = options.seed}, how,
                 [&](Record&& run, const auto&... shown) {
                   output.add(output.told(std::move(run), shown...));
                 });
  output.write_files();
  const bool interrupted = signals.interrupted() || !whole;
  if (shared && !interrupted) shared->end();
  return output.finish(interrupted);
}

}  // namespace lasius::tool
