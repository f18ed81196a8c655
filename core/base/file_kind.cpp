#include "core/base/file_kind.h"

#include <algorithm>
#include <array>
#include <cctype>

#include "lasius/base/error.h"

namespace lasius {
namespace {

constexpr std::array<std::string_view, 15> kTold{
    "no file of this kind",
    "a robot in URDF",
    "an SRDF file",
    "an XML file",
    "a robot in JSON (lasius-arm/1)",
    "a scene (lasius-scene/1)",
    "a result of lasius",
    "GeoJSON",
    "MoveIt's joint limits",
    "the YAML file of a ROS map",
    "a study",
    "a tuning",
    "a MovingAI map",
    "a MovingAI scenario",
    "an image",
};

constexpr std::size_t kRead = 1 << 20;  // bytes that are looked at

/// Words of a text that tell its kind: the first row of which the text has one is it.
struct Mark {
  std::string_view word;
  FileKind kind;
};

template <std::size_t kCount, class Has>
FileKind first_of(const Mark (&marks)[kCount], FileKind otherwise, const Has& has) {
  const auto* const found = std::ranges::find_if(marks, [&](const Mark& m) { return has(m.word); });
  return found == std::end(marks) ? otherwise : found->kind;
}

FileKind kind_of_xml(std::string_view text) {
  static constexpr Mark kTags[] = {
      {"<parent", FileKind::urdf},        {"<collision>", FileKind::urdf},
      {"<visual>", FileKind::urdf},       {"<group", FileKind::srdf},
      {"<disable_", FileKind::srdf},      {"<enable_c", FileKind::srdf},
      {"<virtual_joint", FileKind::srdf}, {"<end_effector", FileKind::srdf},
  };
  const auto has = [&](std::string_view word) { return text.find(word) != text.npos; };
  if (!has("<robot")) return FileKind::other_xml;
  return first_of(kTags, FileKind::unknown, has);
}

FileKind kind_of_json(std::string_view text) {
  static constexpr Mark kFormats[] = {
      {"lasius-arm/1", FileKind::arm},          {"lasius-scene/1", FileKind::scene},
      {"lasius-plan/1", FileKind::result},      {"lasius-drive/1", FileKind::result},
      {"lasius-arm-plan/1", FileKind::result},  {"FeatureCollection", FileKind::geojson},
      {"GeometryCollection", FileKind::geojson}};
  const auto without_blanks = [](std::string_view t) {
    return t.substr(0, t.find_last_not_of(" \t\r\n") + 1);
  };
  return first_of(kFormats, FileKind::unknown, [&](std::string_view word) {
    for (auto at = text.find(word); at != text.npos; at = text.find(word, at + 1)) {
      if (at == 0 || text[at - 1] != '"') continue;
      const auto before = without_blanks(text.substr(0, at - 1));
      if (!before.ends_with(':')) continue;
      const auto key = without_blanks(before.substr(0, before.size() - 1));
      if (key.ends_with("\"format\"") || key.ends_with("\"type\"")) return true;
    }
    return false;
  });
}

/// By a key of the outermost level, in YAML or in JSON's quotes.
FileKind kind_by_key(std::string_view text) {
  static constexpr Mark kKeys[] = {
      {"joint_limits", FileKind::joint_limits}, {"image", FileKind::ros_map},
      {"contenders", FileKind::study},          {"experiments", FileKind::study},
      {"training", FileKind::tuning},           {"candidates", FileKind::tuning}};
  return first_of(kKeys, FileKind::unknown, [&](std::string_view key) {
    for (auto at = text.find(key); at != text.npos; at = text.find(key, at + 1)) {
      const bool begins = at == 0 || text[at - 1] == '\n' || text[at - 1] == '\r';
      if (begins && text.substr(at + key.size()).starts_with(':')) return true;
    }
    return false;
  });
}

}  // namespace

FileKind kind_of(std::string_view text) noexcept {
  static constexpr Mark kBegins[] = {
      {"\x89PNG", FileKind::image},     {"\xff\xd8\xff", FileKind::image},
      {"GIF8", FileKind::image},        {"BM", FileKind::image},
      {"II*", FileKind::image},         {"type octile", FileKind::movingai_map},
      {"version 1", FileKind::scenario}};
  if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
  const auto first = text.find_first_not_of(" \t\r\n");
  if (first == text.npos) return FileKind::unknown;
  text = text.substr(first, kRead);
  if (text.front() == '<') return kind_of_xml(text);
  if (text.front() == '{') return kind_of_json(text);
  const bool pnm = text.size() > 2 && text[0] == 'P' && text[1] >= '1' && text[1] <= '6' &&
                   std::isspace(static_cast<unsigned char>(text[2])) != 0;
  if (pnm) return FileKind::image;
  const FileKind kind =
      first_of(kBegins, FileKind::unknown, [&](auto word) { return text.starts_with(word); });
  return kind == FileKind::unknown ? kind_by_key(text) : kind;
}

std::string told(FileKind kind) { return std::string(kTold[static_cast<std::size_t>(kind)]); }

void refuse_other_kinds(std::string_view text, const std::string& file,
                        std::initializer_list<FileKind> right, const std::string& remedy) {
  const FileKind kind = kind_of(text);
  if (kind == FileKind::unknown || std::ranges::find(right, kind) != right.end()) return;
  throw Error(ErrorCode::file_unsupported, {.file = file}, "this is " + told(kind), remedy);
}

}  // namespace lasius
