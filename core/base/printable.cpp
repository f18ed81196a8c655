#include "core/base/printable.h"

namespace lasius {
namespace {

constexpr std::string_view kDigits = "0123456789abcdef";

/// The bytes of the control character at `i`, U+0080 to U+009F of UTF-8 among them; 0: it is none.
std::size_t control_at(std::string_view text, std::size_t i) {
  const auto byte = [&](std::size_t at) { return static_cast<unsigned char>(text[at]); };
  if (byte(i) < 0x20 || byte(i) == 0x7f) return 1;
  const bool two = byte(i) == 0xc2 && i + 1 < text.size();
  return two && byte(i + 1) >= 0x80 && byte(i + 1) < 0xa0 ? 2 : 0;
}

}  // namespace

std::string printable(std::string_view text) {
  std::string shown;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const std::size_t control = control_at(text, i);
    if (control == 0) shown += text[i];
    for (const char c : text.substr(i, control)) {
      const auto byte = static_cast<unsigned char>(c);
      shown.append("\\x").append({kDigits[byte / 16], kDigits[byte % 16]});
    }
    if (control > 1) i += control - 1;
  }
  return shown;
}

}  // namespace lasius
