#include "tools/study/findings.h"

namespace lasius::study {

const Sample* Findings::find(std::string_view experiment, std::string_view question,
                             std::string_view contender) const {
  for (; numbered_ < samples.size(); ++numbered_) {
    const Sample& s = samples[numbered_];
    numbers_.try_emplace({s.experiment->name, s.question->name, s.contender->name}, numbered_);
  }
  const auto found = numbers_.find({experiment, question, contender});
  return found == numbers_.end() ? nullptr : &samples[found->second];
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
  const auto found = optima.find({&experiment, &question});
  return found == optima.end() ? std::nullopt : std::optional(found->second);
}

}  // namespace lasius::study
