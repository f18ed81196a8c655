#include "tools/study/runner.h"

#include <time.h>

#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <sstream>
#include <stdexcept>
#include <utility>
#include <vector>

#include "core/base/parallel.h"
#include "lasius/base/error.h"
#include "lasius/version.h"
#include "tools/console/crew.h"
#include "tools/record/json_values.h"
#include "tools/study/files.h"
#include "tools/study/run_file.h"

namespace lasius::study {
namespace {

namespace fs = std::filesystem;

/// One run that is left to do.
struct Job {
  std::shared_ptr<const PreparedRun> prepared;
  Sample* sample;
  std::size_t run;
  std::uint64_t seed;
  fs::path file;
  bool kept = false;  ///< from an earlier call: a crew's numbers count it
};

/// Takes the kept runs of a sample from their files, and adds the jobs that are left.
void list_jobs(const std::shared_ptr<const PreparedRun>& prepared, const RunnerOptions& options,
               Sample& sample, std::size_t& number, std::vector<Job>& jobs) {
  sample.paths_an_iteration = prepared->paths_an_iteration;
  sample.runs.resize(static_cast<std::size_t>(options.seeds));  // seed 0: not done
  const fs::path folder = options.folder / "runs" / sample.experiment->name /
                          sample.question->name / sample.contender->name;
  if (!tool::follows()) make_folder(folder);
  for (std::size_t r = 0; r < sample.runs.size(); ++r) {
    if (!options.part.holds(number++)) continue;
    const std::uint64_t seed = options.first_seed + r;
    const fs::path file = folder / (std::to_string(seed) + ".json");
    auto kept = tool::follows() ? std::nullopt : read_run(file, prepared->key, seed);
    const bool there = kept.has_value();
    if (there) sample.runs[r] = *std::move(kept);
    if (!there || tool::crew() != nullptr)
      jobs.push_back({prepared, &sample, r, seed, file, there});
  }
}

std::vector<Job> list_jobs(const Study& study, const Domain& domain, const RunnerOptions& options,
                           Findings& findings) {
  std::size_t samples = 0;
  for (const Experiment& e : study.experiments) samples += e.contenders.size() * e.questions.size();
  findings.samples.reserve(samples);
  std::size_t number = 0;  // of the next run
  std::vector<Job> jobs;
  for (const Experiment& experiment : study.experiments) {
    for (const Contender& contender : experiment.contenders) {
      for (const Question& question : experiment.questions) {
        if (options.stop.stop_requested()) {
          findings.whole = false;
          return jobs;
        }
        std::shared_ptr<const PreparedRun> prepared;
        try {
          prepared = std::make_shared<PreparedRun>(domain.prepare(question, contender));
        } catch (const Error& fault) {
          findings.skipped.push_back({experiment.name, contender.label, fault.what()});
          break;
        }
        findings.samples.push_back({&experiment, &question, &contender});
        list_jobs(prepared, options, findings.samples.back(), number, jobs);
      }
    }
  }
  return jobs;
}

/// Processor seconds of a unit of PreparedRun::work, by contender, from a part of its first job;
/// empty where no estimate is asked for.
std::map<const Contender*, double> seconds_a_unit(const std::vector<Job>& jobs,
                                                  const RunnerOptions& options) {
  std::map<const Contender*, double> seconds_a_unit;
  if (!options.estimate) return seconds_a_unit;
  Workspace workspace;
  for (const Job& job : jobs) {
    auto& pace = seconds_a_unit[job.sample->contender];
    if (pace > 0 || options.stop.stop_requested()) continue;
    const double seconds = job.prepared->run(job.seed, true, options.stop, workspace).seconds;
    pace = std::max(8 * seconds, 1e-6) / static_cast<double>(job.prepared->work);
  }
  return seconds_a_unit;
}

/// Works through the jobs over threads.
void work(std::vector<Job>& jobs, const RunnerOptions& options) {
  const auto pace = seconds_a_unit(jobs, options);
  const auto microseconds = [&](const Job& job) {
    const auto found = pace.find(job.sample->contender);
    return static_cast<std::int64_t>(1e6 * (found == pace.end() ? 1e-6 : found->second) *
                                     static_cast<double>(job.prepared->work)) +
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
    Run run = job.prepared->run(job.seed, false, options.stop, workspace);
    if (options.stop.stop_requested()) return;
    run.seed = job.seed;
    write_run(job.file, job.prepared->key, run);
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

/// What another rank made of a job.
Run taken(const Job& job, const std::string& text) {
  auto run = parse_run(text, job.prepared->key, job.seed);
  if (!run) throw std::runtime_error("a rank is another lasius than the leader");
  return *std::move(run);
}

/// Tells the jobs from all others: equal numbers are to mean equal runs.
std::string key_of(const std::vector<Job>& jobs) {
  std::uint64_t hash = tool::bytes_hash(LASIUS_VERSION);
  for (const Job& job : jobs)
    hash = tool::bytes_hash(job.prepared->key + " " + std::to_string(job.seed) + "\n", hash);
  return tool::hash_text(hash);
}

/// Shares the jobs that are left among a crew; an item is a job's number. False where they are not
/// all done.
bool share(tool::Crew& crew, const std::vector<Job>& jobs, const RunnerOptions& options) {
  std::vector<Workspace> workspaces(static_cast<std::size_t>(options.threads));
  const auto job_of = [&](int item) -> const Job& { return jobs[static_cast<std::size_t>(item)]; };
  tool::Crew::Work work{.key = key_of(jobs), .at_a_time = options.threads, .stop = options.stop};
  for (int i = 0; i < static_cast<int>(jobs.size()); ++i)
    if (!job_of(i).kept) work.items.push_back(i);
  std::ranges::stable_sort(work.items, std::greater<>(),
                           [&](int item) { return job_of(item).prepared->work; });
  work.act = [&](std::span<const int> items) {
    std::vector<std::string> texts(items.size());
    parallel_for(static_cast<int>(items.size()), options.threads, [&](int i, int thread) {
      const auto at = static_cast<std::size_t>(i);
      const Job& job = job_of(items[at]);
      if (options.stop.stop_requested()) return;
      Run run = job.prepared->run(job.seed, false, options.stop,
                                  workspaces[static_cast<std::size_t>(thread)]);
      if (options.stop.stop_requested()) return;
      run.seed = job.seed;
      texts[at] = run_text(job.prepared->key, run);
    });
    return texts;
  };
  std::int64_t done = 0;
  work.receive = [&](int item, const std::string& text) {
    const Job& job = job_of(item);
    Run run = taken(job, text);
    write_text(job.file, text);
    job.sample->runs[job.run] = std::move(run);
    if (options.progress)
      options.progress(++done, static_cast<std::int64_t>(work.items.size()),
                       job.sample->contender->label + " on " + job.sample->question->name);
  };
  if (options.tell_all)
    work.summary = [&] {
      std::string all;
      for (const Job& job : jobs) all += run_text(job.prepared->key, job.sample->runs[job.run]);
      return all;
    };
  const auto summary = crew.share(work);
  if (crew.leads() || !options.tell_all) return summary.has_value();
  std::istringstream told(summary.value_or(""));
  std::string line;
  for (const Job& job : jobs) {
    std::getline(told, line);
    job.sample->runs[job.run] = taken(job, line);
  }
  return true;
}

}  // namespace

std::optional<double> Domain::optimum(const Question&, const Optimum&, const StopCondition&) const {
  return std::nullopt;
}

double thread_seconds() {
  timespec now{};
  ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

Findings run_study(const Study& study, const Domain& domain, const RunnerOptions& options) {
  Findings findings;
  const bool alone = options.part.divided() || (tool::follows() && !options.tell_all);
  const auto find_optima = [&] {
    for (const Experiment& experiment : study.experiments)
      for (const Question& question : experiment.questions) {
        if (options.stop.stop_requested() || alone) return;
        if (const auto length =
                domain.optimum(question, experiment.optimum, {.token = options.stop}))
          findings.optima.emplace(std::pair(&experiment, &question), *length);
      }
  };
  tool::Crew* const crew = tool::crew();
  auto jobs = list_jobs(study, domain, options, findings);
  if (options.all_there && !jobs.empty())
    throw Error(ErrorCode::file_broken, {.file = options.folder.string()},
                "lacks " + tool::counted(static_cast<std::int64_t>(jobs.size()), "run") +
                    ", or they were made of other maps or layers than there are now",
                "run the parts again, on one state of the inputs");
  if (crew == nullptr) find_optima();
  if (crew != nullptr) {
    if (!crew->leads() && options.stop.stop_requested()) throw tool::Dismissed{};
    findings.interrupted = !share(*crew, jobs, options);
    find_optima();  // others need not wait for them
  } else if (!jobs.empty()) {
    work(jobs, options);
  }
  for (Sample& sample : findings.samples)
    if (std::erase_if(sample.runs, [](const Run& run) { return run.seed == 0; }) > 0)
      findings.whole = false;
  findings.interrupted |= options.stop.stop_requested();
  return findings;
}

}  // namespace lasius::study
