#include "tools/yaml/document.h"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <limits>

#include "core/base/did_you_mean.h"
#include "core/base/output.h"
#include "core/base/text_lines.h"
#include "core/base/yaml_documents.h"
#include "lasius/base/error.h"
#include "tools/console/values.h"

namespace lasius::tool {
namespace {

constexpr std::size_t kLargestFile = 1 << 16;
constexpr std::size_t kMostNodes = 1 << 14;  // of a text of fewer bytes
constexpr int kDeepest = 100;
constexpr std::size_t kMostKeys = 2000;  // of one map: it is looked through

/// Of a key or a value in messages: files may hold anything.
std::string shown(const std::string& text) {
  constexpr std::size_t kMost = 60;
  std::string line = text.substr(0, kMost);
  std::ranges::replace_if(
      line, [](unsigned char c) { return c < 0x20 || c == 0x7f; }, ' ');
  return line;
}

std::string range_text(double low, double high) {
  if (high >= std::numeric_limits<double>::max()) return "at least " + to_text(low);
  return "from " + to_text(low) + " to " + to_text(high);
}

}  // namespace

/// Copies what yaml-cpp read: a tree of its own has no aliases, and a place for everything.
class DocumentReader {
 public:
  explicit DocumentReader(const std::string& file)
      : file_(std::make_shared<const std::string>(file)) {}

  Node read(const std::string& text) {
    Node root;
    root.file_ = file_;
    most_ = std::max(kMostNodes, text.size());
    try {
      if (const int documents = documents_in(text); documents != 1)
        root.fail(documents == 0 ? "the file is empty" : kMoreDocuments,
                  documents == 0 ? "give it its keys, or name another" : kOneDocument);
      const YAML::Node document = YAML::Load(text);
      root = node_of(document, "", document.Mark().line + 1);
    } catch (const YAML::Exception& error) {
      root.line_ = error.mark.is_null() ? 1 : error.mark.line + 1;
      root.fail("this is neither YAML nor JSON: " + error.msg, "correct it");
    }
    return root;
  }

 private:
  Node node_of(const YAML::Node& from, const std::string& key, std::int64_t line) {
    Node node;
    node.file_ = file_;
    node.key_ = key;
    node.line_ = line;
    if (++count_ > most_)
      node.fail("the document has too many values", "leave out aliases that repeat themselves");
    if (++depth_ > kDeepest) node.fail("nests too deep", "leave out aliases that hold themselves");
    if (from.IsScalar()) {
      node.kind_ = Node::Kind::text;
      node.text_ = from.Scalar();
    } else if (from.IsSequence()) {
      node.kind_ = Node::Kind::list;
      for (const auto& item : from) node.items_.push_back(node_of(item, key, item.Mark().line + 1));
    } else if (from.IsMap()) {
      node.kind_ = Node::Kind::map;
      for (const auto& entry : from) add_entry(node, entry.first, entry.second);
    }
    --depth_;
    return node;
  }

  void add_entry(Node& map, const YAML::Node& key, const YAML::Node& value) {
    if (!key.IsScalar()) map.fail("a key is a list or a map", "write KEY: VALUE");
    const std::string& name = key.Scalar();
    Node node = node_of(value, name, key.Mark().line + 1);
    if (map.find(name) != nullptr) node.fail("is given again", "leave one of the two out");
    if (map.entries_.size() >= kMostKeys)
      node.fail("is one key too many", "a map has at most " + std::to_string(kMostKeys));
    map.entries_.emplace_back(name, std::move(node));
  }

  std::shared_ptr<const std::string> file_;
  std::size_t count_ = 0, most_ = 0;
  int depth_ = 0;
};

void Node::fail(const std::string& problem, const std::string& remedy) const {
  const std::string named = key_.empty() ? problem : "'" + shown(key_) + "' " + problem;
  throw Error(ErrorCode::file_broken, {.file = *file_, .line = line_}, named, remedy);
}

std::span<const Node::Entry> Node::entries() const {
  if (kind_ == Kind::text || kind_ == Kind::list)
    fail("is no map of keys and values", "write it as KEY: VALUE");
  return entries_;
}

std::span<const Node> Node::items() const {
  if (kind_ == Kind::list) return items_;
  return {this, kind_ == Kind::nothing ? 0U : 1U};
}

const Node* Node::find(std::string_view name) const {
  const auto found = std::ranges::find(entries_, name, &Entry::first);
  return found == entries_.end() ? nullptr : &found->second;
}

const Node& Node::at(std::string_view name) const {
  (void)entries();
  if (const Node* const node = find(name)) return *node;
  const std::string missing = "'" + std::string(name) + "' is missing";
  fail(key_.empty() ? missing : "is incomplete: " + missing,
       "add a line " + std::string(name) + ":");
}

void Node::allow(std::span<const std::string_view> names) const {
  for (const auto& [name, value] : entries())
    if (std::ranges::find(names, name) == names.end())
      value.fail("is unknown here", did_you_mean(shown(name), names));
}

const std::string& Node::text() const {
  if (kind_ != Kind::text || text_.empty())
    fail("has no value, or more than one", "give it a value");
  if (text_.find('\0') != std::string::npos) fail("holds a zero byte", "leave it out");
  return text_;
}

std::string Node::joined() const {
  std::string all;
  for (const Node& item : items()) all.append(all.empty() ? "" : " ").append(item.text());
  return all;
}

std::vector<std::string> Node::texts() const {
  std::vector<std::string> all;
  for (const Node& item : items()) all.push_back(item.text());
  return all;
}

double Node::number(double low, double high) const {
  const auto value = parse_real(text());
  if (!value || *value < low || *value > high)
    fail("is \"" + shown(text_) + "\"", "it is a number, " + range_text(low, high));
  return *value;
}

std::int64_t Node::integer(std::int64_t low, std::int64_t high) const {
  const auto value = parse_integer(text());
  if (!value || *value < low || *value > high)
    fail(
        "is \"" + shown(text_) + "\"",
        "it is a whole number, " + range_text(static_cast<double>(low), static_cast<double>(high)));
  return *value;
}

bool Node::flag() const {
  static constexpr std::string_view kNames[] = {"true", "yes", "on", "false", "no", "off"};
  return choice(kNames) < 3;
}

std::size_t Node::choice(std::span<const std::string_view> names) const {
  const auto found = std::ranges::find(names, text());
  if (found == names.end()) fail("is \"" + shown(text_) + "\"", did_you_mean(shown(text_), names));
  return static_cast<std::size_t>(found - names.begin());
}

std::string Node::text_or(std::string_view name, const std::string& usual) const {
  const Node* const node = find(name);
  return node == nullptr ? usual : node->text();
}

std::string Node::joined_or_empty(std::string_view name) const {
  const Node* const node = find(name);
  return node == nullptr ? std::string() : node->joined();
}

double Node::number_or(std::string_view name, double usual, double low, double high) const {
  const Node* const node = find(name);
  return node == nullptr ? usual : node->number(low, high);
}

std::int64_t Node::integer_or(std::string_view name, std::int64_t usual, std::int64_t low,
                              std::int64_t high) const {
  const Node* const node = find(name);
  return node == nullptr ? usual : node->integer(low, high);
}

bool Node::flag_or(std::string_view name, bool usual) const {
  const Node* const node = find(name);
  return node == nullptr ? usual : node->flag();
}

Node parse_document(const std::string& text, const std::string& file) {
  std::string lines = text;
  end_lines_in_lf(lines);
  return DocumentReader(file).read(lines);
}

Node read_document(const std::string& file, FileKind kind) {
  return read_document(file, told(kind), kind);
}

Node read_document(const std::string& file, const std::string& expected, FileKind kind) {
  std::ifstream in(file, std::ios::binary);
  std::string text(kLargestFile + 1, '\0');
  in.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (in.bad() || (!in && in.gcount() == 0 && !in.eof()))
    throw Error(ErrorCode::file_missing, {.file = file}, "cannot be read", "check the name");
  text.resize(static_cast<std::size_t>(in.gcount()));
  refuse_other_kinds(text, file, {kind}, "give " + expected);
  if (text.size() > kLargestFile)
    throw Error(ErrorCode::file_broken, {.file = file, .line = 1}, "is larger than 64 kB",
                "give " + expected);
  return parse_document(text, file);
}

bool is_document(std::string_view file) {
  return has_ending(file, ".yaml") || has_ending(file, ".yml") || has_ending(file, ".json");
}

}  // namespace lasius::tool
