#include "core/arm/robot/mesh_file.h"

#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <algorithm>
#include <assimp/IOSystem.hpp>
#include <assimp/Importer.hpp>
#include <cctype>
#include <exception>
#include <filesystem>
#include <string_view>

#include "core/arm/robot/refusals.h"
#include "core/arm/robot/vec3.h"
#include "core/arm/robot/xml_text.h"
#include "core/base/number_text.h"
#include "core/map_files/byte_reader.h"

namespace lasius::arm {
namespace {

/// Materials and textures that a mesh names are not opened.
class NoFiles final : public Assimp::IOSystem {
 public:
  bool Exists(const char*) const override { return false; }
  char getOsSeparator() const override { return '/'; }
  Assimp::IOStream* Open(const char*, const char*) override { return nullptr; }
  void Close(Assimp::IOStream*) override {}
};

/// The triangles of a node and of those below it, `at` its frame.
void add_node(const aiScene& scene, const aiNode& node, const aiMatrix4x4& above,
              const std::string& file, Triangles& triangles) {
  const aiMatrix4x4 at = above * node.mTransformation;
  for (unsigned m = 0; m < node.mNumMeshes; ++m) {
    const aiMesh& mesh = *scene.mMeshes[node.mMeshes[m]];
    for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
      const aiFace& face = mesh.mFaces[f];
      if (face.mNumIndices != 3) continue;  // points and lines
      if (triangles.size() == kMostTriangles)
        unsupported({.file = file}, "the mesh has too many triangles",
                    "at most " + std::to_string(kMostTriangles) + " are read: simplify it");
      triangles.emplace_back();
      for (unsigned i = 0; i < 3; ++i) {
        const aiVector3D p = at * mesh.mVertices[face.mIndices[i]];
        for (unsigned k = 0; k < 3; ++k) {
          if (!(std::abs(p[k]) <= static_cast<float>(kFar)))
            broken({.file = file}, "a corner is not within 1000 m", "scale the mesh");
        }
        triangles.back()[i] = Vec3(p.x, p.y, p.z);
      }
    }
  }
  for (unsigned i = 0; i < node.mNumChildren; ++i)
    add_node(scene, *node.mChildren[i], at, file, triangles);
}

Triangles import_mesh(const std::string& text, const std::string& file, const char* ending) {
  Assimp::Importer importer;
  importer.SetIOHandler(new NoFiles);  // which the importer deletes
  importer.SetPropertyInteger(AI_CONFIG_IMPORT_COLLADA_IGNORE_UP_DIRECTION, 1);
  const aiScene* scene = nullptr;
  std::string fault;
  try {
    scene = importer.ReadFileFromMemory(text.data(), text.size(), aiProcess_Triangulate, ending);
    fault = importer.GetErrorString();
  } catch (const std::exception& e) {
    fault = e.what();
  }
  if (scene == nullptr || scene->mRootNode == nullptr)
    broken({.file = file}, "the mesh cannot be read (" + fault + ")", "save it as STL");
  Triangles triangles;
  add_node(*scene, *scene->mRootNode, aiMatrix4x4(), file, triangles);
  if (triangles.empty()) broken({.file = file}, "the mesh has no triangles", "save it again");
  return triangles;
}

/// Made comments: the importer looks for a material library again and again where it is not there.
void leave_materials_out(std::string& text) {
  for (const std::string_view word : {"mtllib", "usemtl"}) {
    for (auto at = text.find(word); at != text.npos; at = text.find(word, at + 1)) {
      const auto before = text.find_last_not_of(" \t", at == 0 ? text.npos : at - 1);
      if (at == 0 || before == text.npos || text[before] == '\n' || text[before] == '\r')
        text[at] = '#';
    }
  }
}

std::string ending_of(const std::string& path) {
  std::string ending = std::filesystem::path(path).extension().string();
  for (char& c : ending) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return ending;
}

}  // namespace

Triangles read_mesh(const std::string& path) {
  constexpr std::int64_t kMostBytes = 64 << 20;
  const std::string ending = ending_of(path);
  if (ending == ".stl") return read_stl(path);
  if (ending != ".obj" && ending != ".dae")
    unsupported({.file = path}, "meshes of the format \"" + ending + "\" are not read",
                "save it as .stl, .obj or .dae");
  std::string text = read_text(path, kMostBytes);
  if (ending == ".dae")
    check_xml(text, path);
  else
    leave_materials_out(text);
  return import_mesh(text, path, ending.c_str() + 1);
}

void warn_of_size(const Triangles& mesh, const std::string& file, double most,
                  std::vector<std::string>& warnings) {
  Eigen::AlignedBox3d box;
  for (const auto& triangle : mesh) {
    for (const Eigen::Vector3d& corner : triangle) box.extend(corner);
  }
  const double longest = mesh.empty() ? 0 : box.sizes().maxCoeff();
  if (longest <= most) return;
  warnings.push_back("the mesh " + file + " is " + number_text(std::round(10 * longest) / 10) +
                     " m long: if it is in millimetres, scale it by 0.001");
}

std::string mesh_path(const std::string& file, const std::string& name) {
  return (std::filesystem::path(file).parent_path() / name).string();
}

std::string mesh_path(const Error::Place& place, const std::string& name,
                      const std::map<std::string, std::string>& packages) {
  const auto scheme = name.find("://");
  if (scheme == std::string::npos) return mesh_path(place.file, name);
  const std::string rest = name.substr(scheme + 3);
  if (name.starts_with("file:")) return mesh_path(place.file, rest);
  if (!name.starts_with("package:")) {
    unsupported(place, "the mesh \"" + name + "\" cannot be found",
                "name it by its path, or by file:// or package://");
  }
  const auto slash = std::min(rest.find('/'), rest.size());
  const std::string package = rest.substr(0, slash);
  const auto known = packages.find(package);
  if (known == packages.end())
    unsupported(place, "the mesh \"" + name + "\" is in a package that is not known",
                "say where it is: --package " + package + "=FOLDER");
  return (std::filesystem::path(known->second) / rest.substr(std::min(slash + 1, rest.size())))
      .string();
}

}  // namespace lasius::arm
