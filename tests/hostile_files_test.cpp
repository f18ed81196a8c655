// Every reader's memory is at most a constant times its file, whatever the file claims. Each case
// is read in a process of its own under a limit.
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <new>
#include <stdexcept>
#include <string>

#include "lasius/arm/robot.h"
#include "lasius/base/error.h"
#include "lasius/io.h"
#include "lasius/polygon/world.h"
#include "tests/core/base/made_files.h"
#include "tests/core/io/chunks.h"
#include "tools/record/queries.h"
#include "tools/study/run_file.h"
#include "tools/yaml/document.h"

namespace lasius {
namespace {

using namespace std::string_literals;

constexpr std::size_t kSpare = 24 << 20;  // bytes, whatever the file
constexpr std::size_t kTimes = 100;       // bytes for each byte of the file
constexpr std::size_t kLarge = 1 << 20;   // of a file whose every byte costs
#if defined(__SANITIZE_ADDRESS__)
constexpr bool kLimited = false;  // its own memory would count
#elif defined(__has_feature)
constexpr bool kLimited = !__has_feature(address_sanitizer);
#else
constexpr bool kLimited = true;
#endif

enum Exit { kRead, kRefused, kTooMuch };

const std::string kLinks =
    "<robot name='r'><link name='a'/><link name='b'><collision><geometry><sphere radius='1'/>"
    "</geometry></collision></link><joint type='continuous' name='j'><parent link='a'/>"
    "<child link='b'/><axis xyz='0 0 1'/></joint>";

using Read = std::function<void(const std::string& file)>;

/// In a process that is about to end: reads and says what came of it. `beyond` is what may be asked
/// for but not used, by libraries that go on where they get no memory.
[[noreturn]] void read_and_exit(const Read& read, const std::string& file, std::size_t size,
                                std::size_t beyond = 0) {
  const std::size_t allowed = kSpare + kTimes * size;
  std::size_t held = 0, resident = 0;  // pages
  std::ifstream("/proc/self/statm") >> held >> resident;
  const auto page = static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
  const rlim_t bytes = held * page + allowed + beyond;
  const rlimit limit{bytes, bytes};
  if (kLimited && ::setrlimit(RLIMIT_AS, &limit) != 0) std::perror("setrlimit");
  Exit code = kRead;
  try {
    read(file);
  } catch (const Error& error) {
    std::fputs(error.what(), stderr);
    code = kRefused;
  } catch (const std::bad_alloc&) {
    code = kTooMuch;
  }
  rusage usage{};
  ::getrusage(RUSAGE_SELF, &usage);
  const std::size_t peak = static_cast<std::size_t>(usage.ru_maxrss) << 10;
  if (kLimited && peak > resident * page + allowed) code = kTooMuch;
  std::_Exit(code);
}

void read_map_file(const std::string& file) { (void)read_any_map(file); }
void read_world_file(const std::string& file) { (void)polygon::read_world(file); }
void read_robot_file(const std::string& file) { (void)arm::read_robot(file); }
void read_scene_file(const std::string& file) { (void)arm::read_scene(file); }
void read_mesh_file(const std::string& file) { (void)arm::read_mesh(file); }
void read_srdf_file(const std::string& file) {
  (void)arm::parse_robot(kLinks + "</robot>", "r.urdf", {.tip = "b", .srdf = file});
}
void read_limits_file(const std::string& file) {
  (void)arm::parse_robot(kLinks + "</robot>", "r.urdf", {.tip = "b", .joint_limits = file});
}
void read_query_file(const std::string& file) { (void)tool::read_queries(file, 10, 6, true); }

std::string times(std::size_t count, const std::string& part) {
  std::string text;
  for (std::size_t i = 0; i < count; ++i) text += part;
  return text;
}
std::string filled(const std::string& before, const std::string& part, const std::string& after) {
  return before + times(kLarge / part.size(), part) + after;
}

constexpr std::size_t kBeyond = std::size_t{4} << 30;  // for libpng

class HostileFiles : public Files {
 protected:
  void expect_exit(int code, const Read& read, const std::string& name, const std::string& content,
                   const std::string& says) const {
    const std::string there = file(content, name);
    const std::size_t beyond = name.ends_with(".png") ? kBeyond : 0;
    EXPECT_EXIT(read_and_exit(read, there, content.size(), beyond), testing::ExitedWithCode(code),
                says)
        << name << ": " << content.substr(0, 60);
  }
  void refused(const Read& read, const std::string& name, const std::string& content,
               const std::string& says) const {
    expect_exit(kRefused, read, name, content, says);
  }
  void taken(const Read& read, const std::string& name, const std::string& content) const {
    expect_exit(kRead, read, name, content, "");
  }
};

TEST_F(HostileFiles, MapsThatClaimTheLargestSize) {
  const std::string says = "32768 x 32768 cells need at least";
  for (const char* content :
       {"type octile\nheight 32768\nwidth 32768\nmap\n....\n", "P1 32768 32768 0101",
        "P2 32768 32768 9 0 1 2", "P4 32768 32768 ....", "P5 32768 32768 65535 ...."}) {
    refused(read_map_file, "a.map", content, says);
  }
  std::string bmp =
      "BM" + std::string(8, '\0') + "\x36\0\0\0\x28\0\0\0\0\x80\0\0\0\x80\0\0\1\0\x20"s;
  refused(read_map_file, "a.bmp", bmp + std::string(80, '\0'), says);
  taken(read_map_file, "a.map", filled("P1 1024 1024 ", "0", ""));
}

/// The same from a pipe, whose size is not known.
TEST_F(HostileFiles, APipeThatClaimsTheLargestSize) {
  int ends[2];
  ASSERT_EQ(::pipe(ends), 0);
  const std::string content = "P4 32768 32768 ....";
  ASSERT_EQ(::write(ends[1], content.data(), content.size()), static_cast<ssize_t>(content.size()));
  ::close(ends[1]);
  EXPECT_EXIT(read_and_exit(read_map_file, "/proc/self/fd/" + std::to_string(ends[0]), 0),
              testing::ExitedWithCode(kRefused), "cells need at least");
  ::close(ends[0]);
}

TEST_F(HostileFiles, ImagesWhoseChunksClaimMoreThanIsThere) {
  const std::string head = kPngSignature + header_chunk(1, 1, 8, 0);
  const std::string pixels = chunk_of("IDAT", deflated("\0\xff"s)), end = chunk_of("IEND", "");
  taken(read_map_file, "a.png", head + pixels + end);
  const std::string huge = "\x7f\xff\xff\xff"s;
  for (const char* name : {"tEXt", "zTXt", "iTXt", "iCCP", "sPLT", "eXIf", "hIST", "tRNS", "PLTE",
                           "IDAT", "whAt", "wHAT"}) {
    // Of chunks that must be understood, libpng may refuse the length or the place first.
    const bool skipped = name[0] >= 'a' && name != "tRNS"s;
    const std::string says = skipped ? "the file ends too early" : "broken PNG";
    refused(read_map_file, "a.png", head + huge + name + "abc", says);
    refused(read_map_file, "a.png", head + pixels + huge + name + "abc", says);
  }
  refused(read_map_file, "a.png", kPngSignature + header_chunk(32768, 32768, 16, 6) + pixels + end,
          "32768 x 32768 cells need at least");
  // A text and a profile that grow a thousand times where they are unpacked are not.
  for (const char* name : {"zTXt", "iCCP"}) {
    const std::string bomb = chunk_of(name, "key\0\0"s + deflated(std::string(64 << 20, '\0')));
    taken(read_map_file, "a.png", head + bomb + pixels + end);
  }
}

TEST_F(HostileFiles, RosMaps) {
  std::string laughs =
      "image: a\nresolution: 1\norigin: [0, 0, 0]\na: &a [1, 1, 1, 1, 1, 1, 1, 1]\n";
  for (char c = 'b'; c <= 'z'; ++c) {
    const std::string before = ", *"s + static_cast<char>(c - 1);
    laughs += c + ": &"s + c + " [1" + times(8, before) + "]\n";
  }
  refused(read_map_file, "a.yaml", laughs, "'negate' is missing");
  refused(read_map_file, "a.yaml", "image: &a [*a]\n", "'image'");
  for (const char* part : {"[", "[{", "? ", "- ", "&a ", "{a: "}) {
    refused(read_map_file, "a.yaml", "image: " + times(20000 / std::string(part).size(), part), "");
  }
  refused(read_map_file, "a.yaml", "image: [" + times(30000, "1,") + "]", "'image'");
  refused(read_map_file, "a.yaml", filled("image: ", "x", ""), "larger than any");
}

TEST_F(HostileFiles, PolygonWorlds) {
  const std::string begin = R"({"type":"FeatureCollection","features":[)";
  for (const char* entry : {"[],", "{},", "0,", "\"\",", "{\"a\":0},", "[[[]]],"}) {
    refused(read_world_file, "a.geojson", filled(begin, entry, "0]}"), "feature 0");
  }
  refused(read_world_file, "a.geojson", filled("", "[", ""), "nests too deep");
  refused(read_world_file, "a.geojson",
          filled(R"({"type":"FeatureCollection","features":[{"properties":{"role":"boundary"},)"
                 R"("geometry":{"type":"Polygon","coordinates":[[)",
                 "[0,0],", "[0,0]]]}}]}"),
          "distinct points");
  refused(read_world_file, "a.wkt", filled("POLYGON ((", "0 0,", "0 0))"), "distinct points");
  refused(read_world_file, "a.wkt", filled("POLYGON((0 0,9 0,9 9,0 0)", ",(0 0,9 0,9 9,0 0)", ")"),
          "Self-intersection");
  refused(read_world_file, "a.wkt", filled("", "(", ""), "the name of a geometry");
  refused(read_world_file, "a.wkt", filled("", "GEOMETRYCOLLECTION(", ""), "nested too deep");
  refused(read_world_file, "a.wkt", filled("GEOMETRYCOLLECTION(", "POINT EMPTY,", "POINT(0 0))"),
          "is empty");
}

std::string joint(const std::string& name, const std::string& parent, const std::string& child) {
  return "<joint type='fixed' name='" + name + "'><parent link='" + parent + "'/><child link='" +
         child + "'/></joint>";
}

TEST_F(HostileFiles, Robots) {
  const std::string links = "<robot name='r'><link name='a'/><link name='b'/><link name='c'/>";
  refused(read_robot_file, "a.urdf", links + joint("j", "c", "c") + "</robot>", "to itself");
  refused(read_robot_file, "a.urdf",
          links + joint("j", "a", "b") + joint("k", "b", "a") + "</robot>", "in a loop");
  refused(read_robot_file, "a.urdf",
          links + joint("j", "a", "b") + joint("k", "c", "b") + "</robot>", "of two joints");
  refused([](const std::string& file) { (void)arm::read_robot(file, {.base = "", .tip = "c"}); },
          "a.urdf", links + joint("j", "a", "b") + joint("k", "c", "c") + "</robot>", "to itself");
  refused(read_robot_file, "a.urdf",
          "<robot name='r'>" + times(4000, "<link name='a'/>") + "</robot>", "not unique");
  std::string chain = "<robot name='r'><link name='0'/>";
  for (int i = 1; i < 5000; ++i) {
    const std::string name = std::to_string(i);
    chain += "<link name='" + name + "'/>" + joint(name, std::to_string(i - 1), name);
  }
  refused(read_robot_file, "a.urdf", chain + "</robot>", "too many links");
  for (const char* element : {"<a/>", "a<b/>", "<a b=''/>", "<!---->"}) {
    refused(read_robot_file, "a.urdf", filled("<robot name='r'>", element, "</robot>"), "no URDF");
  }
  for (const char* element : {"<a>", "<a b='/>'>", "</a><b>"}) {
    refused(read_robot_file, "a.urdf", filled("", element, ""),
            "nest too deep|no URDF|second document");
  }
  refused(read_robot_file, "a.urdf", filled("<robot ", "a='' ", "/>"), "too long");
  refused(read_robot_file, "a.json", filled(R"({"format":"lasius-arm/1","joints":[)", "[],", "0]}"),
          "entries");
}

TEST_F(HostileFiles, ScenesAndMeshes) {
  const std::string begin = R"({"format":"lasius-scene/1","obstacles":[)";
  refused(read_scene_file, "a.json", filled(begin, "{},", "{}]}"), "entries");
  refused(read_mesh_file, "a.stl", std::string(80, 'x') + "\xff\xff\xff\xff", "no STL");
  refused(read_mesh_file, "a.stl", "solid\n" + std::string(74, 'x') + "\xff\xff\xff\xff", "");
  taken(read_mesh_file, "a.stl",
        filled("solid s\n", "vertex 0 0 0\n" + times(2, "vertex 1 0 0\n"), "endsolid"));
  // A mesh that is named again and again: as many triangles as one mesh may have are read.
  constexpr std::uint32_t kTriangles = 100'000;
  file(std::string(80, 'x') + std::string(reinterpret_cast<const char*>(&kTriangles), 4) +
           std::string(50 * kTriangles, '\0'),
       "m.stl");
  const std::string mesh = R"({"shape":"mesh","file":"m.stl"},)";
  const std::string scene = file(begin + times(60, mesh) + "{}]}", "a.json");
  EXPECT_EXIT(read_and_exit(read_scene_file, scene, 100 * kTriangles),
              testing::ExitedWithCode(kRefused),
              "obstacles.54..file brings the scene's meshes to 5500000 triangles");
}

TEST_F(HostileFiles, MeshesOfOthers) {
  const std::string says = "no triangles|cannot be read|too long|nest too deep";
  for (const char* part : {"o a\n", "g a\n", "v 0 0 0\n", "vn 0 0 0\n", "vt 0 0\n", "usemtl a\n",
                           "mtllib a\n", "f 1 1 1\n", "f\n", "s 1\n", "l 1 1\n", "\\\n"}) {
    refused(read_mesh_file, "a.obj", filled("", part, ""), says);
  }
  taken(read_mesh_file, "a.obj", filled("v 0 0 0\nv 1 0 0\nv 0 1 0\n", "f 1 2 3\n", ""));
  const std::string begin = "<COLLADA version='1.4.1'><asset/>";
  for (const char* part :
       {"<a/>", "<a>b</a>", "<library_geometries/>", "<a b=''/>", "<!---->",
        "<library_visual_scenes><visual_scene/></library_visual_scenes>",
        "<library_geometries><geometry id='g'/></library_geometries>",
        "<library_nodes><node/></library_nodes>", "<library_images><image/></library_images>"}) {
    refused(read_mesh_file, "a.dae", filled(begin, part, "</COLLADA>"), says);
  }
  for (const char* part : {"<a>", "<a b='/>'>", "<node>"}) {
    refused(read_mesh_file, "a.dae", filled(begin, part, ""), says);
  }
  refused(read_mesh_file, "a.dae",
          begin +
              "<library_geometries><geometry id='g'><mesh><source id='p'><float_array id='a' "
              "count='2000000000'>0 0</float_array></source></mesh></geometry>"
              "</library_geometries></COLLADA>",
          says);
}

TEST_F(HostileFiles, WhatGoesWithARobot) {
  for (const char* part :
       {"<a/>", "<group_state name='s'/>", "<!---->", "<disable_collisions link1='a' link2='b'/>",
        "<disable_default_collisions link='b'/>"}) {
    taken(read_srdf_file, "a.srdf", filled("<robot name='r'>", part, "</robot>"));
  }
  refused(read_srdf_file, "a.srdf", filled("<robot>", "<a>", ""), "nest too deep");
  refused(read_limits_file, "a.yaml", filled("joint_limits: ", "[", ""), "larger|YAML");
  std::string aliases = "joint_limits: {}\na: &a [0,0,0,0,0,0,0,0,0]\n";
  for (char c = 'b'; c < 'm'; ++c) {
    aliases +=
        std::string(1, c) + ": &" + c + " [" + times(9, "*" + std::string(1, c - 1) + ",") + "]\n";
  }
  taken(read_limits_file, "a.yaml", aliases);
  refused(read_limits_file, "a.yaml", "joint_limits: " + times(30000, "["), "YAML|list of keys");
  refused(read_limits_file, "a.yaml", "joint_limits: " + times(15000, "{a: "), "YAML|list of keys");
}

TEST_F(HostileFiles, Queries) {
  refused(read_query_file, "q.tsv", filled("sx sy gx gy\n", "0 ", ""), "fields");
  refused(read_query_file, "q.tsv", filled("version 1\n", "0 ", ""), "fields");
  taken(read_query_file, "q.tsv", filled("sx sy gx gy\n", "0 0 1 1\n", ""));
  taken(read_query_file, "q.tsv", filled("sx sy gx gy\r", "0 0 1 1\r", ""));
}

TEST_F(HostileFiles, Results) {
  const auto read = [](const std::string& name) { (void)result_from_json(bytes_of(name)); };
  refused(read, "r.json", filled(R"({"status":"solved","path":[)", "[],", "0]}"), "path");
  refused(read, "r.json",
          filled(R"({"status":"solved","path":null,"iterations":1,"best":[)", "null,", "null]}"),
          "\"mean\"");
  std::string members = "{";
  for (int i = 0; i < 100'000; ++i) members += "\"" + std::to_string(i) + "\":0,";
  refused(read, "r.json", members + "\"status\":0}", "too many members");
}

TEST_F(HostileFiles, Documents) {
  const auto read = [](const std::string& name) { (void)tool::read_document(name, "a preset"); };
  const std::string large(1 << 16, 'x');
  refused(read, "d.yaml", "a: " + large, "larger than 64 kB");
  taken(read, "d.yaml", filled("[", "a,", "a]").substr(0, (1 << 16) - 3) + "a]");
  refused(read, "d.yaml", "a: &a [1" + times(999, ", 1") + "]\nb: [1" + times(99, ", *a") + "]\n",
          "too many values");
  refused(read, "d.yaml", filled("", "[", "").substr(0, 1 << 16), "YAML");
}

/// A run that a study has kept is dropped where its curve is longer than any.
TEST_F(HostileFiles, RunsOfStudies) {
  const study::Run run{.seed = 1, .best = {3, 2}, .mean = {3, 3}};
  study::write_run(path("run.json"), "key", run);
  const auto kept = study::read_run(path("run.json"), "key", 1);
  ASSERT_TRUE(kept.has_value());
  EXPECT_EQ(kept->best, run.best);
  const std::string text = bytes_of(path("run.json"));
  for (const auto& [from, to] : {std::pair{"\"best_size\":2", "\"best_size\":2000000"},
                                 {"\"best_size\":2", "\"best_size\":1"},
                                 {"[1,2.0]", "[-1,2.0]"}}) {
    std::string lying = text;
    ASSERT_NE(lying.find(from), lying.npos) << text;
    lying.replace(lying.find(from), std::string(from).size(), to);
    const auto read = [](const std::string& name) {
      if (study::read_run(name, "key", 1)) throw std::logic_error("was read");
    };
    taken(read, "lying.json", lying);
  }
}

}  // namespace
}  // namespace lasius
