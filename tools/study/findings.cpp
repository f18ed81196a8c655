#include "tools/study/findings.h"

namespace lasius::study {

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
