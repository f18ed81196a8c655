// Files that commands alone read, each by a whole command line on a small map: a letter and a line
// end choose the command, what follows is the file. Anything but an answer or a refusal is a fault.
#include <unistd.h>

#include <cctype>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <sstream>
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

/// By their letters; what is tried is in the file in.*.
const std::map<char, std::string> kCommands = {
    {'a', "check-path room.map in.csv"},
    {'b', "check-path room.map in.csv --radius 0.4"},
    {'c', "check-path room.map in.json"},
    {'d', "check-path room.map in.yaml"},
    {'e', "check-path room.map poses.csv --vehicle in.yaml"},
    {'f', "check-path room.map in.csv --vehicle car.yaml --strict"},
    {'g', "tour room.map --stops in.json --limit 0.01"},
    {'h', "tour room.map --stops in.tsv --limit 0.01"},
    {'i', "tour in.tsp --limit 0.01"},
    {'j', "tour in.sop --limit 0.01"},
    {'k', "check-proof room.map in.proof.json --cost costs.pfm"},
    {'l', "check-proof room.map in.proof.cbor --cost costs.pfm"},
    {'m', "plan room.map --start 1,1 --goal 10,5 --limit 0.01 --cost in.layer"},
    {'n', "drive room.map --start 1,1 --goal 10,5 --limit 0.01 --changes in.txt"},
    {'o', "plan room.map --start 1,1 --goal 10,5 --limit 0.01 --algorithm acs --preset in.yaml"},
    {'p', "merge in.json"},
    {'q', "batch room.map in.tsv --vehicle car.yaml --limit 0.01"},
};

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
  const auto command = kCommands.find(bytes[0]);
  if (command == kCommands.end()) return;
  std::istringstream line("lasius " + command->second);
  std::vector<std::string> words{std::istream_iterator<std::string>(line), {}};
  std::vector<const char*> arguments;
  for (std::string& word : words) {
    if (word.starts_with("in.")) folder.write(word, std::string_view(bytes).substr(2));
    if (names_file(word)) word.insert(0, folder.path);
    arguments.push_back(word.c_str());
  }
  try {
    const int code = tool::run_command_line(static_cast<int>(arguments.size()), arguments.data());
    const bool judges = words[1].starts_with("check-");  // 1: it does not hold
    require(code >= 0 && code <= tool::kNoOutput && (code != tool::kInternal || judges));
  } catch (const tool::UsageError& error) {
    require(error.what()[0] != '\0');
  } catch (const Error& error) {
    require(!error.problem().empty() && !error.remedy().empty());
  }
}

}  // namespace lasius::fuzz
