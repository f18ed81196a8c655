#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <optional>
#include <string_view>

#include "core/arm/robot/refusals.h"
#include "core/arm/robot/vec3.h"
#include "core/base/number_text.h"
#include "core/base/text_lines.h"
#include "core/map_files/byte_reader.h"
#include "lasius/arm/robot.h"

namespace lasius::arm {
namespace {

constexpr std::size_t kHead = 84;   // bytes before the first triangle of a binary file
constexpr std::size_t kFacet = 50;  // bytes of one

bool in_range(Vec3 v) {
  return std::abs(v.x) <= kFar && std::abs(v.y) <= kFar && std::abs(v.z) <= kFar;
}

static_assert(std::endian::native == std::endian::little, "as numbers in the files are");

std::uint32_t count_of(const std::string& bytes) {
  std::uint32_t count;
  std::memcpy(&count, bytes.data() + kHead - 4, sizeof count);
  return count;
}

Triangles parse_binary(const std::string& bytes, const std::string& file) {
  Triangles triangles(count_of(bytes));
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const std::size_t offset = kHead + kFacet * i + 12 * (corner + 1);
      float v[3];
      std::memcpy(v, bytes.data() + offset, sizeof v);
      triangles[i][corner] = Vec3(v[0], v[1], v[2]);
      if (!in_range(triangles[i][corner]))
        broken({.file = file, .offset = static_cast<std::int64_t>(offset)},
               "a corner is not within 1000 m", "scale the mesh");
    }
  }
  return triangles;
}

/// Word by word, however they are spread over lines: no vertex is passed over.
Triangles parse_ascii(std::string_view text, const std::string& file) {
  Triangles triangles;
  std::size_t corner = 0;
  bool solid = false, begun = false;  // a facet that has no vertex yet
  std::int64_t number = 1;
  const auto refuse = [&](const char* problem, const char* remedy) {
    broken({.file = file, .line = number}, problem, remedy);
  };
  for (; !text.empty(); ++number) {
    const auto end = std::min(text.find('\n'), text.size());
    const auto words = words_of(text.substr(0, end), kBlanksOfLines);
    text.remove_prefix(std::min(end + 1, text.size()));
    const auto real = [&](std::size_t i) {
      if (i >= words.size()) return std::optional<double>();
      return number_of<double>(words[i].substr(words[i].starts_with('+') ? 1 : 0));
    };
    for (std::size_t i = 0; i < words.size(); ++i) {
      const std::string_view word = words[i];
      if (word == "solid" || word == "endsolid") {
        solid = word == "solid";
        if (solid) break;  // its name follows
      }
      const bool facet = word == "facet";
      if ((facet || word == "endfacet" || word == "endsolid") && (corner != 0 || begun))
        refuse("a facet ends before it has 3 vertices", "a facet has exactly 3");
      begun = begun || facet;
      if (word == "endsolid") break;
      if (word != "vertex") continue;
      const auto x = real(i + 1), y = real(i + 2), z = real(i + 3);
      if (!x || !y || !z || real(i + 4) || !in_range({*x, *y, *z}))
        refuse("a vertex is not three numbers within 1000 m", "as in: vertex 0.1 0.2 0.3");
      i += 3;
      begun = false;
      if (corner == 0) triangles.emplace_back();
      triangles.back()[corner] = Vec3(*x, *y, *z);
      corner = (corner + 1) % 3;
    }
  }
  if (corner != 0)
    broken({.file = file}, "the last facet has fewer than 3 vertices", "a facet has exactly 3");
  if (solid) broken({.file = file}, "the file ends before its endsolid", "save the mesh again");
  return triangles;
}

}  // namespace

Triangles read_stl(const std::string& path) {
  constexpr std::int64_t kMostBytes = 256 << 20;
  std::string bytes = read_text(path, kMostBytes);
  const bool binary =
      bytes.size() >= kHead && bytes.size() == kHead + kFacet * std::size_t{count_of(bytes)};
  Triangles triangles;
  if (binary) {
    triangles = parse_binary(bytes, path);
  } else if (bytes.starts_with("solid")) {
    end_lines_in_lf(bytes);
    triangles = parse_ascii(bytes, path);
  } else {
    broken({.file = path}, "this is no STL file: neither its text nor its size fits",
           "save the mesh as binary or ASCII STL");
  }
  if (triangles.empty()) broken({.file = path}, "the mesh has no triangles", "save it again");
  return triangles;
}

}  // namespace lasius::arm
