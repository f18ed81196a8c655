#include "core/base/file_kind.h"

#include "tests/core/base/refusal.h"

namespace lasius {
namespace {

TEST(FileKind, IsToldByContent) {
  using enum FileKind;
  const std::pair<const char*, FileKind> cases[] = {
      {"", unknown},
      {" \n", unknown},
      {"<?xml?>\n<robot name='r'><link name='a'/><joint><parent link='a'/></joint>", urdf},
      {"<robot name='r'><group name='arm'><link name='a'/></group></robot>", srdf},
      {"<robot name='r'/>", unknown},
      {"<html></html>", other_xml},
      {"\xef\xbb\xbf{\"format\" :\n \"lasius-arm/1\"}", arm},
      {"{\"name\": \"lasius-arm/1\", \"format\": \"lasius-scene/1\"}", scene},
      {"{\"format\": \"lasius-arm/2\"}", unknown},
      {"{\"version\": \"1\", \"format\": \"lasius-drive/1\"}", result},
      {"{\"type\": \"FeatureCollection\"", geojson},
      {"{lasius-arm/1\"", unknown},
      {"lasius-arm/1", unknown},
      {"# limits\njoint_limits:\n  a: {}", joint_limits},
      {"resolution: 1\r\nimage: a.png", ros_map},
      {"text: an image: none\n", unknown},
      {"name: a\ncontenders: [exact]", study},
      {"training: {}", tuning},
      {"type octile\nheight 3", movingai_map},
      {"version 1.0\n0 a", scenario},
      {"\x89PNG\r\n", image},
      {"P5 3 3 255", image},
      {"P5", unknown},
  };
  for (const auto& [text, kind] : cases) EXPECT_EQ(kind_of(text), kind) << text;
}

TEST(FileKind, AnotherKindIsRefusedByName) {
  const auto refuse = [](const std::string& text) {
    refuse_other_kinds(text, "f", {FileKind::scene, FileKind::image}, "give a scene");
  };
  for (const char* const text : {"{\"format\": \"lasius-scene/1\"}", "P4\n", "", "anything"})
    EXPECT_NO_THROW(refuse(text)) << text;
  const Error error = error_of([&] { refuse("type octile\n"); });
  EXPECT_EQ(error.code(), ErrorCode::file_unsupported);
  EXPECT_STREQ(error.what(), "f: this is a MovingAI map; give a scene");
}

}  // namespace
}  // namespace lasius
