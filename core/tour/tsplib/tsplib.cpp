#include "lasius/tour/tsplib.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <istream>
#include <limits>
#include <map>
#include <sstream>

#include "core/base/number_text.h"
#include "core/base/text_lines.h"
#include "core/tour/order/costs.h"
#include "core/tour/order/partial_order.h"
#include "kernels/base/arctangent.h"
#include "kernels/base/sine.h"
#include "lasius/base/error.h"

namespace lasius {

namespace {

using tour::Cost;
using tour::kLargest;

constexpr int kMostStops = 20'000;
constexpr const char* kTypes = "give EUC_2D, CEIL_2D, MAN_2D, MAX_2D, ATT, GEO or EXPLICIT";

double radians(double degrees_and_minutes) {
  constexpr double kPi = 3.141592;  // TSPLIB's own
  const double degrees = std::trunc(degrees_and_minutes);
  return kPi * (degrees + 5.0 * (degrees_and_minutes - degrees) / 3.0) / 180.0;
}

using Rule = double (*)(const Point&, const Point&);

double cosine(double x) { return kernels::sine_cosine(x).cosine; }

double geographic(const Point& a, const Point& b) {
  constexpr double kMost = 1e6;  // degrees; no place is so far
  for (const double degrees : {a.x, a.y, b.x, b.y})
    if (!(std::abs(degrees) < kMost)) return std::numeric_limits<double>::infinity();
  const double lat_a = radians(a.x), lat_b = radians(b.x);
  const double q1 = cosine(radians(a.y) - radians(b.y));
  const double q2 = cosine(lat_a - lat_b), q3 = cosine(lat_a + lat_b);
  const double c = 0.5 * ((1 + q1) * q2 - (1 - q1) * q3);
  return std::floor(6378.388 * kernels::arc_cosine(std::clamp(c, -1.0, 1.0)) + 1);
}

double straight(const Point& a, const Point& b) {
  const double dx = a.x - b.x, dy = a.y - b.y;
  return std::sqrt(dx * dx + dy * dy);
}

const std::map<std::string, Rule, std::less<>> kRules = {
    {"EUC_2D", [](const Point& a, const Point& b) { return std::floor(straight(a, b) + 0.5); }},
    {"CEIL_2D", [](const Point& a, const Point& b) { return std::ceil(straight(a, b)); }},
    {"MAN_2D",
     [](const Point& a, const Point& b) {
       return std::floor(std::abs(a.x - b.x) + std::abs(a.y - b.y) + 0.5);
     }},
    {"MAX_2D",
     [](const Point& a, const Point& b) {
       return std::max(std::floor(std::abs(a.x - b.x) + 0.5),
                       std::floor(std::abs(a.y - b.y) + 0.5));
     }},
    {"ATT",
     [](const Point& a, const Point& b) {
       const double dx = a.x - b.x, dy = a.y - b.y;
       return std::ceil(std::sqrt((dx * dx + dy * dy) / 10.0));
     }},
    {"GEO", geographic},
};

class Reader {
 public:
  Reader(std::istream& in, const std::string& name) : in_(in), file_(name) {}

  Tsplib read() {
    std::string line;
    while (next(line)) {
      if (line.empty()) continue;
      if (line == "EOF") break;
      const std::size_t colon = line.find(':');
      const std::string key(bare(std::string_view(line).substr(0, colon)));
      if (colon != std::string::npos) {
        head(key, std::string(bare(std::string_view(line).substr(colon + 1))));
      } else if (key == "NODE_COORD_SECTION" || key == "DISPLAY_DATA_SECTION") {
        coordinates(key == "NODE_COORD_SECTION");
      } else if (key == "EDGE_WEIGHT_SECTION") {
        weights();
      } else if (number_of<double>(key.substr(0, key.find_first_of(" \t")))) {
        too_many();
      } else {
        fail(ErrorCode::file_unsupported, "'" + key + "' is not read",
             "give a symmetric problem (TSP) or one of sequential ordering (SOP)");
      }
    }
    if (line_ == 0) line_ = 1;
    need_size();
    if (result_.matrix.empty()) by_rule();
    if (result_.ordered) check_circle();
    return std::move(result_);
  }

 private:
  [[noreturn]] void fail(ErrorCode code, const std::string& problem,
                         const std::string& remedy) const {
    fail_at(line_, code, problem, remedy);
  }
  [[noreturn]] void fail_at(std::int64_t line, ErrorCode code, const std::string& problem,
                            const std::string& remedy) const {
    throw Error(code, {file_, line}, problem, remedy);
  }
  std::string dimension() const { return "DIMENSION, " + number_text(result_.size); }
  [[noreturn]] void too_many() const {
    fail(ErrorCode::file_broken, "there are more data than " + dimension() + ", asks for",
         "correct DIMENSION, or leave the rest out");
  }
  static std::string_view bare(std::string_view text) { return trimmed(text, " \t\r"); }
  bool next(std::string& line) {
    if (!std::getline(in_, line)) return false;
    ++line_;
    line = std::string(bare(line));
    return true;
  }
  void head(const std::string& key, const std::string& value) {
    if (key == "NAME") result_.name = value;
    if (key == "TYPE") {
      result_.ordered = value.starts_with("SOP");
      if (!value.starts_with("TSP") && !result_.ordered)
        fail(ErrorCode::file_unsupported, "TYPE " + value + " is not read", "give a TSP or a SOP");
    }
    if (key == "EDGE_WEIGHT_TYPE") {
      if (value != "EXPLICIT" && !kRules.contains(value))
        fail(ErrorCode::file_unsupported, "EDGE_WEIGHT_TYPE '" + value + "' is not read", kTypes);
      rule_ = value;
    }
    if (key == "EDGE_WEIGHT_FORMAT") {
      format_ = value;
      format_line_ = line_;
    }
    if (key != "DIMENSION") return;
    if (result_.size > 0)
      fail(ErrorCode::file_broken, "DIMENSION is given again", "leave one of the two out");
    const auto size = number_of<int>(value);
    if (!size || *size < 1 || *size > kMostStops)
      fail(ErrorCode::file_broken, "DIMENSION is '" + value + "'", "give 1 to 20000 stops");
    result_.size = *size;
  }
  void need_size() const {
    if (result_.size == 0)
      fail(ErrorCode::file_broken, "there is no DIMENSION up to here",
           "tell the number of stops before their data");
  }
  // What a section lacks, at its end.
  [[noreturn]] void too_few() const {
    fail(ErrorCode::file_broken,
         "the data end before there are as many as " + dimension() + ", asks for",
         "correct DIMENSION, or add what is missing");
  }
  double number() {
    std::string word;
    while (!(words_ >> word)) {
      std::string line;
      if (!next(line) || line == "EOF" || line.ends_with("_SECTION")) too_few();
      words_ = std::istringstream(line);
    }
    if (word.starts_with('+')) word.erase(0, 1);
    const auto value = number_of<double>(word);
    if (!value || !std::isfinite(*value))
      fail(ErrorCode::file_broken, "'" + word + "' is not a number", "give numbers here");
    return *value;
  }
  // A section's numbers begin and end with lines.
  void end_of_line() {
    std::string word;
    if (words_ >> word) too_many();
  }
  // Nodes 1 to DIMENSION, each once, a line each, in any order. Without costs, for pictures: where
  // there are no others.
  void coordinates(bool with_costs) {
    need_size();
    const int n = result_.size;
    std::vector<Point> places(n);
    std::vector<std::int64_t> lines(n);  // 0: not given
    std::string line;
    for (int left = n; left > 0;) {
      const bool more = next(line);
      if (more && line.empty()) continue;
      if (!more || line == "EOF" || line.ends_with("_SECTION")) {
        const auto missing = std::find(lines.begin(), lines.end(), 0);
        fail(ErrorCode::file_broken,
             "node " + number_text(missing - lines.begin() + 1) + " is missing of " + dimension(),
             "add its coordinates, or correct DIMENSION");
      }
      const auto fields = words_of(line, " \t");
      if (fields.size() != 3)
        fail(ErrorCode::file_broken,
             "a node has " + number_text(fields.size()) + " numbers in place of 3",
             "give its own number, x and y");
      words_ = std::istringstream(line);
      const double node = number();
      if (!(node >= 1 && node <= n) || node != std::floor(node))
        fail(ErrorCode::file_broken,
             "node " + number_text(node) + " is none of 1 to " + dimension(),
             "number the nodes from 1, or correct DIMENSION");
      const auto i = static_cast<std::size_t>(node) - 1;
      if (lines[i] > 0)
        fail(
            ErrorCode::file_broken,
            "node " + number_text(node) + " is given again, first on line " + number_text(lines[i]),
            "give each node its own number");
      lines[i] = line_;
      places[i].x = number();
      places[i].y = number();
      --left;
    }
    if (!with_costs && !node_lines_.empty()) return;
    result_.places = std::move(places);
    if (with_costs) node_lines_ = std::move(lines);
  }
  Cost cost(double value) const {
    const double least = result_.ordered ? -1 : 0;
    if (value != std::floor(value) || value < least || value > kLargest)
      fail(ErrorCode::file_broken, "the cost " + number_text(value) + " is out of range",
           "give whole numbers from 0 to 500000000");
    return static_cast<Cost>(value);
  }
  void weights() {
    need_size();
    const int n = result_.size;
    const auto row = [&](int a, int from, int to) {
      for (int b = from; b < to; ++b) {
        const Cost value = cost(number());
        result_.matrix[static_cast<std::size_t>(a) * n + b] = value;
        if (format_ != "FULL_MATRIX") result_.matrix[static_cast<std::size_t>(b) * n + a] = value;
      }
    };
    if (result_.ordered) {
      if (number() != n)
        fail(ErrorCode::file_broken, "the matrix has another size than " + dimension(),
             "tell the same size before it");
      format_ = "FULL_MATRIX";
    }
    result_.matrix.assign(static_cast<std::size_t>(n) * n, 0);
    for (int a = 0; a < n; ++a) {
      if (format_ == "FULL_MATRIX")
        row(a, 0, n);
      else if (format_ == "UPPER_ROW" || format_ == "LOWER_COL")
        row(a, a + 1, n);
      else if (format_ == "UPPER_DIAG_ROW" || format_ == "LOWER_DIAG_COL")
        row(a, a, n);
      else if (format_ == "LOWER_ROW" || format_ == "UPPER_COL")
        row(a, 0, a);
      else if (format_ == "LOWER_DIAG_ROW" || format_ == "UPPER_DIAG_COL")
        row(a, 0, a + 1);
      else
        fail_at(format_line_ > 0 ? format_line_ : line_, ErrorCode::file_unsupported,
                "EDGE_WEIGHT_FORMAT '" + format_ + "' is not read",
                "give a matrix, full or one half of it");
    }
    end_of_line();
    if (format_ != "FULL_MATRIX" || result_.ordered) return;
    for (int a = 0; a < n; ++a)
      for (int b = 0; b < a; ++b)
        if (result_.matrix[static_cast<std::size_t>(a) * n + b] !=
            result_.matrix[static_cast<std::size_t>(b) * n + a])
          fail(ErrorCode::file_unsupported, "the matrix is not symmetric",
               "give a symmetric problem");
  }
  void by_rule() {
    need_size();
    if (rule_.empty()) fail(ErrorCode::file_broken, "there is no EDGE_WEIGHT_TYPE", kTypes);
    if (rule_ == "EXPLICIT" || result_.ordered)
      fail(ErrorCode::file_broken, "there is no EDGE_WEIGHT_SECTION", "give the matrix");
    if (node_lines_.empty())
      fail(ErrorCode::file_broken, "there are no coordinates", "give a NODE_COORD_SECTION");
    const auto rule = kRules.find(rule_);
    const int n = result_.size;
    result_.matrix.assign(static_cast<std::size_t>(n) * n, 0);
    for (int a = 0; a < n; ++a)
      for (int b = 0; b < n; ++b) {
        const double value = a == b ? 0 : rule->second(result_.places[a], result_.places[b]);
        if (!(value >= 0 && value <= kLargest))
          fail_at(node_lines_[b], ErrorCode::file_broken,
                  "from node " + number_text(a + 1) + " to node " + number_text(b + 1) + " it is " +
                      number_text(value),
                  "give coordinates that are at most 500000000 apart");
        result_.matrix[static_cast<std::size_t>(a) * n + b] = static_cast<Cost>(value);
      }
  }
  void check_circle() const {
    const int n = result_.size;
    std::vector<tour::Before> relation;
    for (int a = 0; a < n; ++a)
      for (int b = 0; b < n; ++b)
        if (a != b && result_.matrix[static_cast<std::size_t>(a) * n + b] < 0)
          relation.emplace_back(b, a);
    const std::vector<int> circle = tour::circle_of(n, relation);
    if (circle.empty()) return;
    std::string text = "the order is a circle: ";
    for (const int node : circle) text += "node " + number_text(node + 1) + " before ";
    fail(ErrorCode::file_broken, text + "node " + number_text(circle.front() + 1),
         "give one of these a cost in place of -1");
  }

  std::istream& in_;
  std::string file_;
  std::int64_t line_ = 0;
  std::istringstream words_;
  std::string rule_, format_;
  std::int64_t format_line_ = 0;
  std::vector<std::int64_t> node_lines_;  // of coordinates with costs
  Tsplib result_;
};

}  // namespace

Tsplib read_tsplib(std::istream& in, const std::string& name) { return Reader(in, name).read(); }

}  // namespace lasius
