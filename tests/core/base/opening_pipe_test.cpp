// Opening a named pipe.
#include "core/base/opening_pipe.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cstdio>
#include <string>
#include <thread>

#include "core/map_files/byte_reader.h"

namespace lasius {
namespace {

TEST(OpeningPipe, IsUnderWayWhileANamedPipeIsOpened) {
  const std::string pipe = testing::TempDir() + "lasius_opening_pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_FALSE(OpeningPipe::under_way());
  {
    const OpeningPipe opening(pipe);
    const OpeningPipe file(LASIUS_MAPS_DIR "/grid20a.map"), none("none.map");
    EXPECT_TRUE(OpeningPipe::under_way());
  }
  EXPECT_FALSE(OpeningPipe::under_way());
  std::remove(pipe.c_str());
}

TEST(OpeningPipe, FilesAreReadOnSeveralThreads) {
  const auto read = [] {
    for (int i = 0; i < 50; ++i)
      EXPECT_FALSE(read_text(LASIUS_MAPS_DIR "/grid20a.map", 1 << 20).empty());
  };
  std::jthread other(read);
  read();
}

}  // namespace
}  // namespace lasius
