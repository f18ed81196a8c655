// Frames of a run that takes nobody knows how long.
#pragma once

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

namespace lasius::tool {

/// Keeps the frame of every tick, or of a long run of every second, fourth, ... one, from tick 0
/// on: never more than `most`, and half of them at least.
template <class Frame>
class KeyFrames {
 public:
  /// Precondition: most >= 2.
  explicit KeyFrames(std::size_t most) : most_(most) {}

  /// True where the frame of this tick is to be added now. Ticks rise from 0, none is left out.
  bool wants(std::int64_t tick) {
    if (tick % stride_ != 0) return false;
    if (frames_.size() >= most_) thin();
    return tick % stride_ == 0;
  }
  void add(Frame frame) { frames_.push_back(std::move(frame)); }

  /// Drops every second frame, the first stays.
  void thin() {
    std::size_t kept = 1;
    for (std::size_t i = 2; i < frames_.size(); i += 2) frames_[kept++] = std::move(frames_[i]);
    frames_.resize(std::min(kept, frames_.size()));
    stride_ *= 2;
  }

  const std::vector<Frame>& all() const { return frames_; }
  std::int64_t stride() const { return stride_; }  ///< ticks from frame to frame

 private:
  std::size_t most_;
  std::int64_t stride_ = 1;
  std::vector<Frame> frames_;
};

}  // namespace lasius::tool
