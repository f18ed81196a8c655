#include "tools/study/table.h"

#include <gtest/gtest.h>

namespace lasius::study {
namespace {

TEST(Table, CsvKeepsEveryCell) {
  const Table table{{"a", "b", "c"},
                    {{"", "1", ""}, {"x,y", "\"q\"", "two\nlines"}, {"cr\r", "plain", "a|b"}}};
  EXPECT_EQ(table.csv(),
            "a,b,c\n"
            ",1,\n"
            "\"x,y\",\"\"\"q\"\"\",\"two\nlines\"\n"
            "\"cr\r\",plain,a|b\n");
}

TEST(Table, MarkdownKeepsItsColumns) {
  const Table table{{"claim", "n"}, {{"a | b", "1"}, {"two\nlines", ""}}};
  EXPECT_EQ(table.markdown(),
            "| claim | n |\n"
            "|---|---|\n"
            "| a \\| b | 1 |\n"
            "| two lines |  |\n");
}

}  // namespace
}  // namespace lasius::study
