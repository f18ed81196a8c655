#include <memory>
#include <span>
#include <utility>

#include "core/arm/robot/json_fields.h"
#include "core/arm/robot/mesh_file.h"
#include "core/arm/robot/vec3.h"
#include "core/base/did_you_mean.h"
#include "core/base/file_kind.h"
#include "core/map_files/byte_reader.h"
#include "lasius/arm/robot.h"
#include "lasius/base/error.h"

namespace lasius::arm {
namespace {

constexpr double kThin = 1e-6;
constexpr double kMostMetres = 100;  // of a mesh in metres: a hall

Obstacle::Shape shape_of(const JsonFields& fields) {
  const auto names = std::span(kShapeNames).first<4>();
  const std::string name = fields.text("shape");
  for (std::size_t i = 0; i < names.size(); ++i)
    if (name == names[i]) return static_cast<Obstacle::Shape>(i);
  fields.fail("shape", "is \"" + name + "\"",
              did_you_mean(name, names, "it must be box|sphere|cylinder|mesh"));
}

void refuse_foreign(const JsonFields& fields, std::string_view shape,
                    std::initializer_list<std::string_view> foreign) {
  for (const auto name : foreign) {
    if (fields.has(name))
      fields.fail(name, "is not a field of a " + std::string(shape), "leave it out");
  }
}

Obstacle read_obstacle(const JsonFields& fields) {
  Obstacle o;
  o.shape = shape_of(fields);
  o.name = fields.text_or("name", "");
  const Vec3 position = fields.vector_or("position", kFar, {});
  o.pose = to_eigen({roll_pitch_yaw(fields.vector_or("rpy", 100, {})), position});
  switch (o.shape) {
    case Obstacle::Shape::box:
      refuse_foreign(fields, "box", {"radius", "length", "file", "scale"});
      o.size = fields.vector("size", kFar);
      if (!(o.size[0] >= kThin && o.size[1] >= kThin && o.size[2] >= kThin))
        fields.fail("size", "is too small", "every side must be 0.000001 .. 1000");
      break;
    case Obstacle::Shape::sphere:
      refuse_foreign(fields, "sphere", {"size", "length", "file", "scale"});
      o.radius = fields.number("radius", kThin, kFar);
      break;
    case Obstacle::Shape::cylinder:
      refuse_foreign(fields, "cylinder", {"size", "file", "scale"});
      o.radius = fields.number("radius", kThin, kFar);
      o.length = fields.number("length", kThin, kFar);
      break;
    case Obstacle::Shape::mesh: {
      refuse_foreign(fields, "mesh", {"size", "radius", "length"});
      const double scale = fields.number_or("scale", kThin, kFar, 1);
      o.file = mesh_path(fields.file(), fields.text("file"));
      Triangles triangles = read_mesh(o.file);
      for (auto& triangle : triangles) {
        for (Eigen::Vector3d& corner : triangle) {
          corner = scale * Vec3(corner);
          if (!(length(corner) <= kFar))
            fields.fail("scale", "makes the mesh larger than 1000 m", "scale it down");
        }
      }
      o.triangles = std::make_shared<const Triangles>(std::move(triangles));
      break;
    }
    case Obstacle::Shape::capsule:  // not in files
      break;
  }
  return o;
}

}  // namespace

Scene parse_scene(std::string_view text, const std::string& file) {
  constexpr std::size_t kMost = 10000;
  refuse_other_kinds(text, file, {FileKind::scene},
                     "give a scene, JSON of the format \"lasius-scene/1\"");
  const auto document = parse_json(text, file, "lasius-scene/1");
  const JsonFields top(*document, text, file, "", {"format", "name", "obstacles"});
  Scene scene;
  scene.name = top.text_or("name", "");
  std::size_t triangles = 0;
  for (const JsonFields& fields : top.list(
           "obstacles", 0, kMost,
           {"shape", "name", "position", "rpy", "size", "radius", "length", "file", "scale"})) {
    scene.obstacles.push_back(read_obstacle(fields));
    if (const auto& mesh = scene.obstacles.back().triangles) {
      triangles += mesh->size();
      if (!fields.has("scale"))
        warn_of_size(*mesh, scene.obstacles.back().file, kMostMetres, scene.warnings);
    }
    if (triangles > kMostTriangles)
      fields.fail("file",
                  "brings the scene's meshes to " + std::to_string(triangles) + " triangles",
                  "at most " + std::to_string(kMostTriangles) + " are read: simplify the meshes");
  }
  return scene;
}

Scene read_scene(const std::string& path) {
  constexpr std::int64_t kMostBytes = 64 << 20;
  return parse_scene(read_text(path, kMostBytes), path);
}

}  // namespace lasius::arm
