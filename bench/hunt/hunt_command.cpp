// lasius_bench hunt: random problems for hours, each answer judged; goes on where it was ended.
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cinttypes>
#include <csignal>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "bench/clocks.h"
#include "bench/commands.h"
#include "bench/hunt/hunt.h"
#include "core/base/output.h"
#include "lasius/base/error.h"

namespace lasius::bench {
namespace {

struct HuntOptions {
  std::vector<std::string> kinds;
  double answers = 1e6;
  double seconds = 1e9;
  std::uint64_t seed = 1;
  std::string state;
};

// What is judged just now, for whoever finds the program dead.
std::array<char, 64> at_work{};

void tell_at_work(int signal) {
  [[maybe_unused]] const auto written = write(STDERR_FILENO, at_work.data(), at_work.size());
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

// What throws is wrong, too.
HuntVerdict judged(const HuntKind& kind, const HuntCase& problem) {
  try {
    return kind.judge(problem);
  } catch (const std::exception& error) {
    return {.answers = 1, .fault = std::string("throws: ") + error.what()};
  }
}

// How far a hunt has come with a kind.
struct Bag {
  std::uint64_t problems = 0;
  std::int64_t answers = 0, wrong = 0;
  double seconds = 0;
};

// Of problem i of a kind: other numbers for every seed of the hunt (splitmix64).
std::uint64_t problem_seed(std::uint64_t seed, std::uint64_t i) {
  std::uint64_t z = seed * 0x9e3779b97f4a7c15u + i * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return z ^ (z >> 31);
}

class Hunt {
 public:
  explicit Hunt(const HuntOptions& options) : options_(options) {
    for (const HuntKind& kind : hunt_kinds()) {
      if (options.kinds.empty() ||
          std::ranges::find(options.kinds, kind.name) != options.kinds.end())
        kinds_.push_back(&kind);
    }
    if (!options.state.empty()) read_state();
  }

  /// Answers that were wrong.
  std::int64_t run() {
    const Stopwatch watch;
    double saved = 0;
    while (sum(&Bag::answers) < static_cast<std::int64_t>(options_.answers) &&
           watch.seconds() < options_.seconds && sum(&Bag::wrong) < kMostFaults) {
      // As much time for each kind.
      const HuntKind* next = kinds_.front();
      for (const HuntKind* kind : kinds_)
        if (bags_[kind->name].seconds < bags_[next->name].seconds) next = kind;
      one(*next);
      if (!options_.state.empty() && watch.seconds() > saved + 5) {
        write_state();
        saved = watch.seconds();
      }
    }
    if (!options_.state.empty()) write_state();
    return sum(&Bag::wrong);
  }

  void print() const {
    std::cout << "seed " << options_.seed << "\n\nkind        problems     answers  wrong\n";
    for (const HuntKind* kind : kinds_) {
      const Bag& bag = bags_.at(kind->name);
      std::cout << kind->name << std::string(9 - kind->name.size(), ' ');
      for (const auto& [value, width] : {std::pair{static_cast<std::int64_t>(bag.problems), 11},
                                         {bag.answers, 12},
                                         {bag.wrong, 7}}) {
        const std::string text = std::to_string(value);
        std::cout << std::string(static_cast<std::size_t>(width) - text.size(), ' ') << text;
      }
      std::cout << '\n';
    }
  }

 private:
  static constexpr std::int64_t kMostFaults = 10;  // then it ends

  template <class T>
  std::int64_t sum(T Bag::*part) const {
    std::int64_t all = 0;
    for (const auto& [name, bag] : bags_) all += bag.*part;
    return all;
  }

  void one(const HuntKind& kind) {
    Bag& bag = bags_[kind.name];
    const ThreadStopwatch watch;
    const std::uint64_t seed = problem_seed(options_.seed, bag.problems++);
    std::snprintf(at_work.data(), at_work.size(), "died at %s %" PRIu64 "\n", kind.name.data(),
                  seed);
    const HuntCase problem = kind.make(seed);
    const HuntVerdict verdict = judged(kind, problem);
    bag.answers += verdict.answers;
    bag.seconds += watch.seconds();
    if (verdict.fault.empty()) return;
    ++bag.wrong;
    std::cout << kind.name << ": " << verdict.fault
              << "\nas a test of tests/bench/hunt/hunt_test.cpp:\n\n"
              << as_test(kind, reduced(problem,
                                       [&](const HuntCase& smaller) {
                                         return !judged(kind, smaller).fault.empty();
                                       }))
              << std::endl;
  }

  void read_state() {
    std::ifstream in(options_.state);
    if (!in) return;  // it begins
    try {
      const auto state = nlohmann::json::parse(in);
      if (state.at("seed") != options_.seed)
        throw Error(ErrorCode::invalid_parameter, {options_.state},
                    "holds another hunt's seed, " + state.at("seed").dump(),
                    "give that one, or another file");
      for (const auto& [name, bag] : state.at("kinds").items())
        bags_[hunt_kind(name).name] = {bag.at("problems"), bag.at("answers"), bag.at("wrong"),
                                       bag.at("seconds")};
    } catch (const nlohmann::json::exception&) {
      throw Error(ErrorCode::file_broken, {options_.state}, "is no hunt's state",
                  "give another file");
    }
  }

  void write_state() const {
    nlohmann::json kinds;
    for (const auto& [name, bag] : bags_)
      kinds[std::string(name)] = {{"problems", bag.problems},
                                  {"answers", bag.answers},
                                  {"wrong", bag.wrong},
                                  {"seconds", bag.seconds}};
    write_file(options_.state, [&](std::ostream& out) {
      out << nlohmann::json{{"seed", options_.seed}, {"kinds", kinds}}.dump(2) << '\n';
    });
  }

  const HuntOptions& options_;
  std::vector<const HuntKind*> kinds_;
  std::map<std::string_view, Bag> bags_;
};

void run_hunt(const HuntOptions& options) {
  for (const int signal : {SIGSEGV, SIGABRT, SIGBUS, SIGFPE, SIGILL})
    std::signal(signal, tell_at_work);
  Hunt hunt(options);
  const std::int64_t wrong = hunt.run();
  hunt.print();
  if (wrong > 0) throw CLI::RuntimeError(1);
}

}  // namespace

void add_hunt_command(CLI::App& app) {
  auto [command, options] = add_command<HuntOptions>(
      app, "hunt", "Answers to random problems by the million, judged", run_hunt);
  std::vector<std::string> names;
  for (const HuntKind& kind : hunt_kinds()) names.emplace_back(kind.name);
  command.add_option("--kinds", options.kinds, "Of problems; default: all")
      ->delimiter(',')
      ->check(CLI::IsMember(names));
  add_number(command, "--answers", options.answers, "Ends after so many", 1, 1e15);
  add_number(command, "--seconds", options.seconds, "Or so long");
  add_number(command, "--seed", options.seed, "Another one, other problems", 0, 1e15);
  command.add_option("--state", options.state,
                     "A file that keeps how far it has come: goes on there");
}

}  // namespace lasius::bench
