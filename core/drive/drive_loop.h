// The loop of all drives, whatever drives.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/drive/headway.h"
#include "core/drive/sensor.h"
#include "core/drive/world.h"
#include "lasius/drive/drive.h"

namespace lasius {

/// A robot under way. See drive() for its rules; its own is how it stands and moves.
class DriveLoop {
 public:
  /// `map` is what the pilot knows now. `may_circle`: what it knows may be forgotten again and
  /// again, so that it is to end where it enters no new cell for long.
  DriveLoop(const Grid& map, const Grid& truth, Cell start, Pilot& pilot, const Changes& changes,
            const DriveOptions& options, bool may_circle);
  virtual ~DriveLoop() = default;
  DriveLoop(const DriveLoop&) = delete;
  DriveLoop& operator=(const DriveLoop&) = delete;

  DriveResult run();

 protected:
  enum class Found { way, none, not_yet };

  /// Whether it holds one of some cells: where it stands, and went in its last move.
  virtual bool holds(const Rectangle& part) const = 0;
  virtual bool covers(Cell cell) const = 0;  ///< where it stands
  virtual double reach() const = 0;          ///< see Body
  /// A start or goal that is blocked or outside ends the drive before it begins: true, and ended.
  virtual bool blocked_at_start() = 0;
  virtual bool at_goal() const = 0;          ///< whatever the pilot says
  virtual bool at_end_of_way() const = 0;    ///< there it has arrived
  virtual bool goes() const noexcept = 0;    ///< there is a way, and a move on it
  virtual bool proven() const noexcept = 0;  ///< that no way leads to the goal, on what is known
  /// Whether a way leads to the goal in truth.
  virtual bool joined(World::Without without) = 0;
  virtual void give_up() = 0;   ///< no way is left: ends
  virtual void follow() = 0;    ///< one move on the way, or stands where that is barred
  virtual void stand() = 0;     ///< waits
  virtual void set_out() = 0;   ///< chooses where to go aside
  virtual void go_aside() = 0;  ///< one move there, or stands
  virtual void settle() = 0;    ///< there is a way again: it goes aside no longer

  void end(Status status, std::string error = {});
  void look();
  void learn(const std::vector<Cell>& cells, bool blocked);
  void ask();  ///< one question to the pilot, within the tick's time
  /// Is at a cell at the end of the tick.
  void arrive(Cell cell, bool moved, double length, double cost);

  const Grid& map_;
  const DriveOptions& options_;
  World world_;
  Pilot& pilot_;
  Cell robot_;
  std::int64_t tick_ = 0;
  const Way* way_ = nullptr;
  bool ended_ = false;
  DriveResult result_;

 private:
  using Milliseconds = std::chrono::duration<double, std::milli>;

  void tick();
  void tell(const std::vector<Cell>& cells, bool blocked);
  Found find_way();
  bool hopeless();
  bool doubt();
  std::optional<Grid> certain_walls() const;
  bool forget_walls(const Grid* kept);
  void move(Found found);
  void end_trapped(const char* why);
  bool trapped();
  bool show(Found found);

  static constexpr int kPatience = 16;  // ticks without a way, then the robot moves aside
  static constexpr int kAttempts = 64;  // to move aside for what waits for the robot
  static constexpr int kDoubts = 64;    // of what was learned, then of the whole map

  const bool may_circle_;
  News seen_;
  std::vector<Cell> news_;
  bool replanned_ = false, arrived_ = false;
  Headway headway_{map_.width(), map_.height()};
  Milliseconds planning_{};
  int waited_ = 0, attempts_ = 0, doubts_ = 0;
  std::int64_t doubted_at_ = 0;  // tick
};

}  // namespace lasius
