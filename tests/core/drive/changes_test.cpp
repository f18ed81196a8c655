#include <gtest/gtest.h>

#include "lasius/base/error.h"
#include "lasius/drive/drive.h"
#include "tests/core/base/refusal.h"

namespace lasius {
namespace {

TEST(Changes, AreReadLineByLine) {
  const Changes changes = read_changes(
      "# streets closed for works\n"
      "12 3 4 blocked\n"
      "\r\n"
      "  13\t3,4 , 2 5  free # and open again\r\n"
      "20 move 2 1 0.5  1 2  7 2  7 9",
      "works.txt", 20, 30);
  ASSERT_EQ(changes.cells.size(), 2u);
  EXPECT_EQ(changes.cells[0], (Change{12, {3, 4, 1, 1}, true}));
  EXPECT_EQ(changes.cells[1], (Change{13, {3, 4, 2, 5}, false}));
  ASSERT_EQ(changes.obstacles.size(), 1u);
  const MovingObstacle expected{
      .tick = 20, .width = 2, .height = 1, .speed = 0.5, .track = {{1, 2}, {7, 2}, {7, 9}}};
  EXPECT_EQ(changes.obstacles[0], expected);
}

TEST(Changes, OfNothingAreNone) {
  EXPECT_EQ(read_changes("", "none", 2, 2), Changes{});
  EXPECT_EQ(read_changes("\n\n# nothing\n", "none", 2, 2), Changes{});
}

TEST(Changes, ABrokenLineIsNamed) {
  const auto fails_at = [](const std::string& text) {
    const Error error = error_of([&] { return read_changes(text, "works.txt", 20, 30); });
    EXPECT_EQ(error.code(), ErrorCode::file_broken);
    EXPECT_EQ(error.place().file, "works.txt");
    EXPECT_FALSE(error.problem().empty());
    return error.place().line;
  };
  for (const char* line : {"1",
                           "1 2",
                           "1 2 3",
                           "1 2 3 blokced",
                           "x 2 3 free",
                           "1 2 3 4 free",
                           "1 2 3 4 5 6 free",
                           "-1 2 3 free",
                           "1 20 3 free",
                           "1 3 30 free",
                           "1 -1 3 free",
                           "1 2 3 0 1 free",
                           "1 19 3 2 1 free",
                           "1 2 3 1 99999999999 free",
                           "1.5 2 3 free",
                           "1 2 3 1 1 1 free",
                           "1 move",
                           "1 move 1 1 1",
                           "1 move 1 1 1 2",
                           "1 move 1 1 1 2 3 4",
                           "1 move 1 1 -1 2 3",
                           "1 move 1 1 nan 2 3",
                           "1 move 1 1 65 2 3",
                           "1 move 0 1 1 2 3",
                           "1 move 2 1 1 19 3",
                           "1 move 1 1 1 2 3 20 3",
                           "99999999999999999999 1 1 free",
                           "1 2 3 blocked x"}) {
    EXPECT_EQ(fails_at(std::string("# one\n0 0 0 free\n") + line + "\n"), 3) << line;
  }
}

TEST(Changes, AMisspeltStateIsGuessed) {
  const Error error = error_of([] { return read_changes("1 2 3 blokced", "works.txt", 20, 30); });
  expect_says(error.remedy(), "\"blocked\"");
}

TEST(Changes, AFileThatIsNotThereIsNamed) {
  const Error error = error_of([] { return read_changes_file("/nowhere/changes.txt", 3, 3); });
  EXPECT_EQ(error.code(), ErrorCode::file_missing);
  EXPECT_EQ(error.place().file, "/nowhere/changes.txt");
}

}  // namespace
}  // namespace lasius
