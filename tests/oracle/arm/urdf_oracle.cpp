#include "tests/oracle/arm/urdf_oracle.h"

#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <fcl/fcl.h>
#include <urdf_parser/urdf_parser.h>

#include <algorithm>
#include <assimp/Importer.hpp>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace lasius::oracle {
namespace {

fcl::Transform3d transform(const urdf::Pose& pose) {
  fcl::Transform3d t = fcl::Transform3d::Identity();
  const auto& r = pose.rotation;
  t.linear() = Eigen::Quaterniond(r.w, r.x, r.y, r.z).toRotationMatrix();
  t.translation() = Eigen::Vector3d(pose.position.x, pose.position.y, pose.position.z);
  return t;
}

template <class EachTriangle>
std::shared_ptr<fcl::CollisionGeometryd> make_mesh(const EachTriangle& each) {
  auto mesh = std::make_shared<fcl::BVHModel<fcl::OBBRSSd>>();
  mesh->beginModel();
  each([&](const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
    mesh->addTriangle(a, b, c);
  });
  mesh->endModel();
  return mesh;
}

std::shared_ptr<fcl::CollisionGeometryd> load_mesh(const std::string& file,
                                                   const urdf::Vector3& scale) {
  Assimp::Importer importer;
  const aiScene* scene =
      importer.ReadFile(file, aiProcess_Triangulate | aiProcess_PreTransformVertices);
  if (scene == nullptr) throw std::runtime_error(file + ": " + importer.GetErrorString());
  return make_mesh([&](const auto& add) {
    for (unsigned m = 0; m < scene->mNumMeshes; ++m) {
      const aiMesh& mesh = *scene->mMeshes[m];
      const auto corner = [&](unsigned face, unsigned i) -> Eigen::Vector3d {
        const aiVector3D& p = mesh.mVertices[mesh.mFaces[face].mIndices[i]];
        return {p.x * scale.x, p.y * scale.y, p.z * scale.z};
      };
      for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
        if (mesh.mFaces[f].mNumIndices == 3) add(corner(f, 0), corner(f, 1), corner(f, 2));
      }
    }
  });
}

std::shared_ptr<fcl::CollisionGeometryd> make(const urdf::Geometry& shape,
                                              const std::string& folder,
                                              const std::string& package) {
  if (shape.type == urdf::Geometry::SPHERE) {
    return std::make_shared<fcl::Sphered>(static_cast<const urdf::Sphere&>(shape).radius);
  }
  if (shape.type == urdf::Geometry::BOX) {
    const auto& size = static_cast<const urdf::Box&>(shape).dim;
    return std::make_shared<fcl::Boxd>(size.x, size.y, size.z);
  }
  if (shape.type == urdf::Geometry::CYLINDER) {
    const auto& cylinder = static_cast<const urdf::Cylinder&>(shape);
    return std::make_shared<fcl::Cylinderd>(cylinder.radius, cylinder.length);
  }
  const auto& mesh = static_cast<const urdf::Mesh&>(shape);
  const std::string scheme = "package://";
  std::string file = folder + "/" + mesh.filename;
  if (mesh.filename.starts_with(scheme)) {
    file = package + mesh.filename.substr(mesh.filename.find('/', scheme.size()));
  }
  return load_mesh(file, mesh.scale);
}

}  // namespace

UrdfOracle::UrdfOracle(const std::string& file, std::vector<std::string> moving,
                       std::map<std::string, double> standing, const std::string& package)
    : moving_(std::move(moving)), standing_(std::move(standing)) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  model_ = urdf::parseURDF(text.str());
  if (model_ == nullptr) throw std::runtime_error(file);
  add_link(model_->getRoot(), -1, file.substr(0, file.rfind('/')), package);
  for (int i = 0; i < static_cast<int>(parts_.size()); ++i) {
    for (int k = 0; k < i; ++k) {
      const int a = parts_[i].link, b = parts_[k].link;
      if (links_[a].parent != b && links_[b].parent != a && !rigid(a, b)) pairs_.emplace_back(i, k);
    }
  }
}

void UrdfOracle::add_link(const urdf::LinkConstSharedPtr& link, int parent,
                          const std::string& folder, const std::string& package) {
  const int number = static_cast<int>(links_.size());
  const auto& joint = link->parent_joint;
  const bool moves = joint != nullptr && std::ranges::find(moving_, joint->name) != moving_.end();
  links_.push_back({link->name, parent, joint, moves});
  for (const auto& part : link->collision_array) {
    parts_.push_back({make(*part->geometry, folder, package), transform(part->origin), number});
    parts_.back().geometry->computeLocalAABB();
  }
  for (const auto& child : link->child_links) add_link(child, number, folder, package);
}

/// No joint that moves is on the way from one to the other.
bool UrdfOracle::rigid(int a, int b) const {
  while (a != b) {
    int& later = a > b ? a : b;
    if (links_[later].moves) return false;
    later = links_[later].parent;
  }
  return true;
}

double UrdfOracle::value(const urdf::Joint& joint, const arm::JointRef& q) const {
  const auto moving = std::ranges::find(moving_, joint.name);
  if (moving != moving_.end()) return q[moving - moving_.begin()];
  if (joint.mimic != nullptr) {
    return joint.mimic->multiplier * value(*model_->getJoint(joint.mimic->joint_name), q) +
           joint.mimic->offset;
  }
  const auto standing = standing_.find(joint.name);
  return standing == standing_.end() ? 0 : standing->second;
}

void UrdfOracle::set_obstacles(const std::vector<arm::Obstacle>& obstacles) {
  obstacles_.clear();
  for (const arm::Obstacle& o : obstacles) {
    Geometry geometry;
    if (o.shape == arm::Solid::Shape::box) geometry = std::make_shared<fcl::Boxd>(o.size);
    if (o.shape == arm::Solid::Shape::sphere) geometry = std::make_shared<fcl::Sphered>(o.radius);
    if (o.shape == arm::Solid::Shape::cylinder) {
      geometry = std::make_shared<fcl::Cylinderd>(o.radius, o.length);
    }
    if (o.shape == arm::Solid::Shape::mesh) {
      geometry = make_mesh([&](const auto& add) {
        for (const auto& [a, b, c] : *o.triangles) add(a, b, c);
      });
    }
    geometry->computeLocalAABB();
    obstacles_.push_back({geometry, fcl::Transform3d(o.pose.matrix()), -1});
  }
}

std::string UrdfOracle::contact(const arm::JointRef& q) const {
  std::vector<fcl::Transform3d> at(links_.size());
  for (std::size_t i = 0; i < links_.size(); ++i) {
    at[i] = fcl::Transform3d::Identity();
    if (links_[i].parent < 0) continue;
    const urdf::Joint& joint = *links_[i].joint;
    at[i] = at[links_[i].parent] * transform(joint.parent_to_joint_origin_transform);
    if (joint.type == urdf::Joint::FIXED) continue;
    const Eigen::Vector3d axis = Eigen::Vector3d(joint.axis.x, joint.axis.y, joint.axis.z);
    if (joint.type == urdf::Joint::PRISMATIC) {
      at[i].translate(value(joint, q) * axis.normalized());
    } else {
      at[i].rotate(Eigen::AngleAxisd(value(joint, q), axis.normalized()));
    }
  }
  std::vector<fcl::Transform3d> placed;
  for (const Part& part : parts_) placed.push_back(at[part.link] * part.at);
  const auto touch = [](const Part& a, const fcl::Transform3d& at_a, const Part& b,
                        const fcl::Transform3d& at_b) {
    const double apart = (at_a * a.geometry->aabb_center - at_b * b.geometry->aabb_center).norm();
    if (apart > a.geometry->aabb_radius + b.geometry->aabb_radius) return false;
    const fcl::CollisionRequestd request;
    fcl::CollisionResultd result;
    fcl::collide(a.geometry.get(), at_a, b.geometry.get(), at_b, request, result);
    return result.isCollision();
  };
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    const std::string& name = links_[parts_[i].link].name;
    if (rigid(parts_[i].link, 0)) continue;  // stands like the obstacles
    for (std::size_t o = 0; o < obstacles_.size(); ++o) {
      if (touch(parts_[i], placed[i], obstacles_[o], obstacles_[o].at)) {
        return name + " and obstacle " + std::to_string(o + 1);
      }
    }
  }
  for (const auto& [i, k] : pairs_) {
    if (touch(parts_[i], placed[i], parts_[k], placed[k])) {
      return links_[parts_[i].link].name + " and " + links_[parts_[k].link].name;
    }
  }
  return {};
}

}  // namespace lasius::oracle
