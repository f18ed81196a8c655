#include <algorithm>
#include <array>
#include <charconv>
#include <string>
#include <string_view>

#include "core/params/parameter_table.h"
#include "lasius/base/enum_names.h"
#include "lasius/params/params.h"

namespace lasius {

std::string Parameter::text_of(double end) const {
  const bool in_full = type == "integer" || end == 0 || (end >= 1e-6 && end < 1e7);
  std::array<char, 32> digits;
  char* const last =
      std::to_chars(digits.begin(), digits.end(), end,
                    in_full ? std::chars_format::fixed : std::chars_format::scientific)
          .ptr;
  std::string text(digits.begin(), last);  // 1e9, not 1e+09
  const auto sign = text.find('e') + 1;
  if (sign > 0 && text[sign + 1] == '0') text.replace(sign, 2, text[sign] == '-' ? "-" : "");
  return text;
}

std::string Parameter::range() const {
  std::string text;
  for (const std::string_view choice : choices) (text += text.empty() ? "" : "|") += choice;
  return choices.empty() ? text_of(least) + " .. " + text_of(most) : text;
}

bool Algorithm::has(std::string_view parameter) const noexcept {
  if (parameter == kEvaporation) parameter = kPersistence;
  return std::ranges::any_of(parameters,
                             [parameter](const Parameter& p) { return p.name == parameter; });
}

std::string_view to_string(Algorithm::Kind kind) noexcept {
  static constexpr std::array<std::string_view, 3> kNames{"exact", "colony", "genetic"};
  return name_of(kind, kNames);
}

}  // namespace lasius
