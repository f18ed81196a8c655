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
#include "lasius/params.h"

namespace lasius {

/// What a colony keeps of its pheromone, and the other word for it.
inline constexpr std::string_view kPersistence = "persistence", kEvaporation = "evaporation";

/// Less than this a colony could lose among its smallest numbers.
inline constexpr double kLeastPheromone = 1e-12;

/// @throws Error(invalid_parameter) unless a request's target gap is a number from 0 up, or
/// infinite.
inline void check_target_gap(double gap) {
  if (gap >= 0) return;
  throw invalid_parameter("target_gap is " + number_text(gap),
                          "it is a fraction: 0 or more, 0.01 for 1%");
}

/// @throws Error(invalid_parameter) for a gap that the algorithm cannot certify.
inline void check_certifies(const Algorithm& algorithm, double target_gap) {
  check_target_gap(target_gap);
  if (target_gap == 0 || algorithm.kind == Algorithm::Kind::exact) return;
  throw invalid_parameter("target_gap is " + number_text(target_gap) + ", but " +
                              std::string(algorithm.name) + " certifies no gap",
                          "leave it 0, or ask exact");
}

/// @throws Error(invalid_parameter) unless it is a number of threads that may be asked for.
inline void check_threads(int threads) {
  if (threads >= 0 && threads <= 1024) return;
  throw invalid_parameter("threads is " + std::to_string(threads),
                          "it must be 0 (all cores) to 1024");
}

/// @throws Error(invalid_parameter) for a seed that JSON does not keep exactly.
inline void check_seed(std::uint64_t seed) {
  constexpr std::uint64_t kMostSeed = (std::uint64_t{1} << 53) - 1;
  if (seed <= kMostSeed) return;
  throw invalid_parameter("seed is " + std::to_string(seed), "it must be at most 2^53 - 1");
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

/// Names as a range tells them: "a|b|c".
template <const auto& kNames>
inline constexpr auto kJoinedText = [] {
  constexpr std::size_t kLength = [] {
    std::size_t length = kNames.size() - 1;
    for (const std::string_view name : kNames) length += name.size();
    return length;
  }();
  std::array<char, kLength> text{};
  auto* to = text.data();
  for (const std::string_view name : kNames) {
    if (to != text.data()) *to++ = '|';
    for (const char c : name) *to++ = c;
  }
  return text;
}();
template <const auto& kNames>
inline constexpr std::string_view kJoined{kJoinedText<kNames>.data(), kJoinedText<kNames>.size()};

/// How a table reads, writes and checks the fields of the struct `Fields`, which has a `seed` and
/// `threads` beside those in the table.
template <class Fields>
class ParameterTable {
 public:
  /// A number from `least` to `most`.
  template <class Value>
  struct Bounded {
    Value Fields::*member;
    Value least, most;

    bool in_range(const Fields& fields) const { return holds(fields.*member); }
    bool same(const Fields& a, const Fields& b) const { return a.*member == b.*member; }
    std::string text(const Fields& fields) const { return number_text(fields.*member); }
    void set(Fields& fields, const Parameter& info, std::string_view text) const {
      const auto value = number_of<Value>(text);
      if (!value || !holds(*value)) throw out_of_range(info, text);
      fields.*member = *value;
    }

   private:
    bool holds(Value value) const { return value >= least && value <= most; }
  };
  using Integer = Bounded<int>;
  using Number = Bounded<double>;

  /// One of a few names, kept as an enum or as the number that the name stands for.
  struct Choice {
    std::span<const std::string_view> names;
    int (*get)(const Fields&);
    void (*put)(Fields&, int);

    bool in_range(const Fields& fields) const {
      return static_cast<std::size_t>(get(fields)) < names.size();
    }
    bool same(const Fields& a, const Fields& b) const { return get(a) == get(b); }
    std::string text(const Fields& fields) const {
      return in_range(fields) ? std::string(names[get(fields)]) : "not one of its values";
    }
    void set(Fields& fields, const Parameter& info, std::string_view text) const {
      for (std::size_t i = 0; i < names.size(); ++i) {
        if (names[i] == text) return put(fields, static_cast<int>(i));
      }
      throw invalid_parameter(std::string(info.name) + " is \"" + std::string(text) + "\"",
                              did_you_mean(text, names) + " It must be " + std::string(info.range));
    }
  };

  /// With what other fields one is read, in words and in code.
  struct Condition {
    std::string_view words;
    bool (*holds)(const Fields&);
  };

  struct Entry {
    Parameter info;
    std::variant<Integer, Number, Choice> value;
    bool (*is_read)(const Fields&) = nullptr;  // null: always

    /// The same, read only under a condition.
    constexpr Entry only_with(const Condition& condition) const {
      Entry entry = *this;
      entry.info.only_with = condition.words;
      entry.is_read = condition.holds;
      return entry;
    }
  };

  /// The choice that the field `kMember` keeps as the index of its name.
  template <auto kMember, const auto& kNames>
  static constexpr Entry choice(std::string_view name, std::string_view summary,
                                std::string_view earlier = {}) {
    using Value = std::remove_reference_t<decltype(std::declval<Fields&>().*kMember)>;
    return {{name, "choice", kJoined<kNames>, summary, earlier},
            Choice{kNames, [](const Fields& fields) { return static_cast<int>(fields.*kMember); },
                   [](Fields& fields, int i) { fields.*kMember = static_cast<Value>(i); }}};
  }

  /// What is told of the entries to those who list them.
  template <std::size_t kCount>
  static constexpr std::array<Parameter, kCount> infos(const std::array<Entry, kCount>& entries) {
    std::array<Parameter, kCount> list;
    for (std::size_t i = 0; i < kCount; ++i) list[i] = entries[i].info;
    return list;
  }

  /// A table of several lists; where two have an entry of one name it is the same.
  constexpr explicit ParameterTable(std::span<const std::span<const Entry>> lists)
      : lists_(lists) {}

  /// "evaporation" sets the persistence to 1 less it, where there is one.
  /// @throws Error(invalid_parameter) for an unknown name, a value that is none or out of range.
  void set(Fields& fields, std::string_view name, std::string_view text) const {
    if (name == kEvaporation || name == "rho") {
      const Entry& kept = entry(kPersistence);
      if (name == "rho") {
        throw invalid_parameter(
            "rho is the share lost in some sources and the share kept in others",
            "set persistence, the share kept, or evaporation, the share lost");
      }
      const Parameter lost{kEvaporation, kept.info.type, kept.info.range, ""};
      const auto& number = std::get<Number>(kept.value);
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

  /// Why this field has no effect beside the others; empty where it has one.
  std::string why_unread(const Fields& fields, std::string_view name) const {
    const Entry& e = entry(name);
    if (e.is_read == nullptr || e.is_read(fields)) return {};
    return "it is read only with " + std::string(e.info.only_with);
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
        throw invalid_parameter(
            name + " is " + text_of(fields, e) + ", but " + std::string(algorithm.name) +
                " does not read it",
            "leave it at " + text_of(published, e) + ", or choose an algorithm that does");
      }
    }
  }

  /// @throws Error(invalid_parameter) for the first field out of its range, seed and threads too.
  void check(const Fields& fields) const {
    for (const auto list : lists_) {
      for (const Entry& e : list) {
        if (!std::visit([&](const auto& value) { return value.in_range(fields); }, e.value)) {
          throw out_of_range(e.info, text_of(fields, e));
        }
      }
    }
    check_seed(fields.seed);
    check_threads(fields.threads);
  }

 private:
  static Error out_of_range(const Parameter& info, std::string_view value) {
    return invalid_parameter(std::string(info.name) + " is " + std::string(value),
                             "it must be " + std::string(info.range));
  }

  static std::string text_of(const Fields& fields, const Entry& entry) {
    return std::visit([&](const auto& value) { return value.text(fields); }, entry.value);
  }

  const Entry& entry(std::string_view name) const {
    std::vector<Parameter> known;
    for (const auto list : lists_) {
      for (const Entry& e : list) {
        if (e.info.name == name) return e;
        known.push_back(e.info);
      }
    }
    throw invalid_parameter("unknown parameter \"" + std::string(name) + "\"",
                            did_you_mean(name, std::span<const Parameter>(known)));
  }

  std::span<const std::span<const Entry>> lists_;
};

}  // namespace lasius
