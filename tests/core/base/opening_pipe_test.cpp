// Opening a named pipe.
#include "core/base/opening_pipe.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <string>
#include <thread>

#include "tests/core/base/made_files.h"

namespace lasius {
namespace {

class OpeningPipes : public Files {
 protected:
  std::string made_pipe() const {
    EXPECT_EQ(::mkfifo(path("pipe").c_str(), 0600), 0);
    return path("pipe");
  }
};

TEST_F(OpeningPipes, AreUnderWayWhileANamedPipeIsOpened) {
  const std::string pipe = made_pipe();
  EXPECT_FALSE(OpeningPipe::under_way());
  {
    const OpeningPipe opening(pipe);
    const OpeningPipe file(LASIUS_MAPS_DIR "/grid20a.map"), none("none.map");
    EXPECT_TRUE(OpeningPipe::under_way());
  }
  EXPECT_FALSE(OpeningPipe::under_way());
}

TEST_F(OpeningPipes, AreCountedOnSeveralThreads) {
  const std::string pipe = made_pipe();
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
}

}  // namespace
}  // namespace lasius
