#include "study/text.h"

#include <array>
#include <cmath>
#include <cstdio>

namespace lasius::study {

std::string fixed(double value, int decimals) {
  if (!std::isfinite(value)) return "-";
  std::array<char, 64> text;
  std::snprintf(text.data(), text.size(), "%.*f", decimals, value);
  return text.data();
}

std::string p_text(double p) { return p < 0.001 ? "< 0.001" : fixed(p, 3); }

std::string seconds_text(double seconds) {
  if (!(seconds > 0)) return fixed(seconds, 0);
  const int decimals = 2 - static_cast<int>(std::floor(std::log10(seconds)));
  return fixed(seconds, std::max(0, std::min(decimals, 5)));
}

}  // namespace lasius::study
