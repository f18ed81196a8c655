#include <array>
#include <memory>
#include <optional>

#include "core/base/output.h"
#include "lasius/grid/generate.h"
#include "lasius/io.h"
#include "tools/command_line/search_options.h"
#include "tools/console/exit_code.h"
#include "tools/console/signals.h"
#include "tools/console/streams.h"
#include "tools/console/values.h"

namespace lasius::tool {

namespace {

constexpr std::array<std::string_view, 3> kMapOutputEndings{".map", ".pbm", ".png"};

struct GenerateCommand {
  MapKind kind{};
  GenerateOptions options;
  std::string output;
};

int make_map(const GenerateCommand& command) {
  check_outputs({command.output}, {});
  GenerateOptions options = command.options;
  const double most = max_density(command.kind);
  if (options.density > most) {
    options.density = most;
    message("--density is " + to_text(most) + ": this kind of map gets no denser");
  }
  const Grid map = generate(command.kind, options);
  std::optional<SignalWatcher> signals;
  if (is_stream(command.output)) signals.emplace();  // what is begun is written whole
  write_any_map(map, command.output);
  return signals && signals->interrupted() ? kInterrupted : kFound;
}

}  // namespace

Subcommand add_generate(CLI::App& app) {
  auto to = std::make_shared<GenerateCommand>();
  OptionTable table(app, "generate", "Make a map from a seed");
  table
      .choice("KIND", to->kind, map_kind_names(), "Kind of map",
              "blobs|maze|rooms|city|random|open")
      ->required();
  const auto size = [to](const auto& text) {
    const Cell cells = size_value("--size", text);
    to->options.width = cells.x;
    to->options.height = cells.y;
  };
  table.add("--size", "Width and height in cells", "WxH", size)->required();
  table.real("--density", to->options.density, 0, 1,
             "Share of blocked cells that is aimed at, from 0 to 1, or the most that the kind "
             "reaches; default: the kind's own",
             "D");
  add_seed(table, to->options.seed);
  const auto output = [to](const auto& file) {
    check_ending(file, kMapOutputEndings);
    to->output = file;
  };
  table
      .shell(table.add("-o,--output", "Map to write: .map, .pbm or .png", "FILE", output),
             {.files = true, .endings = texts(kMapOutputEndings)})
      ->required();
  return table.command({.examples = {{"lasius generate rooms --size 256x256 --seed 7 -o rooms.map",
                                      "the same map on every machine"}},
                        .exits = {kOutput}},
                       [to](const Call&) { return make_map(*to); });
}

}  // namespace lasius::tool
