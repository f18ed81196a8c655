// Proofs as files: read as they were written; what is broken is refused by name.
#include <gtest/gtest.h>

#include <random>
#include <string>

#include "lasius/cost/planner.h"
#include "lasius/io/json.h"
#include "tests/core/base/refusal.h"
#include "tests/worlds/weights.h"

namespace lasius {
namespace {

TEST(ProofJson, ReadsBackTheSame) {
  std::mt19937 random(4);
  int levels = 0;
  for (int i = 0; i < 20; ++i) {
    const WeightedWorld world = random_weights(random, 5, 20);
    const CostPlanner planner(Planner(Grid(world.grid)), world.costs);
    const Request request{.start = world.start, .goal = world.goal};
    const CostResult result = planner.plan(request, {.proof = true});
    ASSERT_NE(result.proof, nullptr);
    // Of equal weights `exact` has a greater bound.
    EXPECT_LE(result.proof->lower_bound, *result.lower_bound);
    EXPECT_GE(result.proof->lower_bound, 0.999 * *result.lower_bound);
    const CostResult plain = planner.plan(request);
    EXPECT_EQ(plain.proof, nullptr);
    EXPECT_NEAR(plain.cost, result.cost, 1e-9 * plain.cost);
    const std::string text = proof_to_json(*result.proof, R"([{"file":"a.pfm","factor":2}])");
    const CostProof read = proof_from_json(text);
    EXPECT_EQ(read, *result.proof);
    EXPECT_EQ(check_proof(world.grid, world.costs, read), std::nullopt);
    const std::string binary = proof_to_cbor(*result.proof, R"([{"file":"a.pfm","factor":2}])");
    EXPECT_EQ(proof_from_cbor(binary), read);
    if (read.levels.size() > 1) {
      EXPECT_LT(binary.size(), text.size() * 2 / 3);
    }
    levels += static_cast<int>(read.levels.size());
  }
  EXPECT_GT(levels, 40);
}

TEST(ProofJson, EqualWeightsAndAStartThatIsTheGoal) {
  const Grid grid(9, 7);
  const CostField costs(9, 7);
  const CostPlanner planner(Planner(Grid(grid)), costs);
  for (const Cell goal : {Cell{1, 1}, Cell{7, 4}}) {
    const CostResult result = planner.plan({.start = {1, 1}, .goal = goal}, {.proof = true});
    ASSERT_NE(result.proof, nullptr);
    EXPECT_NEAR(result.proof->lower_bound, result.cost, 1e-9);
    EXPECT_EQ(check_proof(grid, costs, *result.proof), std::nullopt);
  }
  EXPECT_EQ(error_of([&] {
              return planner.plan({.start = {1, 1}, .goal = {7, 4}},
                                  {.eight_moves = true, .proof = true});
            }).code(),
            ErrorCode::invalid_parameter);
}

TEST(ProofJson, WhatIsBrokenIsNamed) {
  CostProof proof{.start = {1, 2}, .goal = {3, 4}, .lower_bound = 2.5, .map_hash = 7};
  proof.levels.push_back({.runs = {0, 0, 1}, .values = {1, 2}});
  const std::string good = proof_to_json(proof);
  EXPECT_EQ(proof_from_json(good), proof);
  const struct {
    std::string from, to, says;
  } cases[] = {
      {"lasius-proof/1", "lasius-proof/2", "\"format\": \"lasius-proof/2\""},
      {"\"start\":[1,2]", "\"start\":[1]", "\"start\": [1]"},
      {"\"start\":[1,2]", "\"start\":[1,2.5]", "\"start\": 2.5"},
      {"\"start\":[1,2]", "\"start\":[1,18446744073709551615]", "\"start\": 18446744073709551615"},
      {"\"lower_bound\"", "\"bound\"", "lacks \"lower_bound\""},
      {"0000000000000007", "7", "\"hash\": \"7\""},
      {"\"from\":\"start\"", "\"from\":\"end\"", "\"from\": \"end\""},
      {"[1,2]}", "[1,null]}", "\"values\": null"},
      {"[0,0,1]", "7", "\"runs\": 7"},
      {"]}\n", "]", ""},
  };
  for (const auto& [from, to, says] : cases) {
    std::string text = good;
    text.replace(text.rfind(from), from.size(), to);
    const Error error = error_of([&] { return proof_from_json(text, "a.json"); }, text);
    EXPECT_EQ(error.code(), ErrorCode::file_broken);
    EXPECT_EQ(error.place().file, "a.json");
    expect_says(error, says);
  }
}

TEST(ProofCbor, WhatIsBrokenIsNamed) {
  CostProof proof{.start = {1, 2}, .goal = {3, 4}, .lower_bound = 2.5, .map_hash = 7};
  proof.levels.push_back({.runs = {0, 0, 1}, .values = {1, 2}});
  const std::string good = proof_to_cbor(proof);
  EXPECT_EQ(proof_from_cbor(good), proof);
  for (std::size_t size = 0; size < good.size(); ++size)
    EXPECT_EQ(error_of([&] { return proof_from_cbor(good.substr(0, size), "a.cbor"); }).code(),
              ErrorCode::file_broken);
  EXPECT_EQ(error_of([&] { return proof_from_cbor(good + 'x', "a.cbor"); }).place().file, "a.cbor");
  // No byte that is another crashes the reader; a tag that is another is named.
  for (std::size_t at = 0; at < good.size(); ++at) {
    std::string other = good;
    other[at] = static_cast<char>(other[at] ^ 0x15);
    try {
      EXPECT_NE(proof_from_cbor(other), proof) << at;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::file_broken) << at;
    }
  }
  for (const std::string& bad :
       {std::string(50000, '\x81'), std::string("\xbb\x7f\xff\xff\xff\xff\xff\xff\xff"),
        std::string("\x9f\x01\xff")})
    EXPECT_EQ(error_of([&] { return proof_from_cbor(bad); }).code(), ErrorCode::file_broken);
  std::string other = good;
  other[good.rfind("\xd8\x56") + 1] = 0x52;  // big-endian doubles
  expect_says(error_of([&] { return proof_from_cbor(other); }), "\"values\" is no typed array");
}

}  // namespace
}  // namespace lasius
