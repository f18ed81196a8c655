#include "tools/study/runner.h"

#include <time.h>

#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <vector>

#include "core/base/parallel.h"
#include "lasius/error.h"
#include "tools/study/files.h"
#include "tools/study/run_file.h"

namespace lasius::study {
namespace {

namespace fs = std::filesystem;

struct Job {
  std::shared_ptr<const Task> task;
  Sample* sample;
  std::size_t run;
  std::uint64_t seed;
  fs::path file;
};

/// Takes the kept runs of a sample from their files, and adds the jobs that are left.
void list_jobs(const std::shared_ptr<const Task>& task, const RunnerOptions& options,
               Sample& sample, std::vector<Job>& jobs) {
  sample.paths_an_iteration = task->paths_an_iteration;
  sample.runs.resize(static_cast<std::size_t>(options.seeds));  // seed 0: not done
  const fs::path folder = options.folder / "runs" / sample.experiment->name /
                          sample.question->name / sample.contender->name;
  make_folder(folder);
  for (std::size_t r = 0; r < sample.runs.size(); ++r) {
    const std::uint64_t seed = options.first_seed + r;
    const fs::path file = folder / (std::to_string(seed) + ".json");
    if (auto kept = read_run(file, task->key, seed))
      sample.runs[r] = std::move(*kept);
    else
      jobs.push_back({task, &sample, r, seed, file});
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
        if (options.stop.stop_requested()) {
          findings.whole = false;
          return jobs;
        }
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

/// Processor seconds of a unit of work, by contender, from a part of its first job; nothing where
/// nobody wants to know.
std::map<const Contender*, double> paces(const std::vector<Job>& jobs,
                                         const RunnerOptions& options) {
  std::map<const Contender*, double> paces;
  if (!options.estimate) return paces;
  Workspace workspace;
  for (const Job& job : jobs) {
    auto& pace = paces[job.sample->contender];
    if (pace > 0 || options.stop.stop_requested()) continue;
    const double seconds = job.task->run(job.seed, true, options.stop, workspace).seconds;
    pace = std::max(8 * seconds, 1e-6) / static_cast<double>(job.task->work);
  }
  return paces;
}

/// Works through the jobs over threads.
void work(std::vector<Job>& jobs, const RunnerOptions& options) {
  const auto pace = paces(jobs, options);
  const auto microseconds = [&](const Job& job) {
    const auto found = pace.find(job.sample->contender);
    return static_cast<std::int64_t>(1e6 * (found == pace.end() ? 1e-6 : found->second) *
                                     static_cast<double>(job.task->work)) +
           1;
  };
  // Long runs first: no thread is left alone with one at the end.
  std::ranges::stable_sort(jobs, std::greater<>(), microseconds);
  std::int64_t total = 0, done = 0;
  for (const Job& job : jobs) total += microseconds(job);
  if (options.estimate)
    options.estimate(jobs.size(), 1e-6 * static_cast<double>(total) / options.threads);
  std::mutex mutex;
  std::vector<Workspace> workspaces(static_cast<std::size_t>(options.threads));
  const auto run_job = [&](const Job& job, Workspace& workspace) {
    if (options.stop.stop_requested()) return;
    Run run = job.task->run(job.seed, false, options.stop, workspace);
    if (options.stop.stop_requested()) return;
    run.seed = job.seed;
    write_run(job.file, job.task->key, run);
    const std::scoped_lock lock(mutex);
    job.sample->runs[job.run] = std::move(run);
    done += microseconds(job);
    if (options.progress)
      options.progress(done, total,
                       job.sample->contender->label + " on " + job.sample->question->name);
  };
  parallel_for(static_cast<int>(jobs.size()), options.threads, [&](int i, int thread) {
    run_job(jobs[static_cast<std::size_t>(i)], workspaces[static_cast<std::size_t>(thread)]);
  });
}

}  // namespace

std::optional<double> Domain::optimum(const Question&, const Truth&, const StopCondition&) const {
  return std::nullopt;
}

double thread_seconds() {
  timespec now{};
  ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

Findings run_study(const Study& study, const Domain& domain, const RunnerOptions& options) {
  Findings findings;
  for (const Experiment& experiment : study.experiments)
    for (const Question& question : experiment.questions) {
      if (options.stop.stop_requested()) break;
      if (const auto length = domain.optimum(question, experiment.truth, {.token = options.stop}))
        findings.optima.emplace(std::pair(&experiment, &question), *length);
    }
  auto jobs = list_jobs(study, domain, options, findings);
  if (!jobs.empty()) work(jobs, options);
  for (Sample& sample : findings.samples)
    if (std::erase_if(sample.runs, [](const Run& run) { return run.seed == 0; }) > 0)
      findings.whole = false;
  return findings;
}

}  // namespace lasius::study
