// Numbers as tables show them, texts as pictures do.
#pragma once

#include <string>

#include "lasius/base/status.h"

namespace lasius::tool {

/// What is drawn of a text: bytes that are no UTF-8 (of file names, say) are U+FFFD; of a word of
/// more than 100 letters, and of a text of more than 1000, the first are left and "…" at their end.
/// Cairo takes seconds for longer ones. What this gives it leaves as it is.
std::string drawn(const std::string& text);

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
