// What a file holds, told by its text: for refusals of one that is of another kind.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>

#include "lasius/export.h"

namespace lasius {

enum class FileKind {
  unknown,
  urdf,
  srdf,
  other_xml,
  arm,
  scene,
  result,
  geojson,
  joint_limits,
  ros_map,
  study,
  tuning,
  movingai_map,
  scenario,
  image,
};

/// By its first bytes, tags or keys; never a throw.
LASIUS_EXPORT FileKind kind_of(std::string_view text) noexcept;

/// Its name in messages: "a robot in URDF".
LASIUS_EXPORT std::string told(FileKind kind);

/// @throws Error(file_unsupported) "this is KIND; `remedy`" for a text of a kind that is known and
///         none of `right`.
LASIUS_EXPORT void refuse_other_kinds(std::string_view text, const std::string& file,
                                      std::initializer_list<FileKind> right,
                                      const std::string& remedy);

}  // namespace lasius
