// A URDF file, before a robot is made of it.
#pragma once

#include <urdf_model/model.h>
#include <urdf_world/types.h>

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "core/arm/robot/xml_text.h"
#include "lasius/base/error.h"

namespace lasius::arm {

/// The links and joints of a URDF file, with the lines on which they begin. The links are a tree:
/// urdfdom itself reads loops, and of several parents keeps one.
class UrdfFile {
 public:
  /// @throws Error(file_broken) with the line where it is known.
  UrdfFile(std::string_view text, std::string file);

  const std::string& name() const noexcept { return file_; }
  const urdf::ModelInterface& model() const noexcept { return *model_; }

  Error::Place whole() const { return {.file = file_}; }
  Error::Place link(std::string_view name) const { return place(links_, name); }
  Error::Place joint(std::string_view name) const { return place(joints_, name); }

 private:
  using Lines = std::map<std::string, std::int64_t, std::less<>>;

  Error::Place line(std::int64_t number) const { return {.file = file_, .line = number}; }
  Error::Place place(const Lines& lines, std::string_view name) const {
    const auto found = lines.find(name);
    return found == lines.end() ? whole() : line(found->second);
  }
  void read_xml(const std::string& text);
  void parse(const std::string& text);

  std::string file_;
  Lines links_, joints_;
  // Of the robot's tag, if that is at fault; of materials, links and joints, as urdfdom reads them.
  std::vector<std::int64_t> part_lines_;
  std::int64_t broken_line_ = -1;  // of the XML
  urdf::ModelInterfaceSharedPtr model_;
};

}  // namespace lasius::arm
