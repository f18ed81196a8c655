#include "tools/study/sources/goritov2020_measures.h"

#include <algorithm>
#include <cmath>

#include "tools/draw/text.h"

namespace lasius::study {
namespace {

/// Final best lengths of `b` minus those of `a`, paired by question and seed, in shares of the
/// optimum: positive where `a` is shorter.
std::vector<double> differences(const Runs& a, const Runs& b) {
  std::vector<double> list;
  for (std::size_t q = 0; q < a.size(); ++q) {
    for (std::size_t s = 0; s < a[q]->runs.size(); ++s) {
      const double d = final_best(b[q]->runs[s]) - final_best(a[q]->runs[s]);
      if (std::isfinite(d)) list.push_back(d);
    }
  }
  return list;
}

/// The iteration from which a run's mean tour never changes again; 0 where it changes in the last
/// tenth.
int frozen_from(const Run& run) {
  const auto& mean = run.mean;
  std::size_t from = mean.size();
  while (from > 0 && std::abs(mean[from - 1] - mean.back()) <= 1e-12 * mean.back()) --from;
  return from + mean.size() / 10 < mean.size() ? static_cast<int>(from) + 1 : 0;
}

double mean_over(const Runs& runs, double (*value)(const Run&)) {
  double sum = 0, count = 0;
  for (const Sample* question : runs) {
    for (const Run& run : question->runs) {
      sum += value(run);
      ++count;
    }
  }
  return sum / count;
}

}  // namespace

double final_best(const Run& run) { return run.best.empty() ? kUnknown : run.best.back(); }

double mean_steps(const Runs& runs) {
  return mean_over(runs, [](const Run& run) { return static_cast<double>(run.steps); });
}

double mean_reached(const Runs& runs) {
  return mean_over(runs, [](const Run& run) {
    const auto first = std::find(run.best.begin(), run.best.end(), final_best(run));
    return static_cast<double>(first - run.best.begin()) + 1;
  });
}

std::string percent(double share) { return fixed(100 * share, 1); }

Contrast::Contrast(const Runs& first, const Runs& second) {
  const auto list = differences(first, second);
  mean = summarise(list).mean;
  interval = mean_interval(list);
}

std::string Contrast::text() const {
  std::string text(mean >= 0 ? "+" : "");
  text.append(percent(mean)).append("% [").append(percent(interval.low)).append(", ");
  return text.append(percent(interval.high)).append("]");
}

Freezing::Freezing(const Runs& runs) {
  std::vector<double> when;
  for (const Sample* question : runs) {
    for (const Run& run : question->runs) {
      ++all;
      if (const int from = frozen_from(run); from > 0) when.push_back(from);
    }
  }
  frozen = static_cast<int>(when.size());
  if (!when.empty()) median = quantile(when, 0.5);
}

std::string Freezing::text() const {
  return percent(share()) + "% frozen" + (frozen > 0 ? ", median " + fixed(median, 0) : "");
}

std::vector<double> mean_curve(const Runs& runs, std::vector<double> Run::*curve) {
  std::vector<double> sum, count;
  for (const Sample* question : runs) {
    for (const Run& run : question->runs) {
      const auto& values = run.*curve;
      sum.resize(std::max(sum.size(), values.size()), 0);
      count.resize(sum.size(), 0);
      for (std::size_t i = 0; i < values.size(); ++i) {
        if (!std::isfinite(values[i])) continue;
        sum[i] += values[i];
        ++count[i];
      }
    }
  }
  for (std::size_t i = 0; i < sum.size(); ++i) sum[i] = count[i] > 0 ? sum[i] / count[i] : kUnknown;
  return sum;
}

}  // namespace lasius::study
