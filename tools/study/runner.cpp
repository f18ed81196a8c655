#include "tools/study/runner.h"

#include <time.h>

#include <memory>
#include <mutex>

#include "lasius/error.h"
#include "tools/console/team.h"
#include "tools/study/files.h"
#include "tools/study/run_file.h"

namespace lasius::study {
namespace {

namespace fs = std::filesystem;

struct Job {
  std::shared_ptr<const Task> task;
  Sample* sample;
  std::size_t run;
  fs::path file;
};

/// Takes the kept runs of a sample from their files, and adds the jobs that are left.
void list_jobs(const std::shared_ptr<const Task>& task, const RunnerOptions& options,
               Sample& sample, std::vector<Job>& jobs) {
  sample.paths_an_iteration = task->paths_an_iteration;
  sample.runs.resize(static_cast<std::size_t>(options.seeds));
  const fs::path folder = options.folder / "runs" / sample.experiment->name /
                          sample.question->name / sample.contender->name;
  make_folder(folder);
  for (std::size_t r = 0; r < sample.runs.size(); ++r) {
    const fs::path file = folder / (std::to_string(r + 1) + ".json");
    if (auto kept = read_run(file, task->key, r + 1))
      sample.runs[r] = std::move(*kept);
    else
      jobs.push_back({task, &sample, r, file});
  }
}

std::vector<Job> list_jobs(const Study& study, const Domain& domain, const RunnerOptions& options,
                           Findings& findings) {
  std::size_t samples = 0;
  for (const Experiment& e : study.experiments) samples += e.contenders.size() * e.questions.size();
  findings.samples.reserve(samples);
  std::vector<Job> jobs;
  for (const Experiment& experiment : study.experiments) {
    for (const Contender& contender : experiment.contenders) {
      for (const Question& question : experiment.questions) {
        std::shared_ptr<const Task> task;
        try {
          task = std::make_shared<Task>(domain.task(question, contender));
        } catch (const Error& fault) {
          findings.absent.push_back({experiment.name, contender.label, fault.what()});
          break;
        }
        findings.samples.push_back({&experiment, &question, &contender});
        list_jobs(task, options, findings.samples.back(), jobs);
      }
    }
  }
  return jobs;
}

/// Works through the jobs over threads; false when stopped.
bool work(std::vector<Job>& jobs, const RunnerOptions& options) {
  // Long runs first: no thread is left alone with one at the end.
  std::stable_sort(jobs.begin(), jobs.end(),
                   [](const Job& a, const Job& b) { return a.task->work > b.task->work; });
  std::int64_t total = 0, done = 0;
  for (const Job& job : jobs) total += job.task->work;
  std::mutex mutex;
  tool::share_out(jobs.size(), options.threads, [&] {
    return [&, workspace = Workspace()](std::size_t i) mutable {
      if (options.stop.stop_requested()) return;
      const Job& job = jobs[i];
      Run run = job.task->run(job.run + 1, options.stop, workspace);
      if (options.stop.stop_requested()) return;
      run.seed = job.run + 1;
      write_run(job.file, job.task->key, run);
      const std::scoped_lock lock(mutex);
      job.sample->runs[job.run] = std::move(run);
      done += job.task->work;
      if (options.progress)
        options.progress(done, total,
                         job.sample->contender->label + " on " + job.sample->question->name);
    };
  });
  return !options.stop.stop_requested();
}

}  // namespace

std::optional<double> Domain::optimum(const Question&, const Truth&, const StopCondition&) const {
  return std::nullopt;
}

std::span<const Parameter> parameters_of(std::span<const Algorithm> algorithms,
                                         std::string_view name) {
  return std::ranges::find(algorithms, name, &Algorithm::name)->parameters;
}

double thread_seconds() {
  timespec now{};
  ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

std::optional<Findings> run_study(const Study& study, const Domain& domain,
                                  const RunnerOptions& options) {
  Findings findings;
  auto jobs = list_jobs(study, domain, options, findings);
  if (!work(jobs, options)) return std::nullopt;
  for (const Experiment& experiment : study.experiments)
    for (const Question& question : experiment.questions)
      if (const auto length = domain.optimum(question, experiment.truth, {.token = options.stop}))
        findings.optima.push_back({&question, &experiment, *length});
  if (options.stop.stop_requested()) return std::nullopt;
  return findings;
}

}  // namespace lasius::study
