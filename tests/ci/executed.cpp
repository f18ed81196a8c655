// Which functions each case of a test program executes, for .ci/mutate: linked into the program,
// and silent unless LASIUS_EXECUTED names a file. A line a case: its name, processor seconds, "ok"
// or "failed", and the functions' names as 64 bits of their MD5, as clang's profile has them
// (compiler-rt, InstrProfData.inc, version 8).
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <set>
#include <vector>

namespace {

struct ProfiledFunction {
  std::uint64_t name;
  std::uint64_t hash;
  std::int64_t counters;  // from here
  void* address;
  void* values;
  std::uint32_t count;
  std::uint16_t sites[2];
};

}  // namespace

extern "C" {
const ProfiledFunction* __llvm_profile_begin_data();
const ProfiledFunction* __llvm_profile_end_data();
std::uint64_t* __llvm_profile_begin_counters();
std::uint64_t* __llvm_profile_end_counters();
}

namespace {

class Executed : public testing::EmptyTestEventListener {
 public:
  explicit Executed(const char* path) : out_(path) {}

 private:
  void OnTestSuiteStart(const testing::TestSuite&) override { executed(); }

  void OnTestStart(const testing::TestInfo&) override { prepared_.merge(executed()); }

  void OnTestEnd(const testing::TestInfo& test) override {
    std::set<std::uint64_t> names = executed();
    names.insert(prepared_.begin(), prepared_.end());
    const double seconds = double(std::clock()) / CLOCKS_PER_SEC;
    out_ << test.test_suite_name() << '.' << test.name() << ' ' << seconds - begun_ << ' '
         << (test.result()->Passed() || test.result()->Skipped() ? "ok" : "failed");
    for (const std::uint64_t name : names) {
      out_ << ' ' << name;
    }
    out_ << '\n' << std::flush;
    begun_ = seconds;
  }

  void OnTestSuiteEnd(const testing::TestSuite&) override { prepared_.clear(); }

  // The functions that were executed since the last call.
  std::set<std::uint64_t> executed() {
    std::uint64_t* const first = __llvm_profile_begin_counters();
    const std::vector<std::uint64_t> now(first, __llvm_profile_end_counters());
    before_.resize(now.size());
    std::set<std::uint64_t> names;
    for (const ProfiledFunction* one = __llvm_profile_begin_data();
         one != __llvm_profile_end_data(); ++one) {
      const auto* counters = reinterpret_cast<const std::uint64_t*>(
          reinterpret_cast<const char*>(one) + one->counters);
      const auto begin = now.begin() + (counters - first);
      if (!std::equal(begin, begin + one->count, before_.begin() + (counters - first))) {
        names.insert(one->name);
      }
    }
    before_ = now;
    return names;
  }

  std::ofstream out_;
  std::vector<std::uint64_t> before_;
  std::set<std::uint64_t> prepared_;  // by what all cases of a suite share
  double begun_ = 0;
};

const bool listening = [] {
  const char* path = std::getenv("LASIUS_EXECUTED");
  if (path != nullptr) {
    testing::UnitTest::GetInstance()->listeners().Append(new Executed(path));
  }
  return path != nullptr;
}();

}  // namespace
