#include "tools/study/runner.h"

#include <time.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <mutex>

#include "lasius/error.h"
#include "tools/console/team.h"
#include "tools/study/files.h"
#include "tools/study/map_source.h"
#include "tools/study/optimum.h"
#include "tools/study/run_file.h"

namespace lasius::study {
namespace {

namespace fs = std::filesystem;

using Planners = std::map<std::string, Planner>;

Planners read_maps(const Study& study, const fs::path& folder) {
  Planners planners;
  for (const Experiment& experiment : study.experiments)
    for (const Question& question : experiment.questions)
      if (!planners.contains(question.map))
        planners.emplace(question.map, Planner(load_map(question.map, folder)));
  return planners;
}

/// What one iteration makes: paths of ants, or of a population.
int paths_an_iteration(const Params& params) {
  const auto all = algorithms();
  const auto own = std::find_if(all.begin(), all.end(),
                                [&](const Algorithm& a) { return a.name == params.algorithm(); });
  for (const Parameter& p : own->parameters)
    if (p.name == "population" || p.name == "ants") return std::stoi(get_parameter(params, p.name));
  return 1;
}

struct Job {
  Sample* sample;
  std::size_t run;
  const Planner* planner;
  Params params;
  std::string key;
  fs::path file;
  std::int64_t work;  // an estimate: path cells
};

/// Processor time of the calling thread: unlike the clock on the wall, it does not depend on what
/// else runs.
double thread_seconds() {
  timespec now{};
  ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

Run plan_once(const Job& job, Workspace& workspace, std::stop_token stop) {
  const Question& question = *job.sample->question;
  const double begin = thread_seconds();
  Result result = job.planner->plan({question.start, question.goal, {.token = std::move(stop)}},
                                    job.params, &workspace);
  Run run;
  run.seconds = thread_seconds() - begin;
  run.seed = job.params.seed;
  run.status = result.status;
  run.length = result.length;
  run.iterations = result.iterations;
  run.best = std::move(result.best);
  run.path = std::move(result.path);
  return run;
}

/// Takes the kept runs from their files; returns the jobs that are left.
std::vector<Job> prepare(const Study& study, const RunnerOptions& options, const Planners& planners,
                         Findings& findings) {
  std::size_t samples = 0;
  for (const Experiment& e : study.experiments) samples += e.contenders.size() * e.questions.size();
  findings.samples.reserve(samples);
  std::vector<Job> jobs;
  for (const Experiment& experiment : study.experiments) {
    for (const Contender& contender : experiment.contenders) {
      Params params;
      try {
        params = params_of(contender);
      } catch (const Error& fault) {
        findings.absent.push_back({experiment.name, contender.label, fault.what()});
        continue;
      }
      for (const Question& question : experiment.questions) {
        Sample& sample = findings.samples.emplace_back();
        sample = {&experiment, &question, &contender, paths_an_iteration(params), {}};
        sample.runs.resize(static_cast<std::size_t>(options.seeds));
        const Planner& planner = planners.at(question.map);
        const Grid& grid = planner.grid();
        const std::string key = run_key(grid, question, params);
        const fs::path folder =
            options.folder / "runs" / experiment.name / question.name / contender.name;
        make_folder(folder);
        for (std::size_t r = 0; r < sample.runs.size(); ++r) {
          params.seed = r + 1;
          const fs::path file = folder / (std::to_string(params.seed) + ".json");
          if (auto kept = read_run(file, key, params.seed)) {
            sample.runs[r] = std::move(*kept);
            continue;
          }
          const std::int64_t work = std::int64_t{sample.paths_an_iteration} *
                                    std::max(1, params.iterations) * (grid.width() + grid.height());
          jobs.push_back({&sample, r, &planner, params, key, file, work});
        }
      }
    }
  }
  return jobs;
}

/// Works through the jobs over threads; false when stopped.
bool work(std::vector<Job>& jobs, const RunnerOptions& options) {
  // Long runs first: no thread is left alone with one at the end.
  std::stable_sort(jobs.begin(), jobs.end(),
                   [](const Job& a, const Job& b) { return a.work > b.work; });
  std::int64_t total = 0, done = 0;
  for (const Job& job : jobs) total += job.work;
  std::mutex mutex;
  tool::share_out(jobs.size(), options.threads, [&] {
    return [&, workspace = Workspace()](std::size_t i) mutable {
      if (options.stop.stop_requested()) return;
      const Job& job = jobs[i];
      Run run = plan_once(job, workspace, options.stop);
      if (options.stop.stop_requested()) return;
      write_run(job.file, job.key, run);
      const std::scoped_lock lock(mutex);
      job.sample->runs[job.run] = std::move(run);
      done += job.work;
      if (options.progress)
        options.progress(done, total,
                         job.sample->contender->label + " on " + job.sample->question->name);
    };
  });
  return !options.stop.stop_requested();
}

}  // namespace

Params params_of(const Contender& contender) {
  Params params = defaults(contender.algorithm);
  for (const auto& [name, value] : contender.settings) set_parameter(params, name, value);
  params.iterations *= contender.budget;
  params.threads = 1;
  validate(params);
  return params;
}

std::optional<Findings> run_study(const Study& study, const RunnerOptions& options) {
  const Planners planners = read_maps(study, options.maps);
  Findings findings;
  auto jobs = prepare(study, options, planners, findings);
  if (!work(jobs, options)) return std::nullopt;
  for (const Experiment& experiment : study.experiments) {
    for (const Question& question : experiment.questions) {
      const auto length = true_optimum(planners.at(question.map), question, experiment.truth,
                                       {.token = options.stop});
      if (length) findings.optima.push_back({&question, &experiment, *length});
    }
  }
  if (options.stop.stop_requested()) return std::nullopt;
  return findings;
}

}  // namespace lasius::study
