// A race: candidates answer one question after another, and those that are clearly worse leave.
//
// F-race: Birattari, Stuetzle, Paquete, Varrentrapp: A racing algorithm for configuring
// metaheuristics. GECCO 2002; Birattari, Yuan, Balaprakash, Stuetzle: F-Race and iterated F-Race.
// In: Experimental Methods for the Analysis of Optimization Algorithms, Springer 2010. The tests:
// Conover: Practical Nonparametric Statistics, 3rd edition, 1999, sections 5.7 and 5.8.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "tools/study/statistics.h"

namespace lasius::study {

/// P(X > x) of a chi-square law. Precondition: freedom >= 1.
double chi_square_above(double x, int freedom);

/// P(|T| > t) of Student's law. Precondition: freedom >= 1.
double student_beyond(double t, int freedom);

/// The t that |T| exceeds with this probability, 0 < p < 1.
double student_quantile(double p, int freedom);

/// Friedman's test over blocks, each with a value of every candidate, with Conover's comparison of
/// two candidates after it.
struct Friedman {
  double statistic = 0;                ///< T, 0 where every block ties
  double p = 1;                        ///< of T by the chi-square law of candidates - 1 degrees
  std::vector<double> rank_sums = {};  ///< of each candidate
  /// Two rank sums that differ by more differ at `level`; infinite where nothing can.
  double critical = 0;
};
/// Precondition: at least 2 candidates and 2 blocks, all of the same size.
Friedman friedman(std::span<const std::vector<double>> blocks, double level);

struct SignedRanks {
  double p = 1;
  bool above = false;  ///< the ranks of differences above 0 have the larger sum
};
/// Wilcoxon's signed rank test (1945) that the median of the differences a - b is 0, two-sided and
/// exact for the ranks at hand up to 60 of them, else by the normal law; differences of 0 are left
/// out. Values may be infinite; two infinite ones are equal.
SignedRanks signed_ranks(std::span<const double> a, std::span<const double> b);

struct RaceRules {
  int first_test = 6;   ///< blocks before the first test
  double level = 0.05;  ///< of every test
};

/// One candidate in a race.
struct Runner {
  std::vector<double> values = {};  ///< one a block that it took part in
  int left_after = 0;               ///< blocks after which it left; 0: it is still there
  double p = 1;                     ///< of the test by which it left
};

/// Which candidates are left after the blocks so far.
class Race {
 public:
  /// Precondition: candidates > 0.
  Race(std::size_t candidates, RaceRules rules) : rules_(rules), runners_(candidates) {}

  /// The candidates still in the race, in their order.
  std::vector<std::size_t> left() const;
  int blocks() const { return blocks_; }
  const std::vector<Runner>& runners() const { return runners_; }

  /// Takes the values of those that are left, less is better, and lets leave who is clearly worse
  /// than the best: by Friedman's test and Conover's comparison, two by Wilcoxon's.
  void add(std::span<const double> values);

  /// Of those that are left, over all blocks: the one with the least mean rank, of equal ones the
  /// one with the least median, then the first.
  std::size_t best() const;

  /// The first but candidate 0 in the order of best(); where no other is left, of those that left
  /// last the one with the least median. Precondition: at least 2 candidates and 1 block.
  std::size_t rival() const;

  /// Mean ranks of those that are left, by block among themselves, and the interval of each one's
  /// difference from the best one's at the race's level, two-sided.
  struct Standing {
    std::size_t candidate;
    double mean_rank;
    double median;
    Interval behind;  ///< how far its mean rank is behind the best's
  };
  std::vector<Standing> standings() const;

 private:
  std::vector<std::vector<double>> values_of(std::span<const std::size_t> candidates) const;
  void leave(std::size_t candidate, double p);

  RaceRules rules_;
  std::vector<Runner> runners_;
  int blocks_ = 0;
};

}  // namespace lasius::study
