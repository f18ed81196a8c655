// A program whose own locale writes 1234.5 as "1.234,5".
#pragma once

#include <locale>
#include <string>

namespace lasius {

class OtherLocale {
 public:
  OtherLocale() : before_(std::locale::global({std::locale::classic(), new Numbers})) {}
  OtherLocale(const OtherLocale&) = delete;
  OtherLocale& operator=(const OtherLocale&) = delete;
  ~OtherLocale() { std::locale::global(before_); }

 private:
  struct Numbers final : std::numpunct<char> {
    char do_decimal_point() const override { return ','; }
    char do_thousands_sep() const override { return '.'; }
    std::string do_grouping() const override { return "\3"; }
  };
  std::locale before_;
};

}  // namespace lasius
