#include "core/arm/robot/urdf_geometry.h"

#include <cmath>
#include <initializer_list>
#include <memory>
#include <utility>

#include "core/arm/robot/mesh_file.h"
#include "core/arm/robot/refusals.h"
#include "core/base/number_text.h"

namespace lasius::arm {
namespace {

constexpr double kMostMetres = 10;  // of a link's mesh in metres

/// urdfdom computes rotations by the C library: rounded, seldom others on another machine.
double settle(double v) { return std::round(v * 0x1p40) * 0x1p-40; }

[[noreturn]] void refuse_geometry(const urdf::Link& link, const UrdfFile& source) {
  broken(source.link(link.name), "the geometry of link \"" + link.name + "\" cannot be read",
         "give a box, sphere, cylinder or mesh whose sizes are numbers above 0");
}

}  // namespace

Placement placement(const urdf::Pose& p) {
  const urdf::Rotation& r = p.rotation;
  const double x = r.x, y = r.y, z = r.z, w = r.w;
  Placement result{{1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w),
                    2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w),
                    2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)},
                   vec(p.position)};
  for (double& entry : result.rotation) entry = settle(entry);
  return result;
}

Solid LinkGeometry::mesh(const urdf::Mesh& mesh, const urdf::Link& link, Robot& robot) {
  for (const double s : {mesh.scale.x, mesh.scale.y, mesh.scale.z}) {
    if (s != 0 && std::isfinite(s)) continue;
    broken(source_.link(link.name),
           "the mesh \"" + mesh.filename + "\" is scaled by " + number_text(s),
           "scale it by other numbers than 0; negative ones mirror it");
  }
  const std::string file = mesh_path(source_.link(link.name), mesh.filename, chain_.packages);
  Triangles triangles = read_mesh(file);
  triangles_ += triangles.size();
  if (triangles_ > kMostTriangles)
    unsupported(source_.link(link.name), "the robot's meshes have too many triangles",
                "at most " + std::to_string(kMostTriangles) + " are read: simplify them");
  for (auto& triangle : triangles) {
    for (Eigen::Vector3d& c : triangle)
      c = Vec3(c[0] * mesh.scale.x, c[1] * mesh.scale.y, c[2] * mesh.scale.z);
  }
  robot.files.push_back(file);
  if (mesh.scale.x == 1 && mesh.scale.y == 1 && mesh.scale.z == 1)
    warn_of_size(triangles, file, kMostMetres, robot.warnings);
  Solid solid;
  solid.shape = Solid::Shape::mesh;
  solid.triangles = std::make_shared<const Triangles>(std::move(triangles));
  return solid;
}

Solid LinkGeometry::solid(const urdf::Geometry& shape, const urdf::Link& link, Robot& robot) {
  const auto check_sizes = [&](std::initializer_list<double> sizes) {
    for (const double size : sizes)
      if (!(size > 0 && std::isfinite(size))) refuse_geometry(link, source_);
  };
  Solid solid;
  switch (shape.type) {
    case urdf::Geometry::SPHERE:
      solid.shape = Solid::Shape::sphere;
      solid.radius = static_cast<const urdf::Sphere&>(shape).radius;
      check_sizes({solid.radius});
      break;
    case urdf::Geometry::CYLINDER:
      solid.shape = Solid::Shape::cylinder;
      solid.radius = static_cast<const urdf::Cylinder&>(shape).radius;
      solid.length = static_cast<const urdf::Cylinder&>(shape).length;
      check_sizes({solid.radius, solid.length});
      break;
    case urdf::Geometry::BOX:
      solid.size = vec(static_cast<const urdf::Box&>(shape).dim);
      check_sizes({solid.size[0], solid.size[1], solid.size[2]});
      break;
    default:
      return mesh(static_cast<const urdf::Mesh&>(shape), link, robot);
  }
  return solid;
}

std::vector<Solid> LinkGeometry::read(const urdf::Link& link, const Placement& at, Robot& robot) {
  std::vector<Solid> solids;
  const auto add = [&](const auto& part) {
    if (part == nullptr || part->geometry == nullptr) refuse_geometry(link, source_);
    solids.push_back(solid(*part->geometry, link, robot));
    solids.back().pose = to_eigen(at * placement(part->origin));
  };
  for (const auto& part : link.collision_array) add(part);
  if (chain_.use_visual && solids.empty()) {
    for (const auto& part : link.visual_array) add(part);
  }
  return solids;
}

}  // namespace lasius::arm
