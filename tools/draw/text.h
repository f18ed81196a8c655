// Numbers as tables show them.
#pragma once

#include <string>

#include "lasius/status.h"

namespace lasius::tool {

/// With this many decimals, 0 without a sign; "-" where it is not finite.
std::string fixed(double value, int decimals);

/// A p value: "0.032", or "< 0.001".
std::string p_text(double p);

/// Seconds with three significant digits.
std::string seconds_text(double seconds);

/// ", 1.20% above the NAME SHOWN", below it or equal to it, at an optimum above 0; `shown` is the
/// optimum with its unit.
std::string against(double length, double optimum, const std::string& name,
                    const std::string& shown);

/// Why there is no path.
std::string no_path_text(Status status);

}  // namespace lasius::tool
