#include "core/grid/components_block.h"

#include <algorithm>
#include <numeric>

#include "lasius/grid/grid.h"

namespace lasius {

// A block with sides to list is at most half a map wide. At most every second cell around it begins
// a piece, and a side's contacts are at most its cells and the corners on it; all pieces of a
// map's four halves have numbers of 16 bits.
static_assert(2 * (Grid::kMaxSide / 2) - 2 < Side::kNone);
static_assert(4 * (Grid::kMaxSide / 2) <= 1 << 16);

void Side::add(Piece piece, int contacts) {
  const bool counted = !codes_.empty() && codes_.back() > kNone;
  const std::size_t last = codes_.size() - (counted ? 2 : 1);
  if (!codes_.empty() && codes_[last] == piece) {
    if (!counted) codes_.push_back(kNone + 1);
    codes_.back() = static_cast<std::uint16_t>(codes_.back() + contacts);
    return;
  }
  codes_.push_back(piece);
  if (contacts > 1) codes_.push_back(static_cast<std::uint16_t>(kNone + contacts));
}

void Outline::clear() noexcept {
  for (Side& side : sides) side.clear();
  corners.fill(Side::kNone);
  open = 0;
}

std::uint32_t BlockJoin::find(std::uint32_t i) noexcept {
  while (parents_[i] != i) {
    parents_[i] = parents_[parents_[i]];
    i = parents_[i];
  }
  return i;
}

void BlockJoin::unite(int part_a, Piece a, int part_b, Piece b) noexcept {
  if (a == Side::kNone || b == Side::kNone) return;
  const std::uint32_t root_a = find(first_[part_a] + a);
  const std::uint32_t root_b = find(first_[part_b] + b);
  parents_[std::max(root_a, root_b)] = std::min(root_a, root_b);
}

void BlockJoin::unite_sides(const Parts& parts, int a, int side_a, int b, int side_b) noexcept {
  Side::Reader one(parts[a]->sides[side_a]);
  Side::Reader two(parts[b]->sides[side_b]);
  while (!one.done() && !two.done()) {
    unite(a, one.piece(), b, two.piece());
    const int both = std::min(one.contacts(), two.contacts());
    one.skip(both);
    two.skip(both);
  }
}

// The block's number of a part's piece, the next one if it has none yet.
Piece BlockJoin::number(int part, Piece piece) noexcept {
  if (piece == Side::kNone) return piece;
  const std::uint32_t root = find(first_[part] + piece);
  if (up_[root] == kUnknown) up_[root] = pieces_++;
  return static_cast<Piece>(up_[root]);
}

// A side of the block: one of part a's, then one of part b's; between them, with 8 neighbours, a
// contact for steps across the point that they share, of a piece of either: those are joined.
void BlockJoin::add_side(const Parts& parts, int side, int a, int b, bool eight) {
  Side& out = outline_.sides[side];
  const auto add = [&](int part) {
    for (Side::Reader in(parts[part]->sides[side]); !in.done(); in.skip(in.contacts()))
      out.add(number(part, in.piece()), in.contacts());
  };
  add(a);
  if (eight) {
    const Piece shared = number(a, parts[a]->corners[b]);
    out.add(shared != Side::kNone ? shared : number(b, parts[b]->corners[a]), 1);
  }
  add(b);
}

void BlockJoin::join(const Parts& parts, bool eight) {
  using enum Outline::Direction;
  using enum Outline::Corner;
  for (int i = 0; i < 4; ++i) first_[i + 1] = first_[i] + parts[i]->open;
  parents_.resize(first_[4]);
  std::iota(parents_.begin(), parents_.end(), 0u);
  up_.assign(first_[4], kUnknown);
  pieces_ = 0;
  outline_.clear();
  unite_sides(parts, north_west, east, north_east, west);
  unite_sides(parts, south_west, east, south_east, west);
  unite_sides(parts, north_west, south, south_west, north);
  unite_sides(parts, north_east, south, south_east, north);
  for (const int i : {0, 1}) {  // across the middle
    unite(i, parts[i]->corners[3 - i], 3 - i, parts[3 - i]->corners[i]);
  }
  add_side(parts, north, north_west, north_east, eight);
  add_side(parts, east, north_east, south_east, eight);
  add_side(parts, south, south_west, south_east, eight);
  add_side(parts, west, north_west, south_west, eight);
  for (int i = 0; i < 4; ++i) outline_.corners[i] = number(i, parts[i]->corners[i]);
  outline_.open = pieces_;
  for (std::uint32_t i = 0; i < first_[4]; ++i) {  // roots come first
    const std::uint32_t root = find(i);
    if (up_[root] == kUnknown) up_[root] = pieces_++;
    up_[i] = up_[root];
  }
}

}  // namespace lasius
