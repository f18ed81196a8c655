// Maps cut from noise: blobs, open, random.
#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "core/base/poller.h"
#include "core/generate/generate_kinds.h"
#include "core/generate/map_random.h"

namespace lasius {
namespace {

// Offsets and blends carry 12 bits of fraction, gradients lie within +-1023.
constexpr int kBits = 12;
constexpr std::int32_t kOne = 1 << kBits;
constexpr int kGradient = 1023;

/// A sum of octaves of gradient noise (Perlin 1985, interpolated by 3t^2 - 2t^3), in fixed point, a
/// row at a time.
class MapNoise {
 public:
  struct Octave {
    int pitch;   ///< cells between lattice points, >= 1
    int weight;  ///< 1 .. 16
  };

  MapNoise(int width, const MapRandom& random, std::span<const Octave> octaves);

  /// The values of row y, `width` of them, within +-2^28. Quick for rows in order.
  void row(int y, std::span<std::int32_t> values);

 private:
  struct Gradient {
    std::int32_t x, y;
  };
  struct Layer {
    Octave octave;
    std::vector<std::int32_t> offset;    // of a cell's centre from the lattice point, by cell
    std::vector<std::int32_t> blend;     // share of the next lattice point there
    std::vector<Gradient> above, below;  // of the lattice rows around the last row asked for
    int lattice_row = -1;
    std::vector<std::int32_t> base, slope;  // of each lattice column, on that row
  };

  void load_gradients(Layer& layer, std::uint32_t index, int lattice_row);
  void add_row(Layer& layer, int y, std::span<std::int32_t> values) const;

  const MapRandom random_;
  std::vector<Layer> layers_;
};

MapNoise::MapNoise(int width, const MapRandom& random, std::span<const Octave> octaves)
    : random_(random) {
  for (const Octave& octave : octaves) {
    Layer layer{octave, {}, {}, {}, {}, -1, {}, {}};
    for (int i = 0; i < octave.pitch; ++i) {
      const std::int64_t t = (2 * std::int64_t{i} + 1) * kOne / (2 * std::int64_t{octave.pitch});
      layer.offset.push_back(static_cast<std::int32_t>(t));
      layer.blend.push_back(
          static_cast<std::int32_t>(t * t * (3 * std::int64_t{kOne} - 2 * t) >> 2 * kBits));
    }
    const std::size_t columns = static_cast<std::size_t>((width - 1) / octave.pitch) + 2;
    layer.above.resize(columns);
    layer.below.resize(columns);
    layer.base.resize(columns);
    layer.slope.resize(columns);
    layers_.push_back(std::move(layer));
  }
}

void MapNoise::load_gradients(Layer& layer, std::uint32_t index, int lattice_row) {
  const auto load = [&](std::vector<Gradient>& row, int y) {
    for (std::size_t i = 0; i < row.size(); ++i) {
      const auto words = random_.at(MapStream::noise, static_cast<std::uint32_t>(i),
                                    static_cast<std::uint32_t>(y), index);
      row[i] = {kernels::below(2 * kGradient + 1, words[0]) - kGradient,
                kernels::below(2 * kGradient + 1, words[1]) - kGradient};
    }
  };
  if (lattice_row == layer.lattice_row) return;
  if (lattice_row == layer.lattice_row + 1 && layer.lattice_row >= 0)
    std::swap(layer.above, layer.below);
  else
    load(layer.above, lattice_row);
  load(layer.below, lattice_row + 1);
  layer.lattice_row = lattice_row;
}

void MapNoise::add_row(Layer& layer, int y, std::span<std::int32_t> values) const {
  const int pitch = layer.octave.pitch;
  const std::int64_t dy = layer.offset[y % pitch];
  const std::int64_t blend_y = layer.blend[y % pitch];
  // On one row, the noise of a lattice column is linear in x: base + slope * offset.
  for (std::size_t i = 0; i < layer.base.size(); ++i) {
    const Gradient a = layer.above[i];
    const Gradient b = layer.below[i];
    const std::int64_t top = a.y * dy;
    const std::int64_t bottom = b.y * (dy - kOne);
    layer.base[i] = static_cast<std::int32_t>(top + ((bottom - top) * blend_y >> kBits));
    layer.slope[i] = static_cast<std::int32_t>(a.x + ((b.x - a.x) * blend_y >> kBits));
  }
  const int width = static_cast<int>(values.size());
  for (int start = 0, i = 0; start < width; start += pitch, ++i) {
    const std::int32_t base = layer.base[i];
    const std::int32_t slope = layer.slope[i];
    const std::int32_t next_slope = layer.slope[i + 1];
    const std::int32_t next_base = layer.base[i + 1] - next_slope * kOne;
    const int count = std::min(pitch, width - start);
    std::int32_t* target = values.data() + start;
    for (int k = 0; k < count; ++k) {
      const std::int32_t t = layer.offset[k];
      const std::int32_t left = base + slope * t;
      const std::int32_t right = next_base + next_slope * t;
      const std::int32_t value = left + (((right - left) >> 8) * layer.blend[k] >> (kBits - 8));
      target[k] += (value >> 4) * layer.octave.weight;
    }
  }
}

void MapNoise::row(int y, std::span<std::int32_t> values) {
  std::ranges::fill(values, 0);
  for (std::uint32_t index = 0; index < layers_.size(); ++index) {
    Layer& layer = layers_[index];
    load_gradients(layer, index, y / layer.octave.pitch);
    add_row(layer, y, values);
  }
}

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
    for (int x = 0; x + step_x <= grid.width(); x += step_x)
      samples.push_back(row[x + draws.between(0, step_x - 1)]);
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
    for (int x = 0; x < grid.width(); ++x)
      words[x >> 6] |= std::uint64_t{values[x] >= threshold} << (x & 63);
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
