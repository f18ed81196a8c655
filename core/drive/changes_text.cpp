#include <algorithm>
#include <array>
#include <limits>
#include <sstream>
#include <utility>

#include "core/base/did_you_mean.h"
#include "core/base/invalid_parameter.h"
#include "core/base/number_text.h"
#include "core/base/text_lines.h"
#include "core/drive/changes_check.h"
#include "core/map_files/byte_reader.h"
#include "core/params/parameter_table.h"
#include "core/plan/answer.h"
#include "lasius/base/error.h"

namespace lasius {
namespace {

std::optional<std::string> fault_of(std::int64_t tick, const Rectangle& part, int width,
                                    int height) {
  if (tick < 0) return "tick " + std::to_string(tick) + " is negative";
  if (part.width < 1 || part.height < 1)
    return size_text(part.width, part.height) + " cells are none";
  if (part.x < 0 || part.y < 0 || part.width > width - part.x || part.height > height - part.y)
    return "the " + size_text(part.width, part.height) + " cells from " +
           cell_name({part.x, part.y}) + " on are not all inside the map of " +
           size_text(width, height) + " cells";
  return std::nullopt;
}

constexpr const char* kForms =
    "write TICK X Y [W H] blocked|free, or TICK move W H SPEED X Y [X Y]...";

/// One line of a file of changes, word by word.
class Line {
 public:
  Line(std::string_view text, std::string file, std::int64_t number)
      : file_(std::move(file)),
        number_(number),
        words_(words_of(text.substr(0, text.find('#')), " \t,")) {}

  std::size_t size() const noexcept { return words_.size(); }
  std::string_view word(std::size_t i) const noexcept { return words_[i]; }

  template <class Number>
  Number number(std::size_t i, const char* what) const {
    if (const auto number = number_of<Number>(words_[i])) return *number;
    fail(std::string(what) + " \"" + std::string(words_[i]) + "\" is not a number that fits",
         kForms);
  }
  Cell cell(std::size_t i) const { return {number<int>(i, "x"), number<int>(i + 1, "y")}; }

  bool blocked() const {
    static constexpr std::array<std::string_view, 2> kStates{"blocked", "free"};
    const std::string_view word = words_.back();
    if (std::ranges::find(kStates, word) == kStates.end())
      fail("\"" + std::string(word) + "\" is neither blocked nor free",
           did_you_mean(word, kStates));
    return word == "blocked";
  }

  [[noreturn]] void fail(std::string problem, std::string remedy) const {
    throw Error(ErrorCode::file_broken, {.file = file_, .line = number_}, std::move(problem),
                std::move(remedy));
  }
  void check(const std::optional<std::string>& fault) const {
    if (fault) fail(*fault, "ticks are 0 or more, cells count from 0 at the top left");
  }

 private:
  std::string file_;
  std::int64_t number_;
  std::vector<std::string_view> words_;
};

MovingObstacle moving_obstacle(const Line& line) {
  if (line.size() < 7 || line.size() % 2 == 0)
    line.fail("a moving obstacle has a size, a speed and a track of cells", kForms);
  MovingObstacle obstacle{.tick = line.number<std::int64_t>(0, "tick"),
                          .width = line.number<int>(2, "width"),
                          .height = line.number<int>(3, "height"),
                          .speed = line.number<double>(4, "speed"),
                          .track = {}};
  for (std::size_t i = 5; i < line.size(); i += 2) obstacle.track.push_back(line.cell(i));
  return obstacle;
}

Change change(const Line& line) {
  if (line.size() != 4 && line.size() != 6)
    line.fail("a change has 4 or 6 words, this line " + std::to_string(line.size()), kForms);
  const Cell corner = line.cell(1);
  Change change{.tick = line.number<std::int64_t>(0, "tick"), .part = {corner.x, corner.y, 1, 1}};
  if (line.size() == 6) {
    change.part.width = line.number<int>(3, "width");
    change.part.height = line.number<int>(4, "height");
  }
  change.blocked = line.blocked();
  return change;
}

}  // namespace

std::optional<std::string> fault_of(const Change& change, int width, int height) {
  return fault_of(change.tick, change.part, width, height);
}

std::optional<std::string> fault_of(const MovingObstacle& obstacle, int width, int height) {
  if (!(obstacle.speed >= 0 && obstacle.speed <= 64))
    return "speed " + number_text(obstacle.speed) + " is not 0 .. 64 cells a tick";
  if (obstacle.track.empty()) return "a moving obstacle without a track";
  for (const Cell at : obstacle.track) {
    const Rectangle part{at.x, at.y, obstacle.width, obstacle.height};
    if (auto fault = fault_of(obstacle.tick, part, width, height)) return fault;
  }
  return std::nullopt;
}

void check_drive(const Grid& map, const Grid& truth, const DriveOptions& options) {
  if (map.width() != truth.width() || map.height() != truth.height())
    refuse("the world is " + size_text(truth.width(), truth.height()) + " cells, the map " +
               size_text(map.width(), map.height()),
           "give both for the same place, in cells of the same size");
  require_parameter(options.sense >= 1, "sense", options.sense, "it must be at least 1 cell");
  const double tick = options.seconds_per_tick;
  require_parameter(tick >= std::numeric_limits<double>::min(), "seconds_per_tick", tick,
                    "it must be above 0");
  require_parameter(options.max_ticks >= 0, "max_ticks", options.max_ticks, "it must be 0 or more");
  check_seed(options.seed);
}

void check_changes(const Changes& changes, int width, int height) {
  const auto check = [&](const auto& all, const char* what) {
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (const auto fault = fault_of(all[i], width, height))
        refuse(what + std::to_string(i) + ": " + *fault, "correct it, or leave it out");
    }
  };
  check(changes.cells, "change ");
  check(changes.obstacles, "moving obstacle ");
}

Changes read_changes(std::string_view text, const std::string& name, int width, int height) {
  std::string lines(text);
  end_lines_in_lf(lines);
  std::istringstream in(lines);
  Changes changes;
  std::int64_t number = 0;
  for (std::string read; std::getline(in, read);) {
    if (read.ends_with('\r')) read.pop_back();
    const Line line(read, name, ++number);
    if (line.size() == 0) continue;
    if (line.size() > 1 && line.word(1) == "move") {
      changes.obstacles.push_back(moving_obstacle(line));
      line.check(fault_of(changes.obstacles.back(), width, height));
    } else {
      changes.cells.push_back(change(line));
      line.check(fault_of(changes.cells.back(), width, height));
    }
  }
  return changes;
}

Changes read_changes_file(const std::string& path, int width, int height) {
  constexpr std::int64_t kMostBytes = std::int64_t{1} << 30;
  return read_changes(read_text(path, kMostBytes, Empty::taken), path, width, height);
}

}  // namespace lasius
