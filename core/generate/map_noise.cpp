#include "core/generate/map_noise.h"

#include <algorithm>

namespace lasius {
namespace {

// Offsets and blends carry 12 bits of fraction, gradients lie within +-1023.
constexpr int kBits = 12;
constexpr std::int32_t kOne = 1 << kBits;
constexpr int kGradient = 1023;

}  // namespace

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
  if (lattice_row == layer.lattice_row + 1 && layer.lattice_row >= 0) {
    std::swap(layer.above, layer.below);
  } else {
    load(layer.above, lattice_row);
  }
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

}  // namespace lasius
