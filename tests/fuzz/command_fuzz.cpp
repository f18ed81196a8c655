// Files that commands alone read, each by a whole command line on a small map: a letter and a line
// end choose the command, what follows is the file. Anything but an answer or a refusal is a fault.
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "lasius/base/error.h"
#include "tests/fuzz/reading.h"
#include "tools/command_line/cli.h"
#include "tools/console/exit_code.h"

namespace lasius::fuzz {
namespace {

struct Command {
  char letter;
  std::string file;  ///< what is written into it is tried
  std::vector<std::string> words;
};

const std::vector<std::string> kEnds = {"--start", "1,1", "--goal", "10,5", "--limit", "0.01"};

std::vector<std::string> with_ends(std::vector<std::string> words) {
  words.insert(words.end(), kEnds.begin(), kEnds.end());
  return words;
}

const std::vector<Command>& commands() {
  static const std::vector<Command> all = {
      {'a', "in.csv", {"check-path", "room.map", "in.csv"}},
      {'b', "in.csv", {"check-path", "room.map", "in.csv", "--radius", "0.4"}},
      {'c', "in.json", {"check-path", "room.map", "in.json"}},
      {'d', "in.yaml", {"check-path", "room.map", "in.yaml"}},
      {'e', "in.yaml", {"check-path", "room.map", "poses.csv", "--vehicle", "in.yaml"}},
      {'f', "in.csv", {"check-path", "room.map", "in.csv", "--vehicle", "car.yaml", "--strict"}},
      {'g', "in.json", {"tour", "room.map", "--stops", "in.json", "--limit", "0.01"}},
      {'h', "in.tsv", {"tour", "room.map", "--stops", "in.tsv", "--limit", "0.01"}},
      {'i', "in.tsp", {"tour", "in.tsp", "--limit", "0.01"}},
      {'j', "in.sop", {"tour", "in.sop", "--limit", "0.01"}},
      {'k', "in.proof.json", {"check-proof", "room.map", "in.proof.json", "--cost", "costs.pfm"}},
      {'l', "in.proof.cbor", {"check-proof", "room.map", "in.proof.cbor", "--cost", "costs.pfm"}},
      {'m', "in.layer", with_ends({"plan", "room.map", "--cost", "in.layer"})},
      {'n', "in.txt", with_ends({"drive", "room.map", "--changes", "in.txt"})},
      {'o', "in.yaml",
       with_ends({"plan", "room.map", "--algorithm", "acs", "--preset", "in.yaml"})},
      {'p', "in.json", {"merge", "in.json"}},
      {'q', "in.tsv", {"batch", "room.map", "in.tsv", "--vehicle", "car.yaml", "--limit", "0.01"}},
  };
  return all;
}

/// Where the files are, which end with the program.
struct Folder {
  Folder() {
    std::string name = (std::filesystem::temp_directory_path() / "lasius-fuzz-XXXXXX").string();
    require(::mkdtemp(name.data()) != nullptr);
    path = name + "/";
    write("room.map",
          "type octile\nheight 7\nwidth 12\nmap\n............\n............\n....@@......\n"
          "....@.......\n....@@......\n............\n............\n");
    write("car.yaml",
          "footprint: [[-0.2, -0.2], [0.4, -0.2], [0.4, 0.2], [-0.2, 0.2]]\n"
          "turning_radius: 1\n");
    std::string costs = "Pf\n12 7\n-1.0\n";
    for (int i = 0; i < 84; ++i) {
      const float value = static_cast<float>(1 + 7 * i % 5);
      costs.append(reinterpret_cast<const char*>(&value), sizeof value);
    }
    write("costs.pfm", costs);
    write("poses.csv", "x,y,yaw\n1.5,1.5,0\n9.5,1.5,0\n");
  }
  ~Folder() {
    std::error_code kept;
    std::filesystem::remove_all(path, kept);
  }
  void write(const std::string& file, std::string_view text) const {
    std::ofstream out(path + file, std::ios::binary);
    require((out << text).flush().good());
  }
  std::string path;
};

bool names_file(const std::string& word) {
  return std::isalpha(static_cast<unsigned char>(word[0])) != 0 && word.find('.') != word.npos;
}

}  // namespace

void check(const std::string& bytes) {
  static const Folder folder;
  if (bytes.size() < 2 || bytes[1] != '\n') return;
  const auto command = std::ranges::find(commands(), bytes[0], &Command::letter);
  if (command == commands().end()) return;
  folder.write(command->file, std::string_view(bytes).substr(2));
  std::vector<std::string> named = command->words;
  std::vector<const char*> words{"lasius"};
  for (std::string& word : named) {
    if (names_file(word)) word.insert(0, folder.path);
    words.push_back(word.c_str());
  }
  try {
    const int code = tool::run_command_line(static_cast<int>(words.size()), words.data());
    const bool judges = command->words[0].starts_with("check-");  // 1: it does not hold
    require(code >= 0 && code <= tool::kNoOutput && (code != tool::kInternal || judges));
  } catch (const tool::UsageError& error) {
    require(error.what()[0] != '\0');
  } catch (const Error& error) {
    require(!error.problem().empty() && !error.remedy().empty());
  }
}

}  // namespace lasius::fuzz
