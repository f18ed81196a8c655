#include "tools/manual/topics.h"

#include <string>

#include "tools/console/worlds.h"
#include "tools/manual/pages.h"

namespace lasius::tool {
namespace {

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
    {"algorithms", "who plans: names, what they are, sources", {}, true},
    {"coordinates", "cells, metres, planes", {"program/Coordinates"}, true},
    {"environment", "variables", {"program/Environment"}, true},
    {"exit-codes", "what the program returns", {"program/Exit codes"}, true},
    {"files", "streams, and how files are written", {"program/Streams and files"}, true},
    {"json",
     "the fields of results",
     {"program/JSON of every result", "program/JSON of a plan", "program/Status",
      "program/JSON of an arm's motion", "driving/JSON of a drive"},
     true},
    {"maps",
     "bitmaps and tables of queries",
     {"worlds/Bitmaps", "worlds/What a path may do", "worlds/Queries"},
     false},
    {"polygons", "polygon worlds", {"worlds/Polygon worlds"}, false},
    {"robots", "robots and scenes of arms", {"worlds/Robots and scenes"}, false},
    {"studies",
     "studies of your own, and tuning",
     {"studies/Your own studies", "studies/Tuning"},
     false},
    {"driving",
     "a robot in a world that changes",
     {"driving/Driving through a world that changes", "driving/The file of changes",
      "driving/Text, table, picture, film, page"},
     false},
};

}  // namespace

Blocks Topic::blocks() const {
  if (sections.front().empty()) return algorithms_topic();
  Blocks blocks = document_section(sections.front());
  for (const auto section : std::span(sections).subspan(1)) {
    if (section.empty()) break;
    const auto heading = section.substr(section.find('/') + 1);
    blocks.push_back({Block::Kind::heading, std::string(heading), {}, 1});
    append(blocks, document_section(section));
  }
  return blocks;
}

std::span<const Topic> topics() { return kTopics; }

}  // namespace lasius::tool
