#include "tools/manual/topics.h"

#include <string>

#include "tools/console/kinds.h"

namespace lasius::tool {
namespace {

Blocks algorithms_topic() {
  Blocks blocks{
      paragraph("For `--algorithm`. Formulas and parameters of one: `lasius algorithms NAME`.")};
  for (const ProblemKind* kind : kinds()) {
    if (kind->algorithms.empty()) continue;
    blocks.push_back({Block::Kind::heading, std::string("Algorithms ").append(kind->plans), {}, 1});
    for (const Algorithm& a : kind->algorithms)
      blocks.push_back({Block::Kind::item, std::string(a.summary) + ". " + std::string(a.source),
                        std::string(a.name)});
  }
  return blocks;
}

std::vector<Topic> make_topics() {
  std::vector<Topic> all{
      {"algorithms", "who plans: names, what they are, sources", algorithms_topic(), true}};
  for (const DocumentTopic& topic : document_topics()) {
    all.push_back({topic.name, topic.summary, {}, topic.in_man_page});
    for (const DocumentBlock& b : topic.blocks)
      all.back().blocks.push_back({b.kind, std::string(b.text), std::string(b.label), b.depth});
  }
  return all;
}

}  // namespace

const std::vector<Topic>& topics() {
  static const auto kTopics = make_topics();
  return kTopics;
}

}  // namespace lasius::tool
