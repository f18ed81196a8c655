#include "tools/yaml/document.h"

#include <gtest/gtest.h>

#include "lasius/base/error.h"
#include "tests/core/base/made_files.h"
#include "tests/core/base/refusal.h"
#include "tests/tools/yaml/fault_line.h"
#include "tools/yaml/preset_file.h"

namespace lasius::tool {
namespace {

/// What reading and `use` throw.
template <class Use>
std::string fault(const std::string& text, const Use& use) {
  return fault_line([&] { use(parse_document(text, "f.yaml")); }, "f.yaml");
}
std::string fault(const std::string& text) {
  return fault(text, [](const Node&) {});
}

TEST(Document, YamlAndJsonAreOneTree) {
  for (const char* text : {"a: 1\nb: [x, 'y z']\nc:\n  d: true\n", R"({"a": 1,
"b": ["x", "y z"],
"c": {"d": true}})"}) {
    const Node root = parse_document(text, "f");
    EXPECT_EQ(root.at("a").integer(0, 5), 1);
    EXPECT_EQ(root.at("b").texts(), (std::vector<std::string>{"x", "y z"}));
    EXPECT_EQ(root.at("b").joined(), "x y z");
    EXPECT_EQ(root.at("b").line(), 2);
    EXPECT_TRUE(root.at("c").at("d").flag());
    EXPECT_EQ(root.at("c").line(), 3);
    EXPECT_EQ(root.find("e"), nullptr);
    EXPECT_EQ(root.number_or("e", 2.5, 0, 3), 2.5);
  }
}

TEST(Document, LinesEndInAnyWay) {
  for (const std::string end : {"\n", "\r\n", "\r"})
    EXPECT_EQ(parse_document("a: 1" + end + end + "b: 2" + end, "f").at("b").line(), 3);
}

TEST(Document, RefusesWhatIsNoDocument) {
  EXPECT_EQ(fault(""), "1: the file is empty; give it its keys, or name another");
  EXPECT_EQ(fault("a: 1\n---\nb: 2\n"),
            "1: something follows the document; keep one document a file");
  EXPECT_EQ(fault(", a: b"), "1: something follows the document; keep one document a file");
  EXPECT_NE(fault("a: 1\n, b: 2\n"), "");
  EXPECT_EQ(fault("a: 1\nb: [1, 2\nc: 3\n").substr(0, 40),
            "3: this is neither YAML nor JSON: end of");
  EXPECT_EQ(fault("a: 1\n\na: 2\n"), "3: 'a' is given again; leave one of the two out");
  EXPECT_EQ(fault("a: {x: 1, x: 2}"), "1: 'x' is given again; leave one of the two out");
  EXPECT_EQ(fault("[1, 2]: 3\n"), "1: a key is a list or a map; write KEY: VALUE");
  EXPECT_NE(fault(std::string(20000, '[')), "");
}

TEST(Document, AliasesCannotMakeMuchOfLittle) {
  std::string text = "a0: &a0 [x, x, x, x, x, x, x, x, x, x]\n";
  for (int i = 1; i < 12; ++i) {
    const std::string n = std::to_string(i), before = "*a" + std::to_string(i - 1);
    text += "a" + n + ": &a" + n + " [";
    for (int k = 0; k < 10; ++k) text += (k > 0 ? ", " : "") + before;
    text += "]\n";
  }
  expect_says(fault(text), "too many values");
  std::string keys;
  for (int i = 0; i < 2001; ++i) keys += "k" + std::to_string(i) + ": 1\n";
  EXPECT_EQ(fault(keys), "2001: 'k2000' is one key too many; a map has at most 2000");
}

TEST(Document, AliasesCannotHoldThemselves) {
  for (const char* text : {"a: &a [*a]", "a: &a {b: *a}", "&a [x, [*a]]"}) {
    expect_says(fault(text), "nests too deep");
  }
}

TEST(Document, NamesLineAndKeyOfAWrongValue) {
  const std::string text = "a: x\nb:\n  c: 7\n  d: [1, 2]\n  e:\n";
  const auto with = [&](const auto& use) {
    return fault(text, [&](const Node& root) { use(root); });
  };
  EXPECT_EQ(with([](const Node& r) { r.at("a").number(0, 1); }),
            "1: 'a' is \"x\"; it is a number, from 0 to 1");
  EXPECT_EQ(with([](const Node& r) { r.at("b").at("c").integer(8, 9); }),
            "3: 'c' is \"7\"; it is a whole number, from 8 to 9");
  EXPECT_EQ(with([](const Node& r) { r.at("b").at("d").text(); }),
            "4: 'd' has no value, or more than one; give it a value");
  EXPECT_EQ(with([](const Node& r) { r.at("b").at("e").text(); }),
            "5: 'e' has no value, or more than one; give it a value");
  EXPECT_EQ(with([](const Node& r) { r.at("b").at("d").items()[1].at("x"); }),
            "4: 'd' is no map of keys and values; write it as KEY: VALUE");
  EXPECT_EQ(with([](const Node& r) { r.at("b").at("x"); }),
            "2: 'b' is incomplete: 'x' is missing; add a line x:");
  EXPECT_EQ(with([](const Node& r) { r.at("bb"); }), "1: 'bb' is missing; add a line bb:");
  EXPECT_EQ(with([](const Node& r) {
              r.at("b").allow({"count", "dd", "e"});
            }),
            "3: 'c' is unknown here; did you mean \"count\"?");
  EXPECT_EQ(with([](const Node& r) { r.at("a").flag(); }),
            "1: 'a' is \"x\"; it is one of true, yes, on, false, no, off");
  static constexpr std::string_view kNames[] = {"grid", "latin"};
  EXPECT_EQ(with([](const Node& r) { r.at("a").choice(kNames); }),
            "1: 'a' is \"x\"; it is one of grid, latin");
}

class PresetFiles : public Files {
 protected:
  std::string refusal(const std::string& text) {
    file(text, "p.yaml");
    return fault_line([&] { return read_preset_file(path("p.yaml")); }, path("p.yaml"));
  }
};

TEST_F(PresetFiles, AreReadAndTried) {
  file("algorithm: mmas\npreset: book\nset:\n  persistence: 0.97\n  ants: '12'\n", "p.yaml");
  const PresetFile preset = read_preset_file(path("p.yaml"));
  EXPECT_EQ(preset.algorithm, "mmas");
  EXPECT_EQ(preset.preset, Preset::book);
  EXPECT_EQ(preset.settings, (std::vector<std::pair<std::string, std::string>>{
                                 {"persistence", "0.97"}, {"ants", "12"}}));
  EXPECT_EQ(refusal("algorithm: as\n"), "");
  EXPECT_EQ(refusal("algorithm: as\nset: {}\n"), "");
}

TEST_F(PresetFiles, AreRefusedWithLineAndKey) {
  EXPECT_EQ(refusal("set: {}\n"), "1: 'algorithm' is missing; add a line algorithm:");
  expect_says(refusal("algorithm: mmass\n"), "1: 'algorithm' is refused: ");
  expect_says(refusal("algorithm: mmass\n"), "\"mmas\"");
  expect_says(refusal("algorithm: fan2004\npreset: book\n"), "2: 'preset' is refused: ");
  const auto unknown = refusal("algorithm: as\nset:\n  ants: 4\n  persistance: 0.5\n");
  expect_says(unknown, "4: 'persistance' is refused: ");
  expect_says(unknown, "\"persistence\"");
  expect_says(refusal("algorithm: exact\nset:\n  ants: 4\n"), "3: 'ants' is no parameter of exact");
  expect_says(refusal("algorithm: as\nset:\n  ants: 0\n"), "3: 'ants' is refused: ");
  expect_says(refusal("algorithm: as\nset:\n  neighbours: 4\n  polish: taut\n  walk_cut: none\n  "
                      "trail: cell\n"),
              "6: 'trail' is refused: ");
  EXPECT_EQ(refusal("algorithm: as\nsets: {}\n"),
            "2: 'sets' is unknown here; did you mean \"set\"?");
  EXPECT_THROW((void)read_preset_file(path("none.yaml")), Error);
}

}  // namespace
}  // namespace lasius::tool
