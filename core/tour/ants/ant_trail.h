// The trail of a colony over stops.
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "kernels/base/power.h"

namespace lasius::tour {

/// A leg from a stop to another.
struct Arc {
  int from;
  int to;
};

/// Pheromone on the legs between n stops, with the weights tau^alpha * eta^beta that it gives.
/// Takes 24 n^2 bytes. `both_ways`: a leg and its way back are one.
class AntTrail {
 public:
  /// `visibility` are eta^beta, row by row, 0 on the diagonal.
  AntTrail(int size, double tau0, double alpha, bool both_ways, std::vector<double> visibility)
      : size_(static_cast<std::size_t>(size)),
        alpha_(alpha),
        both_ways_(both_ways),
        visibility_(std::move(visibility)),
        tau_(visibility_.size(), tau0),
        weight_(visibility_.size()) {
    refresh();
  }

  void evaporate(double persistence) {
    for (double& tau : tau_) tau *= persistence;
    fresh_ = false;
  }
  void deposit(const Arc& arc, double amount) { put(arc, tau_[index(arc)] + amount); }
  double tau(const Arc& arc) const { return std::clamp(tau_[index(arc)], least_, most_); }
  /// Its weight is known at once, if all others are.
  void set_tau(const Arc& arc, double tau) {
    put(arc, tau);
    weigh(index(arc));
    if (both_ways_) weigh(index({arc.to, arc.from}));
  }
  void bound(double least, double most) {
    least_ = least;
    most_ = most;
    for (double& tau : tau_) tau = std::clamp(tau, least, most);
  }

  /// Brings the weights up to date.
  void refresh() {
    if (fresh_) return;
    for (std::size_t i = 0; i < tau_.size(); ++i) weigh(i);
    fresh_ = true;
  }
  /// Of all legs from a stop. Precondition: refreshed.
  std::span<const double> weights(int from) const {
    return std::span(weight_).subspan(static_cast<std::size_t>(from) * size_, size_);
  }

 private:
  std::size_t index(const Arc& arc) const {
    return static_cast<std::size_t>(arc.from) * size_ + static_cast<std::size_t>(arc.to);
  }
  void put(const Arc& arc, double tau) {
    tau_[index(arc)] = tau;
    if (both_ways_) tau_[index({arc.to, arc.from})] = tau;
  }
  void weigh(std::size_t i) {
    double tau = std::clamp(tau_[i], least_, most_);
    if (alpha_ == 0) tau = 1;  // soon, so that a control is not slower
    weight_[i] = (alpha_ == 0 || alpha_ == 1 ? tau : kernels::power(tau, alpha_)) * visibility_[i];
  }

  std::size_t size_;
  double alpha_;
  bool both_ways_;
  bool fresh_ = false;
  double least_ = 0, most_ = std::numeric_limits<double>::max();
  std::vector<double> visibility_, tau_, weight_;
};

}  // namespace lasius::tour
