// Numbers as tables show them.
#pragma once

#include <string>

namespace lasius::study {

/// With this many decimals, 0 without a sign; "-" where it is not finite.
std::string fixed(double value, int decimals);

/// A p value: "0.032", or "< 0.001".
std::string p_text(double p);

/// Seconds with three significant digits.
std::string seconds_text(double seconds);

}  // namespace lasius::study
