// Maps cut from noise: blobs, open, random.
#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include "core/base/poller.h"
#include "core/generate/generate_kinds.h"
#include "core/generate/map_noise.h"

namespace lasius {
namespace {

constexpr int kSampleSide = 1024;  // rows and columns looked at to find a threshold, about

// The noise value at and above which a cell is blocked. Small maps are looked at whole; of large
// ones a cell of each tile, at random, since even steps would meet the same phase of the lattice.
std::int32_t threshold_of(MapNoise& noise, const Grid& grid, BlockedShare share, MapDraws draws,
                          Poller& poller) {
  const int step_x = std::max(1, grid.width() / kSampleSide);
  const int step_y = std::max(1, grid.height() / kSampleSide);
  std::vector<std::int32_t> row(grid.width());
  std::vector<std::int32_t> samples;
  for (int y = 0; y + step_y <= grid.height(); y += step_y) {
    noise.row(y + draws.between(0, step_y - 1), row);
    for (int x = 0; x + step_x <= grid.width(); x += step_x) {
      samples.push_back(row[x + draws.between(0, step_x - 1)]);
    }
    if (poller.stop_after(grid.width())) break;
  }
  const std::size_t blocked = samples.size() * std::uint64_t{share} >> 32;
  if (blocked == 0) return INT32_MAX;
  const auto nth = samples.end() - static_cast<std::ptrdiff_t>(blocked);
  std::nth_element(samples.begin(), nth, samples.end());
  return *nth;
}

void cut_noise(Grid& grid, BlockedShare share, const MapRandom& random, Poller& poller,
               std::span<const MapNoise::Octave> octaves) {
  MapNoise noise(grid.width(), random, octaves);
  const std::int32_t threshold =
      threshold_of(noise, grid, share, MapDraws(random, MapStream::samples), poller);
  std::vector<std::int32_t> values(grid.width());
  std::vector<std::uint64_t> words(grid.words());
  for (int y = 0; y < grid.height() && !poller.stop_after(grid.width()); ++y) {
    noise.row(y, values);
    std::ranges::fill(words, 0);
    for (int x = 0; x < grid.width(); ++x) {
      words[x >> 6] |= std::uint64_t{values[x] >= threshold} << (x & 63);
    }
    grid.set_row(y, words.data());
  }
}

}  // namespace

void make_blobs(Grid& grid, BlockedShare share, const MapRandom& random, Poller& poller) {
  const int pitch = std::clamp(std::min(grid.width(), grid.height()) / 10, 6, 24);
  const std::array<MapNoise::Octave, 3> octaves = {
      {{pitch, 12}, {std::max(2, pitch / 2), 6}, {std::max(2, pitch / 5), 2}}};
  cut_noise(grid, share, random, poller, octaves);
}

void make_open(Grid& grid, BlockedShare share, const MapRandom& random, Poller& poller) {
  const int pitch = std::max(8, std::min(grid.width(), grid.height()) / 5);
  const std::array<MapNoise::Octave, 3> octaves = {
      {{pitch, 16}, {std::max(4, pitch / 4), 4}, {std::max(2, pitch / 12), 1}}};
  cut_noise(grid, share, random, poller, octaves);
}

void make_random(Grid& grid, BlockedShare share, const MapRandom& random, Poller& poller) {
  std::vector<std::uint64_t> words(grid.words());
  for (int y = 0; y < grid.height() && !poller.stop_after(grid.width()); ++y) {
    for (int i = 0; i < grid.words(); ++i) {
      std::uint64_t word = 0;
      for (int k = 0; k < 16; ++k) {
        const auto draw = random.at(MapStream::cells, static_cast<std::uint32_t>(16 * i + k),
                                    static_cast<std::uint32_t>(y));
        for (int b = 0; b < 4; ++b) word |= std::uint64_t{draw[b] < share} << (4 * k + b);
      }
      words[i] = word;
    }
    grid.set_row(y, words.data());
  }
}

}  // namespace lasius
