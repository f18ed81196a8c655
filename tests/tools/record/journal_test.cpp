// What a journal keeps of a command that died: whole entries, up to the first that is not.
#include "tools/record/journal.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>
#include <map>
#include <string>

#include "lasius/base/error.h"
#include "tests/core/base/made_files.h"
#include "tests/core/base/refusal.h"

namespace lasius::tool {
namespace {

using Entries = std::map<int, std::string>;

class Journals : public Files {
 protected:
  Entries kept(const std::string& key = "key") const { return Journal(file_, key).kept(); }
  std::string bytes() const { return bytes_of(file_); }
  void put(const std::string& bytes) const { file(bytes, "a.journal"); }

  const std::string file_ = path("a.journal");
};

TEST_F(Journals, EntriesAreThereAgainInAnyOrder) {
  const Entries all{{0, "two\nlines\n"}, {3, ""}, {7, std::string("\0\xff", 2)}};
  {
    Journal journal(file_, "key");
    EXPECT_TRUE(journal.kept().empty());
    for (const int i : {7, 0, 3}) journal.add(i, all.at(i));
  }
  EXPECT_EQ(kept(), all);
  EXPECT_EQ(kept(), all);
}

TEST_F(Journals, AfterACutAnywhereWholeEntriesAreLeftAndMoreAreAdded) {
  {
    Journal journal(file_, "key");
    journal.add(1, "one");
    journal.add(2, "second");
  }
  const std::string whole = bytes();
  const std::size_t first = whole.find("2 6 ");
  for (std::size_t size = 0; size <= whole.size(); ++size) {
    put(whole.substr(0, size));
    {
      Journal journal(file_, "key");
      EXPECT_EQ(journal.kept().size(),
                std::size_t{size >= first} + std::size_t{size == whole.size()});
      journal.add(5, "five");
    }
    EXPECT_EQ(kept().at(5), "five") << size;
  }
}

TEST_F(Journals, AnEntryThatWasChangedEndsIt) {
  {
    Journal journal(file_, "key");
    journal.add(1, "one");
    journal.add(2, "second");
  }
  const std::string whole = bytes();
  for (std::size_t i = whole.find("1 3 "); i < whole.size(); ++i) {
    std::string changed = whole;
    changed[i] = static_cast<char>(changed[i] ^ 1);
    put(changed);
    const Entries left = kept();
    EXPECT_LE(left.size(), 1u) << i;
    if (!left.empty()) {
      EXPECT_EQ(left.at(1), "one") << i;
    }
  }
}

TEST_F(Journals, OneJobHasItAtATime) {
  Journal journal(file_, "key");
  journal.add(1, "one");
  EXPECT_THROW(Journal(file_, "key"), Error);
  journal.add(2, "two");
  EXPECT_EQ(journal.kept().size(), 0u);
  journal.remove();
  Journal(file_, "key").add(3, "three");  // another file, of that name
}

TEST_F(Journals, AnotherCommandBeginsAnewAndTheEndLeavesNothing) {
  Journal(file_, "key").add(1, "one");
  EXPECT_TRUE(kept("other").empty());
  EXPECT_TRUE(kept().empty());
  Journal journal(file_, "key");
  journal.remove();
  EXPECT_FALSE(std::filesystem::exists(file_));
  EXPECT_THROW(Journal(path("none/a"), "key"), Error);
}

TEST_F(Journals, AreFilesOfTheirOwn) {
  const std::string other = path("other"), link = path("link"), hard = path("hard");
  const std::string pipe = path("pipe"), read = path("read");
  file("mine", "other");
  std::filesystem::create_symlink(other, link);
  std::filesystem::create_hard_link(other, hard);
  for (const std::string& name : {pipe, read}) ASSERT_EQ(::mkfifo(name.c_str(), 0600), 0);
  const Descriptor reader(::open(read.c_str(), O_RDONLY | O_NONBLOCK));
  ASSERT_GE(reader.number(), 0);
  for (const std::string& name : {link, hard, pipe, read, path(".")})
    expect_says(error_of([&] { return Journal(name, "key").kept().size(); }, name),
                "is no file of its own");
  EXPECT_EQ(bytes_of(other), "mine");
}

}  // namespace
}  // namespace lasius::tool
