#include "tools/command_line/map_options.h"

#include <algorithm>

#include "tools/console/kinds.h"
#include "tools/console/parameters.h"
#include "tools/record/outputs.h"
#include "tools/yaml/document.h"

namespace lasius::tool {
namespace {

constexpr const char* kPrepare =
    "Make the map's visibility graph for exact (at most 1 GB), or with labels hub labels of its "
    "vertices as well, of which answers are read: worth it for many queries (alone: graph). "
    "Answers are as short as without; lasius info MAP --prepare shows what it costs";
constexpr std::string_view kPreparations[] = {"graph", "labels"};

}  // namespace

void add_prepare(OptionTable& table, MapOptions& to, const char* help) {
  table.add("--prepare", help, "graph|labels", [&to](const std::string& text) {
    to.prepare = true;
    to.labels = choice_value("--prepare", text, kPreparations) == 1;
  });
}

void add_cost_options(OptionTable& table, CostLayers& to) {
  table.repeatable(
      "--cost",
      "A layer of costs of the map's size: PNG or PGM (grey / largest grey), PFM, .npy "
      "(the value itself, at least 0), or a ROS map's .yaml where that places it (occupancy / "
      "100; 100 blocks the cell). Times the factor (default 1) it is added to the "
      "weight 1 of each cell (repeatable)",
      "FILE[*FACTOR]", [&to](const std::string& text) {
        const auto star = text.rfind('*');
        CostLayers::Layer layer{.file = text.substr(0, star)};
        if (layer.file.empty())
          throw UsageError("--cost " + text + " names no file; as in terrain.pgm*2");
        if (star != text.npos)
          layer.factor = real_value("--cost", text.substr(star + 1), 0, CostField::kMost);
        to.layers.push_back(std::move(layer));
      });
  table.add(
      "--inflation",
      "Costs near what is blocked, as Nav2 has them: WEIGHT (default 2) times "
      "exp(-SCALING (d - r)) up to the distance d = RADIUS, r: --radius, at least 1 cell; in cells "
      "(metres and per metre with --frame world)",
      "RADIUS,SCALING[,WEIGHT]", [&to](const std::string& text) {
        const auto numbers = reals_value("--inflation", text, 2, 3);
        to.inflation = {numbers[0], numbers[1], numbers.size() > 2 ? numbers[2] : 2};
      });
}

void add_run_options(OptionTable& table, RunOptions& to, const SearchHelp& help) {
  add_search_options(table, to, help);
  add_parameter(table, "--neighbours", to, "Moves from a cell", "4|8|16|16k|24|32");
  add_parameter(table, "--corners", to, "Diagonal steps past blocked cells",
                "forbid|one-side|allow");
  add_preset(table, to,
             "Numbers to start with: usual, or the textbook's of algorithms that have them (see "
             "lasius algorithms), or a file's, as tune writes it");
  add_parameter(table, "--polish", to, "What is done with a path", "none|straight|taut|local");
  table.choice("--frame", to.frame, kFrames,
               "Coordinates in cells, or in metres of a ROS map's frame; a cell holds its left and "
               "lower edge there",
               "cell|world");
  table.real(
      "--radius", to.map.radius, 0, kNoLimit,
      "The robot is a disc: its centre keeps R cells (metres with --frame world) from what is "
      "blocked and from the map's edge. exact passes whatever such a disc can, R from 0.05 to 54 "
      "cells; other algorithms plan on cells whose centres keep R, by moves that keep it. plan "
      "and batch lead a start that is free, but nearer than that, out first",
      "R");
  table.real(
      "--goal-tolerance", to.goal_tolerance, 0, kNoLimit,
      "Where the goal cannot be reached, end at the free cell nearest to it that can be (with "
      "--radius exact ends at the nearest point), at most R away; R in cells "
      "(metres with --frame world)",
      "R");
  table.flag("--unknown-free", to.map.unknown_is_free, "Unknown cells of a ROS map count as free");
  add_prepare(table, to.map, kPrepare);
  table.file("--prepared", to.map.prepared,
             "Read what --prepare makes from this file, or where it is not there make it and write "
             "it (with labels, unless --prepare graph); refused where it is not of this map",
             {});
  table.flag("--gap", to.with_optimum,
             "Add the exact optimum, the true gap, and the optimum of the algorithm's own moves; "
             "null where a time limit or a signal ended the search for it, or where --corners "
             "allow lets moves squeeze through where no path of the plane may");
}

/// What is left to do once all options of a run on a bitmap are read.
void finish_run(RunOptions& run) {
  finish_search(run);
  run.params = make_params<Params>(run, bitmaps());
  const std::string& algorithm = run.params.algorithm();
  const bool certifies = !moves_on_cells(run.params);
  MapOptions& map = run.map;
  run.inputs = {map.file, run.preset_file};
  map.radius_metres = run.frame == Frame::world;
  const auto note = [&](const std::string& text) { run.notes.push_back(text); };
  if (map.unknown_is_free && !is_document(map.file))
    note("--unknown-free has no effect: only ROS maps (.yaml) have unknown cells");
  if (run.target_gap > 0 && !certifies)
    note("--target-gap has no effect: " + algorithm + " certifies no gap");
  if (!map.prepared.empty()) {
    if (map.radius > 0)
      throw UsageError("--prepared is for a point; leave --radius out, or prepare without a file");
    if (!map.prepare) map.prepare = map.labels = true;
    run.inputs.push_back(map.prepared);
  }
  if (map.prepare && !run.with_optimum && !certifies) {
    const char* const name = map.prepared.empty() ? "--prepare" : "--prepared";
    map.prepare = map.labels = false;
    map.prepared.clear();
    note(std::string(name) + " has no effect: it is for exact, and for --gap");
  }
  if (map.labels && map.radius > 0) {
    map.labels = false;
    note("--prepare labels has the effect of graph: labels are for a point; leave --radius out");
  }
  if (run.track_iterations.empty()) return;
  if (find_algorithm(algorithm).kind != Algorithm::Kind::colony)
    note("--tracks has no effect: " + algorithm + " has no ants");
  else if (std::ranges::none_of(run.outputs, is_picture))
    note("--tracks has no effect without -o of a picture, .svg or .png");
}

PlanCommand plan_command(RunOptions& run, const std::string& start, const std::string& goal) {
  require("", "--start", start);
  require("", "--goal", goal);
  finish_run(run);
  return {run, point_value("--start", start, run.frame), point_value("--goal", goal, run.frame)};
}

void add_world_options(OptionTable& table, WorldOptions& to) {
  table.real("--margin", to.margin, 0, WorldOptions::kMostMargin,
             "Polygon worlds: the robot is a disc: its centre keeps R (the world's unit) from "
             "obstacles and from the boundary, in place of the file's margin",
             "R");
  table.choice(
      "--join", to.join, kJoins,
      "Polygon worlds: corners of grown obstacles (default round, the margin and at most 0.5% "
      "more; mitre reaches farther and may close passages, bevel keeps less, chords 99.5%)",
      "round|mitre|bevel|chords");
  table.choice(
      "--boundary", to.boundary, kBoundaries,
      "Polygon worlds: whether the robot keeps the margin from the boundary, too (default shrink)",
      "shrink|keep");
  table.flag("--repair", to.repair, "Polygon worlds: repair geometry that is not valid");
}

void refuse_world_options(const OptionTable& table) {
  table.refuse({"--margin", "--join", "--boundary", "--repair"},
               " is for polygon worlds (.geojson, .json, .wkt); the robot's radius is --radius on "
               "bitmaps");
}

void refuse_radius(const OptionTable& table) {
  table.refuse({"--radius"}, " is for bitmaps; the robot's radius is --margin on polygon worlds");
}

}  // namespace lasius::tool
