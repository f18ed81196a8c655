// Texts of others in messages.
#include "core/base/printable.h"

#include <gtest/gtest.h>

#include "lasius/base/error.h"

namespace lasius {
namespace {

using namespace std::string_literals;

TEST(Printable, ShowsControlCharacters) {
  EXPECT_EQ(printable("a b~\xc3\xa4"), "a b~\xc3\xa4");
  EXPECT_EQ(printable("\x1b[31m\0|\n|\t|\x7f"s), "\\x1b[31m\\x00|\\x0a|\\x09|\\x7f");
  EXPECT_EQ(printable("\xc2\x9b\xc2\xa0\xc2"), "\\xc2\\x9b\xc2\xa0\xc2");
  EXPECT_EQ(printable(""), "");
}

TEST(Printable, AnErrorIsToldToItsEnd) {
  const Error error(ErrorCode::file_broken, {.file = "a\nb", .line = 2}, "is \0"s, "mend it");
  EXPECT_STREQ(error.what(), "a\\x0ab, line 2: is \\x00; mend it");
}

}  // namespace
}  // namespace lasius
