// How the free space of a disc is made, and made anew around what changes.
#pragma once

#include <cstdint>
#include <vector>

#include "core/base/poller.h"
#include "core/disc/band_cells.h"
#include "core/disc/disc_space.h"

namespace lasius::disc {

/// Makes all of a space but how its cells are joined.
///
/// Where some cells of the map change, only cells within `wall_` steps of them, the core, may
/// become others. All arcs are joined anew of corners of which some pass the core, before or after;
/// these end within `wall_` steps around it.
class SpaceBuilder {
 public:
  explicit SpaceBuilder(DiscSpace& space);
  /// Around cells that the space knows as they were, though its map has them as they are.
  SpaceBuilder(DiscSpace& space, const Rectangle& changed);
  /// False if stopped.
  bool run(Poller& poller);
  /// Around the cells that became blocked in the space, or ceased to be; empty where none did.
  const Rectangle& changed_blocked() const noexcept { return changed_; }

 private:
  SpaceBuilder(DiscSpace& space, const Rectangle& core, const Rectangle& window,
               const Rectangle& corners);

  bool look_at_core(Poller& poller);
  void look_around();
  bool note_old_arcs(int x, int y, bool all);
  bool write_core(Poller& poller);  // false when stopped; so the next
  bool write_planes(Poller& poller);
  void write_around();
  void close_gaps();
  void move_arc(std::uint32_t from, std::uint32_t to);

  BandCells::Bits& bits_at(int word, int y) noexcept;
  template <class Visit>
  void for_each_word(const Visit& visit) const;

  DiscSpace& space_;
  const Rectangle core_, window_;
  const Words words_;  // of the core
  BandCells cells_;
  std::vector<BandCells::Bits> bits_;  // of those words
  std::vector<char> joined_anew_;      // corners whose arcs are; empty: all
  std::vector<std::uint32_t> spare_;   // numbers of arcs that are no more
  std::vector<Cell> around_;           // cells past the core that arcs joined anew pass
  Rectangle changed_;
};

}  // namespace lasius::disc
