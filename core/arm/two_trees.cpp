#include "core/arm/two_trees.h"

#include <numbers>

#include "kernels/base/random_stream.h"

namespace lasius::arm {
namespace {

constexpr std::array<int, Robot::kMaxJoints> kPrimes{2,  3,  5,  7,  11, 13, 17, 19,
                                                     23, 29, 31, 37, 41, 43, 47, 53};

}  // namespace

SpreadValues::SpreadValues(const Robot& robot, const JointVector& start, std::uint64_t seed)
    : low_(robot.size()), width_(robot.size()) {
  constexpr std::uint32_t kUse = 3;  // of random streams
  kernels::RandomStream words(seed, 0, 0, kUse);
  for (int j = 0; j < robot.size(); ++j) {
    const Joint& joint = robot.joints[j];
    low_[j] = joint.continuous ? std::max(joint.low, start[j] - std::numbers::pi) : joint.low;
    const double high =
        joint.continuous ? std::min(joint.high, start[j] + std::numbers::pi) : joint.high;
    width_[j] = high - low_[j];
    turn_[j] = (words.next() + 0.5) * 0x1p-32;
  }
}

void SpreadValues::next(JointVector& q) {
  for (Eigen::Index j = 0; j < low_.size(); ++j) {
    // The digits of a number in a base, mirrored at the point: evenly spread in 0 .. 1.
    auto& digits = digits_[j];
    std::size_t carry = 0;
    while (carry < digits.size() && digits[carry].value + 1 == kPrimes[j])
      digits[carry++].value = 0;
    if (carry == digits.size())
      digits.push_back({0, (carry == 0 ? 1 : digits.back().share) / kPrimes[j]});
    ++digits[carry].value;
    double value = 0;
    for (const Digit& digit : digits) value += digit.share * digit.value;
    const double place = value + turn_[j];
    q[j] = std::min(low_[j] + width_[j] * (place < 1 ? place : place - 1), low_[j] + width_[j]);
  }
}

int MotionTree::nearest(const JointVector& q) const noexcept {
  int best = 0;
  double least = 1e300;
  const double* at = values_.data();
  for (int n = 0; n < size(); ++n, at += joints_) {
    double sum = 0;
    for (std::ptrdiff_t j = 0; j < joints_; ++j) sum += (at[j] - q[j]) * (at[j] - q[j]);
    if (sum < least) least = sum, best = n;
  }
  return best;
}

}  // namespace lasius::arm
