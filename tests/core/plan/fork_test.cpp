// Plans in a process that was forked.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include "lasius/plan/batch.h"
#include "tests/worlds/planning.h"

namespace lasius {
namespace {

// GNU's OpenMP runtime would wait for threads that there are only in the parent.
TEST(Fork, AChildPlansAsItsParentDidThoughThatHadThreads) {
  const FarApart far;
  Params params = quick("fan2004");
  params.threads = 2;
  const Result expected = far.plan(params);
  const pid_t child = fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    alarm(60);  // a child that waits forever is ended
    const PrepareOptions two{.threads = 2};
    const auto batch = plan_batch(far.planner, {&far.request, 1}, quick("fan2004"), {.threads = 2});
    const bool alike = far.plan(params).path == expected.path &&
                       batch.at(0).result.path == expected.path &&
                       far.planner.prepared(two).plan(far.request).optimal;
    _exit(alike ? 0 : 1);
  }
  int status = 0;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  ASSERT_TRUE(WIFEXITED(status)) << "signal " << WTERMSIG(status);
  EXPECT_EQ(WEXITSTATUS(status), 0);
}

}  // namespace
}  // namespace lasius
