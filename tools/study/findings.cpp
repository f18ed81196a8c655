#include "tools/study/findings.h"

#include <cmath>

namespace lasius::study {

int Run::converged() const {
  if (best.empty() || !std::isfinite(best.back())) return 0;
  std::size_t first = best.size();
  while (first > 1 && best[first - 2] == best.back()) --first;
  return static_cast<int>(first);
}

std::vector<double> Sample::lengths() const {
  std::vector<double> values;
  for (const Run& run : runs)
    if (run.solved()) values.push_back(run.length);
  return values;
}

std::vector<double> Sample::iterations_to_converge() const {
  std::vector<double> values;
  for (const Run& run : runs)
    if (run.solved()) values.push_back(run.converged());
  return values;
}

std::vector<double> Sample::seconds() const {
  std::vector<double> values;
  for (const Run& run : runs) values.push_back(run.seconds);
  return values;
}

int Sample::solved() const { return static_cast<int>(lengths().size()); }

const Sample* Findings::find(std::string_view experiment, std::string_view question,
                             std::string_view contender) const {
  for (const Sample& s : samples)
    if (s.experiment->name == experiment && s.question->name == question &&
        s.contender->name == contender)
      return &s;
  return nullptr;
}

std::vector<const Sample*> Findings::of(std::string_view experiment,
                                        std::string_view contender) const {
  std::vector<const Sample*> found;
  for (const Sample& s : samples)
    if (s.experiment->name == experiment && s.contender->name == contender) found.push_back(&s);
  return found;
}

std::optional<double> Findings::optimum(const Experiment& experiment,
                                        const Question& question) const {
  for (const Optimum& o : optima)
    if (o.experiment == &experiment && o.question == &question) return o.length;
  return std::nullopt;
}

}  // namespace lasius::study
