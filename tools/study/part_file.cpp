#include "tools/study/part_file.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string>

#include "lasius/base/error.h"
#include "lasius/version.h"
#include "tools/record/json_values.h"
#include "tools/study/files.h"

namespace lasius::study {
namespace {

namespace fs = std::filesystem;
using json::Json;

constexpr const char* kFormat = "lasius-study-part/1";

/// Of the study's file, where it has one.
std::string text_hash(const tool::StudyCommand& part) {
  const fs::path own = fs::path(part.folder) / kShortStudy;
  return tool::hash_text(tool::file_hash(part.name == "run" ? own.string() : part.name));
}

StudyPart read_part(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  const std::string text(std::istreambuf_iterator<char>(in), {});
  const auto broken = [&](const std::string& problem) {
    return Error(ErrorCode::file_broken, {.file = file.string()}, problem,
                 "run the part again by `lasius study ... --part I/N`");
  };
  try {
    const Json json = json::read(text, file.string());
    if (json.at("format") != kFormat) throw broken(std::string("is not of format ") + kFormat);
    if (json.at("version") != LASIUS_VERSION)
      throw Error(ErrorCode::file_unsupported, {.file = file.string()},
                  "is of version " + json.at("version").dump() + ", this is " LASIUS_VERSION,
                  "join the parts by the version that ran them");
    StudyPart part;
    tool::StudyCommand& command = part.command;
    command.name = json.at("study").get<std::string>();
    command.first_seed = json.at("first_seed").get<std::uint64_t>();
    command.seeds = json.at("seeds").get<int>();
    command.maps = json.at("maps").get<std::string>();
    part.hash = json.at("hash").get<std::string>();
    command.part.number = json.at("part").at("number").get<int>();
    command.part.of = json.at("part").at("of").get<int>();
    return part;
  } catch (const nlohmann::json::exception& fault) {
    throw broken(fault.what());
  }
}

}  // namespace

void write_part(const tool::StudyCommand& part) {
  const Json json = {
      {"format", kFormat},       {"version", LASIUS_VERSION},
      {"study", part.name},      {"first_seed", part.first_seed},
      {"seeds", part.seeds},     {"maps", part.maps},
      {"hash", text_hash(part)}, {"part", {{"number", part.part.number}, {"of", part.part.of}}}};
  const std::string name =
      "part-" + std::to_string(part.part.number) + "-of-" + std::to_string(part.part.of) + ".json";
  write_text(fs::path(part.folder) / name, json::line(json));
}

std::vector<StudyPart> read_parts(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with("part-") && name.ends_with(".json")) files.push_back(entry.path());
  }
  std::ranges::sort(files);
  if (files.empty())
    throw Error(ErrorCode::file_missing, {.file = folder.string()},
                "holds no part of a study whose runs are all there",
                "give folders that `lasius study ... --part I/N` has ended in");
  std::vector<StudyPart> parts;
  for (const fs::path& file : files) parts.push_back(read_part(file));
  return parts;
}

}  // namespace lasius::study
