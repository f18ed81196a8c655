// Parameters by name: one table says how those of a component are read, written and checked.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "core/base/did_you_mean.h"
#include "core/base/invalid_parameter.h"
#include "core/base/number_text.h"
#include "lasius/params/params.h"

namespace lasius {

/// What a colony keeps of its pheromone, and the other word for it.
inline constexpr std::string_view kPersistence = "persistence", kEvaporation = "evaporation";

/// Less than this a colony could lose among its smallest numbers.
inline constexpr double kLeastPheromone = 1e-12;

/// @throws Error(invalid_parameter) unless a request's target gap is from 0 up, or infinite.
inline void check_target_gap(double gap) {
  require_parameter(gap >= 0, "target_gap", gap, "it is a fraction: 0 or more, 0.01 for 1%");
}

/// @throws Error(invalid_parameter) unless a request's goal tolerance is a number from 0 up.
inline void check_goal_tolerance(double tolerance) {
  require_parameter(tolerance >= 0, "goal_tolerance", tolerance, "it must be 0 or more");
}

/// @throws Error(invalid_parameter) for a gap that the algorithm cannot certify.
inline void check_certifies(const Algorithm& algorithm, double target_gap) {
  check_target_gap(target_gap);
  if (target_gap == 0 || algorithm.kind == Algorithm::Kind::exact) return;
  refuse("target_gap is " + number_text(target_gap) + ", but " + std::string(algorithm.name) +
             " certifies no gap",
         "leave it 0, or ask exact");
}

/// @throws Error(invalid_parameter) unless it is a number of threads that may be asked for.
inline void check_threads(int threads) {
  require_parameter(threads >= 0 && threads <= 1024, "threads", threads,
                    "it must be 0 (all cores) to 1024");
}

/// @throws Error(invalid_parameter) for a seed that JSON does not keep exactly.
inline void check_seed(std::uint64_t seed) {
  constexpr std::uint64_t kMostSeed = (std::uint64_t{1} << 53) - 1;
  require_parameter(seed <= kMostSeed, "seed", seed, "it must be at most 2^53 - 1");
}

/// For a name that is none of `known`, the names of the things that `kind` says.
inline Error unknown_name(std::string_view kind, std::string_view name,
                          std::span<const std::string_view> known) {
  return invalid_parameter("unknown " + std::string(kind) + " \"" + std::string(name) + "\"",
                           did_you_mean(name, known));
}

/// The algorithm of this name. @throws Error(invalid_parameter) naming the nearest.
inline const Algorithm& find_algorithm(std::span<const Algorithm> all, std::string_view name) {
  const auto found = std::ranges::find(all, name, &Algorithm::name);
  if (found != all.end()) return *found;
  std::vector<std::string_view> names;
  for (const Algorithm& one : all) names.push_back(one.name);
  throw unknown_name("algorithm", name, names);
}

/// How a table reads, writes and checks the fields of the struct `Fields`, which has a `seed` and
/// `threads` beside those in the table.
template <class Fields>
class ParameterTable {
 public:
  /// A number in its parameter's range.
  template <class Value>
  struct Bounded {
    Value Fields::*member;

    bool in_range(const Fields& fields, const Parameter& info) const {
      return holds(fields.*member, info);
    }
    bool same(const Fields& a, const Fields& b) const { return a.*member == b.*member; }
    std::string text(const Fields& fields, const Parameter&) const {
      return number_text(fields.*member);
    }
    void set(Fields& fields, const Parameter& info, std::string_view text) const {
      const auto value = number_of<Value>(text);
      constexpr const char* kKind =
          std::is_same_v<Value, int> ? "a whole number, " : "a plain number, ";
      if (!value) throw out_of_range(info, text, kKind);
      if (!holds(*value, info)) throw out_of_range(info, text);
      fields.*member = *value;
    }

   private:
    static bool holds(Value value, const Parameter& info) {
      return value >= info.least && value <= info.most;
    }
  };

  /// One of its parameter's choices, kept as an enum or as the number that its name stands for.
  struct Choice {
    int (*get)(const Fields&);
    void (*put)(Fields&, int);

    bool in_range(const Fields& fields, const Parameter& info) const {
      return static_cast<std::size_t>(get(fields)) < info.choices.size();
    }
    bool same(const Fields& a, const Fields& b) const { return get(a) == get(b); }
    std::string text(const Fields& fields, const Parameter& info) const {
      return in_range(fields, info) ? std::string(info.choices[get(fields)])
                                    : "not one of its values";
    }
    void set(Fields& fields, const Parameter& info, std::string_view text) const {
      const auto found = std::ranges::find(info.choices, text);
      if (found != info.choices.end())
        return put(fields, static_cast<int>(found - info.choices.begin()));
      refuse(std::string(info.name) + " is \"" + std::string(text) + "\"",
             nearest_name(text, info.choices)
                 ? did_you_mean(text, info.choices) + " It must be " + info.range()
                 : "it must be " + info.range());
    }
  };

  /// With what other fields one is read, in words and in code.
  struct Condition {
    std::string_view words;
    bool (*holds)(const Fields&);
  };

  struct Entry {
    Parameter info;
    std::variant<Bounded<int>, Bounded<double>, Choice> value;
    bool (*is_read)(const Fields&) = nullptr;  // null: always

    /// This entry, but read only under a condition.
    constexpr Entry only_with(const Condition& condition) const {
      Entry entry = *this;
      entry.info.only_with = condition.words;
      entry.is_read = condition.holds;
      return entry;
    }
  };

  /// A number from `least` to `most`.
  static constexpr Entry number(std::string_view name, int Fields::*member, int least, int most,
                                std::string_view summary, std::string_view earlier = {}) {
    return {{name, "integer", summary, {}, 1.0 * least, 1.0 * most, earlier}, Bounded<int>{member}};
  }
  static constexpr Entry number(std::string_view name, double Fields::*member, double least,
                                double most, std::string_view summary,
                                std::string_view earlier = {}) {
    return {{name, "number", summary, {}, least, most, earlier}, Bounded<double>{member}};
  }

  /// The choice that the field `kMember` keeps as the index of its name.
  template <auto kMember, const auto& kNames>
  static constexpr Entry choice(std::string_view name, std::string_view summary,
                                std::string_view earlier = {}) {
    using Value = std::remove_reference_t<decltype(std::declval<Fields&>().*kMember)>;
    return {{name, "choice", summary, kNames, 0, 0, earlier},
            Choice{[](const Fields& fields) { return static_cast<int>(fields.*kMember); },
                   [](Fields& fields, int i) { fields.*kMember = static_cast<Value>(i); }}};
  }

  /// What is told of the entries to those who list them.
  template <std::size_t kCount>
  static constexpr std::array<Parameter, kCount> infos(const std::array<Entry, kCount>& entries) {
    std::array<Parameter, kCount> list;
    for (std::size_t i = 0; i < kCount; ++i) list[i] = entries[i].info;
    return list;
  }

  /// A table of several lists. Precondition: entries of one name are equal.
  constexpr explicit ParameterTable(std::span<const std::span<const Entry>> lists)
      : lists_(lists) {}

  /// @throws Error(invalid_parameter) for an unknown name.
  const Entry& entry(std::string_view name) const {
    std::vector<Parameter> known;
    for (const auto list : lists_) {
      for (const Entry& e : list) {
        if (e.info.name == name) return e;
        known.push_back(e.info);
      }
    }
    refuse("unknown parameter \"" + std::string(name) + "\"",
           did_you_mean(name, std::span<const Parameter>(known)));
  }

  /// "evaporation" sets the persistence to 1 less it, where there is one.
  /// @throws Error(invalid_parameter) for an unknown name, a value that is none or out of range.
  void set(Fields& fields, std::string_view name, std::string_view text) const {
    if (name == kEvaporation || name == "rho") {
      const Entry& kept = entry(kPersistence);
      if (name == "rho")
        refuse("rho is the share lost in some sources and the share kept in others",
               "set persistence, the share kept, or evaporation, the share lost");
      Parameter lost = kept.info;
      lost.name = kEvaporation;
      const auto& number = std::get<Bounded<double>>(kept.value);
      number.set(fields, lost, text);
      fields.*number.member = 1 - fields.*number.member;
      return;
    }
    const Entry& e = entry(name);
    std::visit([&](const auto& value) { value.set(fields, e.info, text); }, e.value);
  }

  /// The value as text: a number's shortest that reads back as the same.
  /// @throws Error(invalid_parameter) for an unknown name.
  std::string get(const Fields& fields, std::string_view name) const {
    return text_of(fields, entry(name));
  }

  /// @throws Error(invalid_parameter) for the first field that is not as in `published`, though the
  /// algorithm does not read it.
  void check_unread(const Fields& fields, const Fields& published,
                    const Algorithm& algorithm) const {
    for (const auto list : lists_) {
      for (const Entry& e : list) {
        const bool same =
            std::visit([&](const auto& value) { return value.same(fields, published); }, e.value);
        if (same || algorithm.has(e.info.name)) continue;
        const std::string name(e.info.name);
        refuse(name + " is " + text_of(fields, e) + ", but " + std::string(algorithm.name) +
                   " does not read it",
               "leave it at " + text_of(published, e) + ", or choose an algorithm that does");
      }
    }
  }

  /// @throws Error(invalid_parameter) for the first field out of its range, seed and threads too.
  void check(const Fields& fields) const {
    for (const auto list : lists_) {
      for (const Entry& e : list) {
        if (!std::visit([&](const auto& value) { return value.in_range(fields, e.info); },
                        e.value)) {
          throw out_of_range(e.info, text_of(fields, e));
        }
      }
    }
    check_seed(fields.seed);
    check_threads(fields.threads);
  }

 private:
  static Error out_of_range(const Parameter& info, std::string_view value, const char* kind = "") {
    return invalid_parameter(std::string(info.name) + " is " + std::string(value),
                             std::string("it must be ") + kind + info.range());
  }

  static std::string text_of(const Fields& fields, const Entry& entry) {
    return std::visit([&](const auto& value) { return value.text(fields, entry.info); },
                      entry.value);
  }

  std::span<const std::span<const Entry>> lists_;
};

}  // namespace lasius
