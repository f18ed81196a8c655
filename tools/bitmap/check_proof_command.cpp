#include <memory>

#include "core/base/number_text.h"
#include "core/base/output.h"
#include "core/map_files/byte_reader.h"
#include "lasius/cost/proof.h"
#include "lasius/io/json.h"
#include "tools/bitmap/cost_layers.h"
#include "tools/bitmap/map_file.h"
#include "tools/command_line/map_options.h"
#include "tools/console/exit_code.h"
#include "tools/console/streams.h"
#include "tools/options/commands.h"

namespace lasius::tool {

Subcommand add_check_proof(CLI::App& app) {
  struct Asked {
    MapOptions map;
    std::string proof;
    Frame frame = Frame::cell;
    CostLayers costs;
  };
  auto asked = std::make_shared<Asked>();
  OptionTable table(app, "check-proof", "Check the proof of a bound of costs, without a search");
  table
      .file("MAP", asked->map.file, "The map: .map, PBM, PGM, PNG, BMP or ROS YAML",
            map_endings(false))
      ->required();
  table.file("PROOF", asked->proof, "The proof, as plan -o writes it", {".json", ".cbor"})
      ->required();
  add_cost_options(table, asked->costs);
  table.choice("--frame", asked->frame, kFrames, "The unit of --inflation, as of plan",
               "cell|world");
  table.flag("--unknown-free", asked->map.unknown_is_free,
             "Unknown cells of a ROS map count as free");
  return table.command(
      {.detail = "The format of proofs, and a script that checks them alike: docs/costs.md.",
       .examples = {{"lasius check-proof world.map world.proof.json --cost 'world.pfm*0.5' "
                     "--inflation 4,0.5,3",
                     "whether no path over these costs is cheaper than the proof's bound"}},
       .exits = {{kFound, "the proof holds"},
                 {kInternal, "it does not: its first fault is printed; internal error"},
                 {kBadFile, "map, proof or a layer is missing or broken"}}},
      [=](const Call&) {
        LoadedMap map = read_map(asked->map, asked->frame);
        const CostField costs = load_costs(*map.grid_alone, map.frame, asked->costs,
                                           asked->frame == Frame::world, map.radius)
                                    .field;
        const auto read = has_ending(asked->proof, ".cbor") ? proof_from_cbor : proof_from_json;
        const CostProof proof =
            read(read_text(asked->proof, std::int64_t{1000} * map.width * map.height + (1 << 20)),
                 asked->proof);
        if (const auto fault = check_proof(map.as_read(), costs, proof)) {
          print_verdict("does not hold: " + *fault + "\n");
          return static_cast<int>(kInternal);
        }
        print_verdict("holds: no path between the centres of cells " +
                      pair_text(proof.start.x, proof.start.y) + " and " +
                      pair_text(proof.goal.x, proof.goal.y) + " costs less than " +
                      to_text(proof.lower_bound) + "\n");
        return static_cast<int>(kFound);
      });
}

}  // namespace lasius::tool
