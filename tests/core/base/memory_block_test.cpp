// Scratch arrays: what memory they take, and when.
#include "core/base/memory_block.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <type_traits>
#include <utility>

#include "core/base/large_array.h"
#include "tests/core/base/counting_time.h"

namespace lasius {
namespace {

using Words = ZeroArray<std::uint64_t>;
static_assert(std::is_same_v<decltype(std::declval<const Words&>()[0]), const std::uint64_t&>);
static_assert(std::is_same_v<decltype(std::declval<const Words&>().at(0)), const std::uint64_t*>);

constexpr std::int64_t kLarge = 1 << 19;  // words: 4 MiB

std::int64_t page() { return sysconf(_SC_PAGESIZE); }

// A large block that was freed leads the C library to take the next ones from its heap.
void free_a_large_block() {
  void* volatile block = std::malloc(std::size_t{24} << 20);
  std::free(block);
}

void touch_all(Words& words) {
  for (std::int64_t i = 0; i < words.size(); ++i) words[i] = ~std::uint64_t{0};
}

TEST(ZeroArray, TakesMemoryWhereItIsWritten) {
  free_a_large_block();
  Words words(kLarge);
  EXPECT_EQ(words.bytes(), 0);
  words[0] = 1;
  words[kLarge - 1] = 2;
  EXPECT_EQ(words.bytes(), 2 * page());
  EXPECT_EQ(words[kLarge / 2], 0u);
}

TEST(ZeroArray, GivesBackHalfAMegabyteBetweenTwoLooksAtTheClock) {
  Words words(kLarge);
  touch_all(words);
  const auto all = words.bytes();
  EXPECT_EQ(all, kLarge * 8);
  const CountingTime time(3);
  const StopCondition stop = time.is_up();
  Poller poller(stop);
  EXPECT_FALSE(words.clear(poller));
  EXPECT_EQ(words.bytes(), all - 4 * Poller::kWords * 8);
  Poller patient(kNeverStops);
  EXPECT_TRUE(words.clear(patient));
  EXPECT_EQ(words.bytes(), 0);
  EXPECT_EQ(words[0], 0u);
  EXPECT_EQ(words[kLarge - 1], 0u);
}

TEST(ZeroArray, IsRenewedInASizeThatIsAtLeastTheOneAskedFor) {
  Poller poller(kNeverStops);
  Words words(100);
  touch_all(words);
  EXPECT_TRUE(words.renew(50, true, poller));
  EXPECT_EQ(words.size(), 100);
  for (int i = 0; i < 100; ++i) EXPECT_EQ(words[i], 0u);
  EXPECT_TRUE(words.renew(kLarge, false, poller));
  EXPECT_EQ(words.size(), kLarge);
  touch_all(words);
  EXPECT_TRUE(words.renew(10, false, poller));
  EXPECT_EQ(words.bytes(), 0);
}

TEST(GrowingArray, KeepsWhatIsInItAndTouchesNoMore) {
  free_a_large_block();
  GrowingArray<std::uint64_t> array;
  constexpr std::uint64_t kValues = 1000;
  array.grow(kValues);
  for (std::uint64_t i = 0; i < kValues; ++i) array.data()[i] = i;
  for (const std::size_t size : {2 * kValues, std::uint64_t{1} << 18, std::uint64_t{1} << 23}) {
    array.grow(size);
    EXPECT_EQ(array.size(), size);
    for (std::uint64_t i = 0; i < kValues; ++i) ASSERT_EQ(array.data()[i], i) << size;
  }
  array.grow(1);
  EXPECT_EQ(array.size(), std::size_t{1} << 23);
  EXPECT_LE(array.bytes(), 4 * page());  // those of 2000 values
}

TEST(MemoryBlock, WhatCannotBeHadThrows) {
  constexpr std::size_t kTooMuch = std::size_t{1} << 62;
  EXPECT_THROW(MemoryBlock{kTooMuch}, std::bad_alloc);
  for (const std::size_t size : {std::size_t{100}, MemoryBlock::kPaged}) {
    MemoryBlock block(size);
    static_cast<char*>(block.data())[99] = 7;
    EXPECT_THROW(block.grow(kTooMuch), std::bad_alloc);
    EXPECT_EQ(block.size(), size);
    EXPECT_EQ(static_cast<char*>(block.data())[99], 7);
  }
}

}  // namespace
}  // namespace lasius
