// Polynomials, in one order of operations everywhere.
#pragma once

namespace lasius::kernels {

/// The polynomial with these coefficients, the highest power's first, at x: Horner's rule.
template <class... Rest>
[[gnu::always_inline]] inline constexpr double horner(double x, double first,
                                                      Rest... rest) noexcept {
  ((first = first * x + rest), ...);
  return first;
}

}  // namespace lasius::kernels
