#include "core/base/output.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include "lasius/base/error.h"
#include "tests/core/base/made_files.h"
#include "tests/core/base/refusal.h"

namespace lasius {
namespace {

class Outputs : public Files {
 protected:
  void write(const std::string& name, const std::string& text) const {
    write_file(path(name), [&](std::ostream& out) { out << text; });
  }
  std::string content(const std::string& name) const { return bytes_of(path(name)); }
  unsigned mode(const std::string& name) const {
    struct stat status {};
    EXPECT_EQ(::stat(path(name).c_str(), &status), 0);
    return status.st_mode & 07777;
  }
};

/// What a call throws.
ErrorCode code_of(const std::function<void()>& call, const std::string& word = {}) {
  const Error error = error_of(call);
  expect_says(error, word);
  return error.code();
}

TEST_F(Outputs, AreWholeOrNotThere) {
  write("kept", "old");
  const auto half = [](std::ostream& out) {
    out << "half";
    throw std::runtime_error("stop");
  };
  EXPECT_THROW(write_file(path("kept"), half), std::runtime_error);
  EXPECT_THROW(write_file(path("kept"), [](std::ostream& out) { out.setstate(std::ios::badbit); }),
               Error);
  EXPECT_EQ(files(), std::vector<std::string>{"kept"}) << "no temporary file is left";
  EXPECT_EQ(content("kept"), "old");
  const std::string large(1 << 20, 'x');  // more than is kept back
  EXPECT_EQ(code_of([&] { write_file("/dev/full", [&](auto& out) { out << large; }); }),
            ErrorCode::output_failed);
  write("kept", large);
  EXPECT_EQ(content("kept"), large);
}

TEST_F(Outputs, FollowLinksAndDevices) {
  file("old", "target");
  fs::create_symlink("target", path("link"));
  write("link", "new");
  EXPECT_TRUE(fs::is_symlink(path("link")));
  EXPECT_EQ(content("target"), "new");
  fs::create_directory(path("folder"));
  fs::create_symlink("folder/later", path("to_nothing"));
  fs::create_symlink(path("to_nothing"), path("by_two"));
  write("by_two", "there");
  EXPECT_TRUE(fs::is_symlink(path("by_two")) && fs::is_symlink(path("to_nothing")));
  EXPECT_EQ(content("folder/later"), "there");
  fs::create_symlink("round", path("round"));
  EXPECT_EQ(code_of([&] { write("round", ""); }, "circle"), ErrorCode::output_failed);
  write_file("/dev/null", [](std::ostream& out) { out << "nothing"; });
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

TEST_F(Outputs, KeepThePermissionsOfWhatTheyReplace) {
  for (const unsigned kept : {0600U, 0644U, 0666U, 0200U}) {
    file("old", "file");
    fs::permissions(path("file"), static_cast<fs::perms>(kept));
    write_file(path("file"), [&](std::ostream& out) {
      out << "new";
      EXPECT_EQ(mode("file"), kept);
    });
    EXPECT_EQ(mode("file"), kept);
    fs::remove(path("file"));
  }
  const mode_t before = ::umask(027);
  write("made", "");
  ::umask(before);
  EXPECT_EQ(mode("made"), 0640U);
}

TEST_F(Outputs, AreRefusedBeforeAnyWork) {
  fs::create_directory(path("folder"));
  file("old", "read_only");
  fs::permissions(path("read_only"), fs::perms::owner_read);
  const std::pair<std::string, const char*> cases[] = {
      {path("folder"), "folder"},
      {path("read_only"), "read-only"},
      {path("none/file"), "none"},
      {path("read_only/file"), "Not a directory"},
      {path(std::string(256, 'x')), "too long"},
      {path(std::string("old\0x", 5)), "zero byte"},
      {"/dev/fd/99999", "Bad file descriptor"}};
  for (const auto& refused : cases) {
    const auto& name = refused.first;
    const char* const word = refused.second;
    EXPECT_EQ(code_of([&] { check_outputs({name}, {}); }, word), ErrorCode::output_failed) << name;
    EXPECT_EQ(code_of([&] { write_file(name, [](auto&) { FAIL() << "was begun"; }); }, word),
              ErrorCode::output_failed)
        << name;
  }
  EXPECT_EQ(content("read_only"), "old");
  EXPECT_NO_THROW(
      check_outputs({path("new"), path("folder/new"), path(std::string(255, 'x'))}, {}));
  EXPECT_EQ(files().size(), 2U) << "nothing is made";
}

TEST_F(Outputs, MustBeFilesOfTheirOwn) {
  file("in", "input");
  fs::create_symlink("input", path("link"));
  fs::create_hard_link(path("input"), path("hard"));
  fs::create_symlink("new", path("link_to_new"));
  fs::create_directory(path("folder"));
  for (const char* name : {"input", "./input", "folder/../input", "link", "hard"})
    EXPECT_EQ(code_of(
                  [&] {
                    check_outputs({path(name)}, {path("other"), path("input")});
                  },
                  path("input")),
              ErrorCode::invalid_parameter)
        << name;
  for (const char* name : {"new", "./new", "folder/../new", "link_to_new"})
    EXPECT_EQ(code_of(
                  [&] {
                    check_outputs({path("new"), path(name)}, {});
                  },
                  path("new")),
              ErrorCode::invalid_parameter)
        << name;
  EXPECT_NO_THROW(check_outputs({path("new"), path("folder/new")}, {path("input")}));
  EXPECT_NO_THROW(check_outputs({"/dev/null", "/dev/null"}, {"/dev/null"}));
  EXPECT_NO_THROW(check_outputs({}, {path("input"), path("link")})) << "read twice";
}

TEST_F(Outputs, AreWrittenToOpenFilesWhereTheseAre) {
  const int both = ::open(file("", "log").c_str(), O_WRONLY);
  const int reading = ::open(path("log").c_str(), O_RDONLY);
  ASSERT_EQ(::write(both, "first ", 6), 6);
  const std::string name = "/dev/fd/" + std::to_string(both);
  write_file(name, [](std::ostream& out) { out << "second "; });
  fs::create_symlink(name, path("link"));
  write("link", "third ");
  ASSERT_EQ(::write(both, "last", 4), 4);
  EXPECT_EQ(content("log"), "first second third last");
  EXPECT_EQ(
      code_of([&] { check_outputs({"/dev/fd/" + std::to_string(reading)}, {}); }, "reading only"),
      ErrorCode::output_failed);
  EXPECT_EQ(code_of([&] { check_outputs({name}, {path("log")}); }, "log"),
            ErrorCode::invalid_parameter);
  EXPECT_TRUE(is_stream(name) && is_stream(path("link")) && is_stream("/dev/null"));
  EXPECT_FALSE(is_stream(path("log")) || is_stream(path("new")) || is_stream(path("")));
  ::close(both);
  ::close(reading);
}

}  // namespace
}  // namespace lasius
