#include "tools/manual/topics.h"

#include <initializer_list>
#include <string>

#include "tools/console/worlds.h"
#include "tools/manual/pages.h"

namespace lasius::tool {
namespace {

/// Sections one after another, the later ones below their headings.
Blocks sections(std::initializer_list<std::string_view> names) {
  Blocks blocks;
  for (const auto name : names) {
    if (name != *names.begin())
      blocks.push_back({Block::Kind::heading, std::string(name.substr(name.find('/') + 1)), {}, 1});
    append(blocks, document_section(name));
  }
  return blocks;
}

Blocks algorithms_topic() {
  Blocks blocks{{Block::Kind::paragraph,
                 "For `--algorithm`. Formulas and parameters of one: `lasius algorithms NAME`."}};
  for (const World& world : worlds()) {
    blocks.push_back({Block::Kind::heading, std::string("Algorithms ").append(world.plans), {}, 1});
    for (const Algorithm& a : world.algorithms)
      blocks.push_back({Block::Kind::item, std::string(a.summary) + ". " + std::string(a.source),
                        std::string(a.name)});
  }
  return blocks;
}

constexpr Topic kTopics[] = {
    {"algorithms", "who plans: names, what they are, sources", algorithms_topic, true},
    {"coordinates", "cells, metres, planes", [] { return sections({"program/Coordinates"}); },
     true},
    {"environment", "variables", [] { return sections({"program/Environment"}); }, true},
    {"exit-codes", "what the program returns", [] { return sections({"program/Exit codes"}); },
     true},
    {"files", "streams, and how files are written",
     [] { return sections({"program/Streams and files"}); }, true},
    {"json", "the fields of results",
     [] {
       return sections({"program/JSON of every result", "program/JSON of a plan", "program/Status",
                        "program/JSON of an arm's motion", "driving/JSON of a drive"});
     },
     true},
    {"maps", "bitmaps and tables of queries",
     [] {
       return sections({"worlds/Bitmaps", "worlds/What a path may do", "worlds/Queries"});
     },
     false},
    {"polygons", "polygon worlds", [] { return sections({"worlds/Polygon worlds"}); }, false},
    {"robots", "robots and scenes of arms", [] { return sections({"worlds/Robots and scenes"}); },
     false},
    {"studies", "studies of your own, and tuning",
     [] {
       return sections({"studies/Your own studies", "studies/Tuning"});
     },
     false},
    {"driving", "a robot in a world that changes",
     [] {
       return sections({"driving/Driving through a world that changes",
                        "driving/The file of changes", "driving/Text, table, picture, film, page"});
     },
     false},
};

}  // namespace

std::span<const Topic> topics() { return kTopics; }

}  // namespace lasius::tool
