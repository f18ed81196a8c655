#include "core/disc/space_builder.h"

#include <algorithm>
#include <bit>
#include <functional>

#include "core/disc/grown_rows.h"
#include "core/grid/changed_parts.h"

namespace lasius::disc {

namespace {

Words words_of(const Rectangle& cells) noexcept {
  return {cells.y, cells.y + cells.height, cells.x >> 6, ((cells.x + cells.width - 1) >> 6) + 1};
}

// The columns of a rectangle in a word.
std::uint64_t columns_in(const Rectangle& cells, int word) noexcept {
  const int from = std::max(cells.x - 64 * word, 0);
  const int to = std::min(cells.x + cells.width - 64 * word, 64);
  if (from >= to) return 0;
  return ~std::uint64_t{0} << from & ~std::uint64_t{0} >> (64 - to);
}

}  // namespace

SpaceBuilder::SpaceBuilder(DiscSpace& space)
    : SpaceBuilder(space, {0, 0, space.map_.width(), space.map_.height()}, {},
                   {0, 0, space.map_.width(), space.map_.height()}) {}

SpaceBuilder::SpaceBuilder(DiscSpace& space, const Rectangle& changed)
    : SpaceBuilder(space, widened(changed, space.wall_, space.map_),
                   widened(changed, 2 * space.wall_, space.map_),
                   widened(changed, 3 * space.wall_, space.map_)) {
  joined_anew_.resize(cells_.corners().corners().size());
}

SpaceBuilder::SpaceBuilder(DiscSpace& space, const Rectangle& core, const Rectangle& window,
                           const Rectangle& corners)
    : space_(space),
      core_(core),
      window_(window),
      words_(words_of(core)),
      cells_(space, words_of(corners)),
      bits_(static_cast<std::size_t>(core.height) *
            static_cast<std::size_t>(words_.last - words_.first)) {}

bool SpaceBuilder::run(Poller& poller) {
  if (!look_at_core(poller)) return false;
  if (window_.width > 0) look_around();
  if (joined_anew_.empty()) {
    space_.arcs_.reserve(cells_.corners().corners().size());
    space_.cells_.reserve(cells_.size());
  }
  std::ranges::sort(spare_, std::greater());
  spare_.erase(std::unique(spare_.begin(), spare_.end()), spare_.end());
  cells_.join(joined_anew_, spare_, poller);
  if (poller.stopped() || !write_core(poller) || !write_planes(poller)) return false;
  write_around();
  close_gaps();
  return !poller.stop_after(static_cast<std::int64_t>(cells_.pieces().size()));
}

// Visits the core's words, those of eight rows one below the other.
template <class Visit>
void SpaceBuilder::for_each_word(const Visit& visit) const {
  for (int y0 = words_.top & ~7; y0 < words_.bottom; y0 += 8) {
    for (int word = words_.first; word < words_.last; ++word) {
      for (int y = std::max(y0, words_.top); y < std::min(y0 + 8, words_.bottom); ++y)
        visit(word, y);
    }
  }
}

BandCells::Bits& SpaceBuilder::bits_at(int word, int y) noexcept {
  return bits_[static_cast<std::size_t>(y - words_.top) *
                   static_cast<std::size_t>(words_.last - words_.first) +
               static_cast<std::size_t>(word - words_.first)];
}

bool SpaceBuilder::look_at_core(Poller& poller) {
  GrownRows grown(space_.map_, Reach(space_.radius_), words_);
  if (!grown.grow(poller)) return false;
  for_each_word([&](int word, int y) {
    if (poller.stopped()) return;
    const std::uint64_t cells = columns_in(core_, word);
    for (std::uint64_t left = space_.band_.row(y)[word] & cells; left != 0; left &= left - 1)
      note_old_arcs(64 * word + std::countr_zero(left), y, true);
    BandCells::Bits& bits = bits_at(word, y) = cells_.add_word(grown, word, y, cells);
    poller.stop_after(std::int64_t{4} * (1 + count_bits(bits.band)));
  });
  if (!joined_anew_.empty()) {
    for (const BandCells::Piece& piece : cells_.pieces()) joined_anew_[piece.corner] = 1;
  }
  return !poller.stopped();
}

// Drops the arcs that pass a cell, all or those joined anew; false if there are none.
bool SpaceBuilder::note_old_arcs(int x, int y, bool all) {
  bool any = false;
  for (const std::uint32_t number : space_.arcs_at(x, y)) {
    const Arc& arc = space_.arcs_[number];
    if (cells_.corners().corner(arc.x, arc.y)) {
      char& anew = joined_anew_[cells_.corners().number(arc.x, arc.y)];
      if (all) anew = 1;
      if (anew == 0) continue;
    }
    spare_.push_back(number);
    any = true;
  }
  return any;
}

// Cells there stay as they are, but for the numbers of such arcs.
void SpaceBuilder::look_around() {
  const Words words = words_of(window_);
  for (int y = words.top; y < words.bottom; ++y) {
    const bool beside = y >= core_.y && y < core_.y + core_.height;
    for (int word = words.first; word < words.last; ++word) {
      std::uint64_t left =
          columns_in(window_, word) & ~(beside ? columns_in(core_, word) : 0) &
          (space_.arc_cells_even_.row(y)[word] | space_.arc_cells_odd_.row(y)[word]);
      for (; left != 0; left &= left - 1) {
        const int x = 64 * word + std::countr_zero(left);
        if (!note_old_arcs(x, y, false)) continue;
        cells_.add(x, y);
        around_.push_back({x, y});
      }
    }
  }
}

bool SpaceBuilder::write_core(Poller& poller) {
  std::vector<std::uint32_t> block;
  std::size_t next = 0;  // of the cells looked at
  for_each_word([&](int word, int y) {
    if (poller.stopped()) return;
    const std::uint64_t core = columns_in(core_, word);
    const std::uint64_t was = space_.band_in(word, y);
    const std::uint64_t is = (was & ~core) | bits_at(word, y).band;
    std::uint32_t& start = space_.starts_[space_.block(word, y)];
    block.clear();
    std::uint32_t old = start;
    for (std::uint64_t left = was | is; left != 0; left &= left - 1) {
      const std::uint64_t here = left & (0 - left);
      if ((here & core & is) != 0) block.push_back(cells_.kept(next++));
      if ((here & was) == 0) continue;
      const std::uint32_t cell = space_.cells_[old++];
      if ((here & core) == 0)
        block.push_back(cell);
      else if (cell > DiscSpace::kSeveral)
        space_.waste_ += 1 + space_.passing_[cell - DiscSpace::kSeveral];
    }
    const std::size_t held = old - start;
    if (block.size() > held) {
      start = static_cast<std::uint32_t>(space_.cells_.size());
      space_.cells_.resize(space_.cells_.size() + block.size());
      space_.waste_ += held;
    } else {
      space_.waste_ += held - block.size();
    }
    std::ranges::copy(block, space_.cells_.begin() + start);
    poller.stop_after(1 + std::ssize(block));
  });
  return !poller.stopped();
}

bool SpaceBuilder::write_planes(Poller& poller) {
  int left = Grid::kMaxSide, right = -1, top = 0, bottom = -1;  // of what became blocked or free
  std::vector<std::uint64_t> row(static_cast<std::size_t>(space_.map_.words()));
  const auto write = [&](Grid& plane, int y, std::uint64_t BandCells::Bits::*bits) {
    std::copy_n(plane.row(y), row.size(), row.begin());
    for (int word = words_.first; word < words_.last; ++word) {
      const std::uint64_t core = columns_in(core_, word);
      row[word] = (row[word] & ~core) | bits_at(word, y).*bits;
    }
    plane.set_row(y, row.data());
  };
  for (int y = words_.top; y < words_.bottom; ++y) {
    for (int word = words_.first; word < words_.last; ++word) {
      const std::uint64_t other =
          (space_.blocked_.row(y)[word] ^ bits_at(word, y).blocked) & columns_in(core_, word);
      if (other == 0) continue;
      left = std::min(left, 64 * word + std::countr_zero(other));
      right = std::max(right, 64 * word + 63 - std::countl_zero(other));
      if (bottom < 0) top = y;
      bottom = y;
    }
    if (poller.stop_after(std::int64_t{8} * std::ssize(row))) return false;
    write(space_.blocked_, y, &BandCells::Bits::blocked);
    write(space_.band_, y, &BandCells::Bits::band);
    write(space_.arc_cells_even_, y, &BandCells::Bits::even);
    write(space_.arc_cells_odd_, y, &BandCells::Bits::odd);
  }
  if (bottom >= 0) changed_ = {left, top, right - left + 1, bottom - top + 1};
  // Of tiles, whose words are as wide as eight of theirs.
  row.resize(static_cast<std::size_t>(space_.crowded_.words()));
  for (int strip = words_.top >> 3; strip <= (words_.bottom - 1) >> 3; ++strip) {
    std::copy_n(space_.crowded_.row(strip), row.size(), row.begin());
    for (int word = words_.first; word < words_.last; ++word) {
      std::uint64_t any = 0;
      for (int y = 8 * strip; y < std::min(8 * strip + 8, space_.map_.height()); ++y)
        any |= space_.blocked_.row(y)[word] | space_.band_.row(y)[word];
      for (unsigned k = 4; k != 0; k >>= 1) any |= any >> k;  // of each byte its lowest bit
      any = (any & 0x0101010101010101) * 0x0102040810204080 >> 56;
      const int shift = (word & 7) * 8;
      row[word >> 3] = (row[word >> 3] & ~(std::uint64_t{0xff} << shift)) | any << shift;
    }
    space_.crowded_.set_row(strip, row.data());
  }
  return true;
}

void SpaceBuilder::write_around() {
  std::size_t next = cells_.size() - around_.size();
  for (const Cell c : around_) {
    std::uint32_t* arcs = space_.mutable_arcs_at(c.x, c.y);
    for (const BandCells::Piece& piece : cells_.pieces(next++)) {
      if (joined_anew_[piece.corner] != 0) *arcs = piece.arc;
      ++arcs;
    }
  }
}

// The last arcs take the numbers that are left.
void SpaceBuilder::close_gaps() {
  for (const std::uint32_t gap : spare_) {
    const auto last = static_cast<std::uint32_t>(space_.arcs_.size() - 1);
    if (gap != last) move_arc(last, gap);
    space_.arcs_.pop_back();
  }
}

void SpaceBuilder::move_arc(std::uint32_t from, std::uint32_t to) {
  const Arc& arc = space_.arcs_[to] = space_.arcs_[from];
  const Rectangle cells = widened({arc.x, arc.y, 0, 0}, space_.wall_, space_.map_);
  const Grid& passed = space_.arc_cells(arc.type);
  for (int y = cells.y; y < cells.y + cells.height; ++y) {
    for (int word = cells.x >> 6; word <= (cells.x + cells.width - 1) >> 6; ++word) {
      for (std::uint64_t left = passed.row(y)[word] & columns_in(cells, word); left != 0;
           left &= left - 1) {
        const int x = 64 * word + std::countr_zero(left);
        std::uint32_t* arcs = space_.mutable_arcs_at(x, y);
        std::replace(arcs, arcs + space_.arcs_at(x, y).size(), from, to);
      }
    }
  }
}

}  // namespace lasius::disc
