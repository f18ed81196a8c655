// Opening a named pipe.
#include "core/base/opening_pipe.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdio>
#include <string>
#include <thread>

namespace lasius {
namespace {

/// The path of a named pipe of this process.
std::string made_pipe(const std::string& name) {
  const std::string pipe = testing::TempDir() + name + std::to_string(::getpid());
  EXPECT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  return pipe;
}

TEST(OpeningPipe, IsUnderWayWhileANamedPipeIsOpened) {
  const std::string pipe = made_pipe("one");
  EXPECT_FALSE(OpeningPipe::under_way());
  {
    const OpeningPipe opening(pipe);
    const OpeningPipe file(LASIUS_MAPS_DIR "/grid20a.map"), none("none.map");
    EXPECT_TRUE(OpeningPipe::under_way());
  }
  EXPECT_FALSE(OpeningPipe::under_way());
  std::remove(pipe.c_str());
}

TEST(OpeningPipe, IsCountedOnSeveralThreads) {
  const std::string pipe = made_pipe("shared");
  const auto open_and_close = [&] {
    for (int i = 0; i < 1000; ++i) {
      const OpeningPipe opening(pipe);
      EXPECT_TRUE(OpeningPipe::under_way());
    }
  };
  {
    const std::jthread other(open_and_close);
    open_and_close();
  }
  EXPECT_FALSE(OpeningPipe::under_way());
  std::remove(pipe.c_str());
}

}  // namespace
}  // namespace lasius
