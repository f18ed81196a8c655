#include "core/grid/components_tile.h"

#include <algorithm>

namespace lasius {
namespace {

constexpr int kSide = TileBox::kSide;
constexpr int kWords = TileBox::kWords;
constexpr int kMostRuns = kSide / 2 * kSide;
using Row = std::array<std::uint64_t, kWords>;

constexpr std::uint16_t kNone = 0xffff;

bool bit(const Row& row, int x) noexcept { return (row[x >> 6] >> (x & 63) & 1) != 0; }

// Free cells of a column of a tile, or of one beside it.
Row free_column(const Grid& grid, const TileBox& box, int column) noexcept {
  const int x = box.x + column;
  Row free{};
  for (int y = 0; y < box.height; ++y)
    free[y >> 6] |= (~grid.row(box.y + y)[x >> 6] >> (x & 63) & 1) << (y & 63);
  return free;
}

// Calls visit(i) for each contact of two lines of free cells that face each other. With 4
// neighbours, cell i begins a run of cells that are free in both lines. With 8, both lines have a
// free one of the cells i and i + 1, and one of the lines has another run than before.
template <typename Visit>
void for_each_contact(const Row& own, const Row& facing, bool eight, const Visit& visit) {
  const auto with_next = [](const Row& row, int i) {
    return row[i] | row[i] >> 1 | (i == kWords - 1 ? 0 : row[i + 1] << 63);
  };
  std::uint64_t before = 0;
  for (int i = 0; i < kWords; ++i) {
    const std::uint64_t both = own[i] & facing[i];
    std::uint64_t contacts = both & ~(both << 1 | before);
    if (eight) contacts = with_next(own, i) & with_next(facing, i) & ~(i == 0 ? both & ~1u : both);
    before = both >> 63;
    for (; contacts != 0; contacts &= contacts - 1) visit(i * 64 + std::countr_zero(contacts));
  }
}

// The run of free cells around column x.
struct Run {
  int lo;
  int hi;
};
Run run_around(const Row& free, int x) noexcept {
  int word = x >> 6;
  std::uint64_t blocked = ~free[word] & (~std::uint64_t{0} >> (63 - (x & 63)));
  while (blocked == 0 && word > 0) blocked = ~free[--word];
  const int lo = blocked == 0 ? 0 : word * 64 + 64 - std::countl_zero(blocked);
  word = x >> 6;
  blocked = ~free[word] & (~std::uint64_t{0} << (x & 63));
  while (blocked == 0 && word < kWords - 1) blocked = ~free[++word];
  return {lo, word * 64 + std::countr_zero(blocked) - 1};
}

void set_run(Row& row, Run run) noexcept {
  for (int i = run.lo >> 6; i <= run.hi >> 6; ++i) {
    const int lo = std::max(run.lo - i * 64, 0);
    const int hi = std::min(run.hi - i * 64, 63);
    row[i] |= (~std::uint64_t{0} >> (63 - (hi - lo))) << lo;
  }
}

// The next row to look at: on in the same direction, else in the other one; -1 if there is none.
int next_row(const Row& rows, int at, bool& down) noexcept {
  for (int turn = 0; turn < 2; ++turn, down = !down) {
    int word = at >> 6;
    std::uint64_t bits = rows[word] & (down ? ~std::uint64_t{0} << (at & 63)
                                            : ~std::uint64_t{0} >> (63 - (at & 63)));
    while (bits == 0 && (down ? ++word < kWords : --word >= 0)) bits = rows[word];
    if (bits != 0) return word * 64 + (down ? std::countr_zero(bits) : 63 - std::countl_zero(bits));
  }
  return -1;
}

class Flood {
 public:
  Flood(const Grid& grid, const TileBox& box, bool eight, Cell other) noexcept
      : grid_(grid), box_(box), eight_(eight), other_{other.x - box.x, other.y - box.y} {}

  FloodEnd run(Cell from) noexcept {
    int row = from.y - box_.y;
    Row free = box_.free_row(grid_, row);
    if (reach(row, run_around(free, from.x - box_.x))) return end_;
    bool down = true;
    while ((row = next_row(waiting_, row, down)) >= 0) {
      waiting_[row >> 6] &= ~(std::uint64_t{1} << (row & 63));
      free = box_.free_row(grid_, row);
      for (int i = 0; i < kWords; ++i) {
        std::uint64_t seeds;
        while ((seeds = touched(row, i) & free[i] & ~reached_[row + 1][i]) != 0)
          if (reach(row, run_around(free, i * 64 + std::countr_zero(seeds)))) return end_;
      }
    }
    return end_;
  }

 private:
  // Cells of a word that lie beside reached ones of the rows above and below.
  std::uint64_t touched(int row, int i) const noexcept {
    const Row& above = reached_[row];
    const Row& below = reached_[row + 2];
    const std::uint64_t here = above[i] | below[i];
    if (!eight_) return here;
    const std::uint64_t left = i == 0 ? 0 : above[i - 1] | below[i - 1];
    const std::uint64_t right = i == kWords - 1 ? 0 : above[i + 1] | below[i + 1];
    return here | here << 1 | left >> 63 | here >> 1 | right << 63;
  }

  // True when the flood ends with this run.
  bool reach(int row, Run run) noexcept {
    set_run(reached_[row + 1], run);
    if (row == other_.y && run.lo <= other_.x && other_.x <= run.hi) {
      end_.met = FloodEnd::Met::other;
      return true;
    }
    const int column = run.lo == 0 || row == 0 || row == box_.height - 1 ? run.lo : run.hi;
    if (run.lo == 0 || run.hi == box_.width - 1 || row == 0 || row == box_.height - 1) {
      end_ = {FloodEnd::Met::border, box_.border_position(column, row)};
      return true;
    }
    for (const int next : {row - 1, row + 1})
      waiting_[next >> 6] |= std::uint64_t{1} << (next & 63);
    return false;
  }

  const Grid& grid_;
  const TileBox& box_;
  bool eight_;
  Cell other_;
  FloodEnd end_{FloodEnd::Met::nothing, 0};
  Row waiting_{};
  std::array<Row, kSide + 2> reached_{};  // a row of none on either side
};

}  // namespace

TileBox TileBox::at(const Grid& grid, int tile_x, int tile_y) noexcept {
  const int x = tile_x * kSide;
  const int y = tile_y * kSide;
  return {x, y, std::min(kSide, grid.width() - x), std::min(kSide, grid.height() - y)};
}

Row TileBox::free_row(const Grid& grid, int row) const noexcept {
  const std::uint64_t* words = grid.row(y + row) + x / 64;
  Row free{};
  for (int i = 0; i < (width + 63) / 64; ++i) free[i] = ~words[i];
  return free;
}

int TileBox::border_length() const noexcept {
  return width == 1 || height == 1 ? width * height : 2 * (width + height) - 4;
}

int TileBox::border_position(int column, int row) const noexcept {
  if (row == 0) return column;
  if (column == width - 1) return width - 1 + row;
  if (row == height - 1) return width + height - 2 + (width - 1 - column);
  return 2 * width + height - 3 + (height - 1 - row);
}

Border border_of(const Grid& grid, const TileBox& box) noexcept {
  Border border{};
  const auto set = [&border](int position) noexcept {
    border[position >> 6] |= std::uint64_t{1} << (position & 63);
  };
  const Row top = box.free_row(grid, 0);
  std::ranges::copy(top, border.begin());
  const int right = box.width - 1;
  for (int y = 1; y < box.height; ++y) {
    const std::uint64_t* words = grid.row(box.y + y) + box.x / 64;
    if ((~words[right >> 6] >> (right & 63) & 1) != 0) set(box.border_position(right, y));
    if (right > 0 && (~words[0] & 1) != 0) set(box.border_position(0, y));
  }
  if (box.height > 1) {
    const Row bottom = box.free_row(grid, box.height - 1);
    for (int x = 1; x < right; ++x)
      if (bit(bottom, x)) set(box.border_position(x, box.height - 1));
  }
  return border;
}

void outline_tile(const Grid& grid, const TileBox& box, std::span<const std::uint64_t> marks,
                  bool eight, Outline& outline) {
  outline.clear();
  std::array<Piece, 1024> around;
  around.fill(Side::kNone);
  for_each_run(border_of(grid, box), marks.data(), [&](int first, int last, int piece) {
    std::fill(around.begin() + first, around.begin() + last + 1, static_cast<Piece>(piece));
    outline.open = std::max(outline.open, static_cast<std::uint32_t>(piece) + 1);
    return true;
  });
  const int right = box.width - 1;
  const int bottom = box.height - 1;
  const auto add_side = [&](Side& side, const Row& own, const Row& facing, Cell from, int dx,
                            int dy) {
    for_each_contact(own, facing, eight, [&](int i) {
      if (!bit(own, i)) ++i;
      side.add(around[box.border_position(from.x + dx * i, from.y + dy * i)], 1);
    });
  };
  const auto column = [&](int x) { return free_column(grid, box, x); };
  auto& [north, east, south, west] = outline.sides;
  add_side(north, box.free_row(grid, 0), box.free_row(grid, -1), {0, 0}, 1, 0);
  add_side(east, column(right), column(right + 1), {right, 0}, 0, 1);
  add_side(south, box.free_row(grid, bottom), box.free_row(grid, bottom + 1), {0, bottom}, 1, 0);
  add_side(west, column(0), column(-1), {0, 0}, 0, 1);
  if (!eight) return;
  for (const int i : {0, 1, 2, 3}) {
    const Cell c{i % 2 * right, i / 2 * bottom};
    const Cell beyond{box.x + c.x + (i % 2 == 0 ? -1 : 1), box.y + c.y + (i / 2 == 0 ? -1 : 1)};
    if (grid.contains(beyond)) outline.corners[i] = around[box.border_position(c.x, c.y)];
  }
}

TileLabels::TileLabels()
    : runs_(std::make_unique_for_overwrite<Run[]>(kMostRuns)),
      parents_(std::make_unique_for_overwrite<std::uint16_t[]>(kMostRuns)),
      cells_(std::make_unique_for_overwrite<std::uint16_t[]>(kMostRuns)),
      marked_(std::make_unique_for_overwrite<std::uint8_t[]>(kMostRuns)) {}

int TileLabels::find(int run) noexcept {
  while (parents_[run] != run) {
    parents_[run] = parents_[parents_[run]];
    run = parents_[run];
  }
  return run;
}

void TileLabels::add_row(const Grid& grid, const TileBox& box, int row) {
  const Row free = box.free_row(grid, row);
  int starts = run_count_;
  int ends = run_count_;
  for (int i = 0; i < kWords; ++i) {
    const std::uint64_t before = free[i] << 1 | (i == 0 ? 0 : free[i - 1] >> 63);
    const std::uint64_t after = free[i] >> 1 | (i == kWords - 1 ? 0 : free[i + 1] << 63);
    for (std::uint64_t bits = free[i] & ~before; bits != 0; bits &= bits - 1)
      runs_[starts++].lo = static_cast<std::uint8_t>(i * 64 + std::countr_zero(bits));
    for (std::uint64_t bits = free[i] & ~after; bits != 0; bits &= bits - 1)
      runs_[ends++].hi = static_cast<std::uint8_t>(i * 64 + std::countr_zero(bits));
  }
  run_count_ = starts;
}

// Joins the runs of a row with those of the row before it; runs touch when they are `reach` apart.
void TileLabels::unite_row(int row, int reach) noexcept {
  int above = row == 0 ? 0 : first_[row - 1];
  const int above_end = first_[row];
  for (int run = first_[row]; run < run_count_; ++run) {
    const int lo = runs_[run].lo - reach;
    const int hi = runs_[run].hi + reach;
    while (above < above_end && runs_[above].hi < lo) ++above;
    if (above == above_end || runs_[above].lo > hi) {
      parents_[run] = static_cast<std::uint16_t>(run);
      continue;
    }
    int root = find(above);
    while (above + 1 < above_end && runs_[above + 1].lo <= hi) {
      const int other = find(++above);
      parents_[std::max(root, other)] = static_cast<std::uint16_t>(std::min(root, other));
      root = std::min(root, other);
    }
    parents_[run] = static_cast<std::uint16_t>(root);
  }
}

void TileLabels::label(const Grid& grid, const TileBox& box, bool eight) {
  run_count_ = 0;
  for (int row = 0; row < box.height; ++row) {
    first_[row] = run_count_;
    add_row(grid, box, row);
    unite_row(row, eight ? 1 : 0);
  }
  first_[box.height] = run_count_;
  find_main(box.height);
  components_ = 0;
  // Parents come first: one look up makes every run point at its root.
  for (int run = 0, row = 0; run < run_count_; ++run) {
    components_ += parents_[run] == run;
    parents_[run] = parents_[parents_[run]];
    if (parents_[run] == main_run_) continue;
    while (first_[row + 1] <= run) ++row;
    main_.add_other(runs_[run].lo, runs_[run].hi, row);
  }
  mark_border(box);
}

// That of the most cells in some rows, which is the largest as a rule.
void TileLabels::find_main(int rows) noexcept {
  constexpr int kSome = 4;
  const auto for_some = [&](const auto& visit) {
    for (int row = rows / (2 * kSome); row < rows; row += std::max(rows / kSome, 1)) {
      for (int run = first_[row]; run < first_[row + 1]; ++run) visit(run, find(run));
    }
  };
  for_some([&](int, int root) { cells_[root] = 0; });
  main_ = {};
  main_run_ = 0;
  int most = 0;
  for_some([&](int run, int root) {
    cells_[root] += static_cast<std::uint16_t>(runs_[run].hi - runs_[run].lo + 1);
    if (cells_[root] <= most) return;
    most = cells_[root];
    main_run_ = root;
  });
}

void TileLabels::mark_border(const TileBox& box) {
  std::array<std::uint16_t, 1024> roots;
  roots.fill(kNone);
  const auto label_row = [&](int row) {
    for (int run = first_[row]; run < first_[row + 1]; ++run) {
      for (int x = runs_[run].lo; x <= runs_[run].hi; ++x)
        roots[box.border_position(x, row)] = parents_[run];
    }
  };
  label_row(0);
  label_row(box.height - 1);
  for (int row = 1; row + 1 < box.height; ++row) {
    const int first = first_[row];
    const int last = first_[row + 1] - 1;
    if (last < first) continue;
    if (runs_[first].lo == 0) roots[box.border_position(0, row)] = parents_[first];
    if (runs_[last].hi == box.width - 1)
      roots[box.border_position(box.width - 1, row)] = parents_[last];
  }
  std::array<std::uint16_t, 512> runs;
  int count = 0;
  const int length = box.border_length();
  for (int i = 0; i < length; ++i)
    if (roots[i] != kNone && (i == 0 || roots[i - 1] == kNone)) runs[count++] = roots[i];
  marks_.assign((count + 31) / 32, 0);
  const auto mark_new = [&](int i, unsigned mark) {
    if ((marked_[runs[i]] & mark) != 0) return 0;
    marked_[runs[i]] |= static_cast<std::uint8_t>(mark);
    marks_[i / 32] |= std::uint64_t{mark} << (i % 32 * 2);
    return 1;
  };
  for (int i = 0; i < count; ++i) marked_[runs[i]] = 0;
  border_components_ = 0;
  for (int i = 0; i < count; ++i) {
    if (runs[i] == main_run_ && main_.piece == Side::kNone)
      main_.piece = static_cast<Piece>(border_components_);
    border_components_ += mark_new(i, kFirstRun);
  }
  for (int i = count - 1; i >= 0; --i) mark_new(i, kLastRun);
}

FloodEnd flood(const Grid& grid, const TileBox& box, bool eight, Cell from, Cell other) noexcept {
  return Flood(grid, box, eight, other).run(from);
}

}  // namespace lasius
