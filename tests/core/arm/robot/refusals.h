// What readers of robots and scenes say of broken files, and a robot in URDF to break.
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <span>
#include <string>

#include "lasius/arm/robot.h"
#include "lasius/base/error.h"
#include "tests/core/base/refusal.h"

namespace lasius::arm {

inline constexpr const char* kUrdf = R"(<robot name="r">
  <link name="a"/><link name="b"><collision><origin xyz="0 0 0.5"/>
    <geometry><cylinder radius="0.1" length="1"/></geometry></collision></link>
  <link name="c"><collision><geometry><sphere radius="0.2"/></geometry></collision></link>
  <link name="d"/>
  <joint name="j1" type="continuous"><parent link="a"/><child link="b"/><axis xyz="0 0 2"/></joint>
  <joint name="f" type="fixed"><parent link="b"/><child link="c"/><origin xyz="0 0 1"/></joint>
  <joint name="j2" type="prismatic"><parent link="c"/><child link="d"/>
    <origin xyz="0 0 0.5" rpy="0 1.5707963267948966 0"/><axis xyz="0 0 1"/>
    <limit lower="-0.2" upper="0.3" velocity="0.5" effort="1"/></joint>
</robot>)";

/// A text with `to` in place of the first `from`.
inline std::string with(std::string text, const std::string& from, const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
}

/// What stands in a text, what is put in its place, and the line that is then at fault.
struct Spoilt {
  std::string from, to;
  std::int64_t line;
};

template <class Read>
void expect_lines(std::span<const Spoilt> cases, const std::string& text, const Read& read) {
  for (const auto& [from, to, line] : cases) {
    const std::string broken = with(text, from, to);
    const Error error = error_of([&] { read(broken); }, broken);
    EXPECT_EQ(error.place().line, line) << error.what();
  }
}

inline void expect_error(const std::string& text, ErrorCode code, const std::string& words) {
  const Error error = error_of([&] { return parse_robot(text, "r.txt"); }, text.substr(0, 80));
  EXPECT_EQ(error.code(), code) << error.what();
  expect_says(error, words);
  EXPECT_FALSE(error.remedy().empty());
}

}  // namespace lasius::arm
