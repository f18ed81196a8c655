#include <gtest/gtest.h>

#include "core/base/did_you_mean.h"
#include "lasius/lasius.h"
#include "lasius/version.h"

namespace lasius {
namespace {

TEST(Version, HasThreeNumbers) {
  EXPECT_EQ(std::to_string(LASIUS_VERSION_MAJOR) + "." + std::to_string(LASIUS_VERSION_MINOR) +
                "." + std::to_string(LASIUS_VERSION_PATCH),
            LASIUS_VERSION);
}

// The first and the last value of every public enumeration; what is no value has no name.
TEST(Names, OfEveryEnumeration) {
  EXPECT_EQ(to_string(Status::solved), "solved");
  EXPECT_EQ(to_string(Status::invalid), "invalid");
  EXPECT_EQ(to_string(Limit::none), "none");
  EXPECT_EQ(to_string(Limit::ticks), "ticks");
  EXPECT_EQ(to_string(Fault::none), "none");
  EXPECT_EQ(to_string(Fault::disconnected), "disconnected");
  EXPECT_EQ(to_string(Fault::trapped), "trapped");
  EXPECT_EQ(to_string(ErrorCode::invalid_parameter), "invalid_parameter");
  EXPECT_EQ(to_string(ErrorCode::output_failed), "output_failed");
  EXPECT_EQ(to_string(StopCondition::Cause::none), "none");
  EXPECT_EQ(to_string(StopCondition::Cause::deadline), "deadline");
  EXPECT_EQ(to_string(Preparation::State::none), "none");
  EXPECT_EQ(to_string(Preparation::State::stopped), "stopped");
  EXPECT_EQ(to_string(MapKind::blobs), "blobs");
  EXPECT_EQ(to_string(MapKind::open), "open");
  EXPECT_EQ(to_string(Nonzero::blocked), "blocked");
  EXPECT_EQ(to_string(Nonzero::free), "free");
  EXPECT_EQ(to_string(Corners::forbid), "forbid");
  EXPECT_EQ(to_string(Corners::allow), "allow");
  EXPECT_EQ(to_string(Neighbours::four), "4");
  EXPECT_EQ(to_string(Neighbours::sixteen_knight), "16k");
  EXPECT_EQ(to_string(Neighbours::thirty_two), "32");
  EXPECT_EQ(to_string(Polish::none), "none");
  EXPECT_EQ(to_string(Polish::taut), "taut");
  EXPECT_EQ(to_string(DeadEnd::kill), "kill");
  EXPECT_EQ(to_string(StraightDeposit::all), "all");
  EXPECT_EQ(to_string(Heuristic::uniform), "uniform");
  EXPECT_EQ(to_string(Heuristic::distance_field), "distance-field");
  EXPECT_EQ(to_string(Visibility::heading_change), "heading-change");
  EXPECT_EQ(to_string(Trail::arcs), "arcs");
  EXPECT_EQ(to_string(Update::ant_system), "ant-system");
  EXPECT_EQ(to_string(Update::learning), "learning");
  EXPECT_EQ(to_string(Selection::inverse_roulette), "inverse-roulette");
  EXPECT_EQ(to_string(Reward::affine), "affine");
  EXPECT_EQ(to_string(static_cast<Status>(99)), "");
  EXPECT_EQ(to_string(static_cast<Update>(-1)), "");
}

TEST(DidYouMean, TheNearestByPrefixLettersAndCapitals) {
  const std::vector<std::string_view> known{"--ants", "--algorithm", "--gap", "-v", "-V", "--all"};
  const auto nearest = [&](std::string_view name) { return did_you_mean(name, known); };
  EXPECT_EQ(nearest("--algo"), "did you mean \"--algorithm\"?");
  EXPECT_EQ(nearest("--al"), "did you mean \"--all\"?") << "the shorter of two";
  EXPECT_EQ(nearest("--atns"), "did you mean \"--ants\"?");
  EXPECT_EQ(nearest("--GAP"), "did you mean \"--gap\"?");
  EXPECT_EQ(nearest("--ALGO"), "did you mean \"--algorithm\"?");
  EXPECT_EQ(nearest("-V"), "did you mean \"-V\"?");
  EXPECT_EQ(nearest("--xal-gap"), "it is one of --ants, --algorithm, --gap, -v, -V, --all");
}

}  // namespace
}  // namespace lasius
