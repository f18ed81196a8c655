// The words of Dubins and of Reeds & Shepp: ways of arcs and lines between two poses.
#pragma once

#include <array>
#include <vector>

#include "lasius/vehicle/motion.h"

namespace lasius::vehicle {

/// At most five pieces on circles of radius 1.
struct Word {
  std::array<double, 5> length{};     ///< less than 0: backwards
  std::array<signed char, 5> turn{};  ///< 1: yaw grows forwards, -1: it shrinks, 0: straight
  int count = 0;                      ///< of pieces
  double cost = 0;                    ///< by the prices that were asked for, of radius 1
};

/// What is paid for words, of radius 1.
struct WordPrices {
  double backwards = 1;  ///< of each length
  double cusp = 0;       ///< of each change of gear
};

/// A place as seen from the begin, of radius 1.
struct Place {
  double x = 0, y = 0, yaw = 0;
};
Place seen_from(const Pose& from, const Pose& to, double radius) noexcept;

/// At most 6 of Dubins, 48 of Reeds & Shepp.
class Words {
 public:
  void dubins(const Place& to) noexcept;
  void reeds_shepp(const Place& to, const WordPrices& prices) noexcept;
  /// Dubins' or, where it may reverse, Reeds & Shepp's without prices.
  void unpriced(const Place& to, bool reverse) noexcept;
  /// The first `most` in order of cost.
  void sort(int most) noexcept;
  int size() const noexcept { return size_; }
  const Word& operator[](int i) const noexcept { return words_[order_[i]]; }
  /// The least cost.
  double least() const noexcept { return least_; }

 private:
  friend class WordMaker;
  void clear() noexcept;
  void add(const Word& word) noexcept;

  int size_ = 0;
  double least_ = 0;
  std::array<Word, 48> words_;
  std::array<int, 48> order_{};
};

/// The motions of a word from a pose; pieces shorter than 1e-9 cells are left out.
void append(const Word& word, const Pose& from, double radius, std::vector<Segment>& to);
/// True if the word ends where it should, within 1e-9.
bool ends_at(const Word& word, const Place& to) noexcept;

/// Dubins' words driven in one gear: backwards they are those between both poses turned round.
class GearWords {
 public:
  /// Looks for the shortest. Its length, cells.
  double aim(const Pose& from, const Pose& to, double radius, int gear) noexcept;
  /// Its motions in place of what is there; false where its end is off by more than 1e-9 radii.
  bool motions(std::vector<Segment>& to);

 private:
  Words words_;
  Pose from_;
  Place place_;
  double radius_ = 1;
  int gear_ = 1;
};

}  // namespace lasius::vehicle
