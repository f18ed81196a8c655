// lasius study: one study, or all of them.
#include <algorithm>
#include <filesystem>
#include <memory>

#include "core/base/did_you_mean.h"
#include "core/base/output.h"
#include "lasius/base/error.h"
#include "tools/console/crew.h"
#include "tools/console/exit_code.h"
#include "tools/console/signals.h"
#include "tools/console/streams.h"
#include "tools/console/values.h"
#include "tools/options/commands.h"
#include "tools/record/outputs.h"
#include "tools/study/bitmaps.h"
#include "tools/study/description/draws.h"
#include "tools/study/description/short_form.h"
#include "tools/study/description/study_file.h"
#include "tools/study/files.h"
#include "tools/study/markdown.h"
#include "tools/study/page.h"
#include "tools/study/part_file.h"
#include "tools/study/pictures.h"
#include "tools/study/portrait.h"
#include "tools/study/sources/console.h"
#include "tools/study/sources/online.h"
#include "tools/study/sources/tours.h"
#include "tools/study/table.h"
#include "tools/yaml/document.h"
#ifdef LASIUS_WITH_POLYGON
#include "tools/study/sources/maklink.h"
#endif
#ifdef LASIUS_WITH_ARM
#include "tools/study/sources/goritov2020.h"
#endif

namespace lasius::tool {
namespace {

namespace fs = std::filesystem;
using study::Evidence;
using study::Findings;
using study::Study;

bool was_built(study::ProblemKind kind) {
  bool built = kind == study::ProblemKind::bitmap || kind == study::ProblemKind::online ||
               kind == study::ProblemKind::tours;
#ifdef LASIUS_WITH_POLYGON
  built = built || kind == study::ProblemKind::polygon;
#endif
#ifdef LASIUS_WITH_ARM
  built = built || kind == study::ProblemKind::arm;
#endif
  return built;
}

std::unique_ptr<study::Domain> make_domain(const Study& study, const fs::path& maps) {
#ifdef LASIUS_WITH_POLYGON
  if (study.kind == study::ProblemKind::polygon)
    return std::make_unique<study::MaklinkWorld>(study, maps);
#endif
#ifdef LASIUS_WITH_ARM
  if (study.kind == study::ProblemKind::arm) return std::make_unique<study::ArmScenes>(study, maps);
#endif
  if (study.kind == study::ProblemKind::tours)
    return std::make_unique<study::StopTours>(study, maps);
  if (study.kind == study::ProblemKind::online)
    return std::make_unique<study::OnlineDrives>(study, maps);
  return std::make_unique<study::Bitmaps>(study, maps);
}

/// Without what the maps have not, which is told where messages are wanted.
std::vector<Study> studies(const StudyCommand& command) {
  std::vector<Study> all;
  for (const auto name : study::study_names())
    if (Study study = study::make_study(name); was_built(study.kind))
      all.push_back(std::move(study));
  for (Study& study : all) {
    if (study.kind != study::ProblemKind::tours) continue;
    const fs::path maps = find_maps(command.maps);
    const auto absent = study::leave_out_absent(study, maps);
    if (command.name != study.name && command.name != "all") continue;
    for (const std::string& file : absent)
      message(study.name + ": " + file + " is not in " + maps.string() +
              " and is left out; name the folder of TSPLIB's instances by --maps");
  }
  return all;
}

/// Runs studies one after another, until a signal comes.
class Session {
 public:
  explicit Session(const StudyCommand& command)
      : command_(command), maps_(find_maps(command.maps)) {}

  bool interrupted() const { return interrupted_ || signals_.token().stop_requested(); }

  study::Seeds seeds(const Study& study) const {
    return command_.seeds > 0 ? study::Seeds{command_.first_seed, command_.seeds} : study.seeds;
  }

  /// Runs what is left of a study and writes its report, partial after a signal.
  Findings run(const Study& study, const fs::path& folder) {
    const bool reports = !command_.part.divided() && !follows();
    const std::vector<std::string> files = report_files(folder);
    if (!follows()) prepare(folder, files);
    Delivery report(reports ? files : std::vector<std::string>{});
    const auto domain = make_domain(study, maps_);
    Findings findings = run_remaining(study, *domain, folder);
    interrupted_ |= findings.interrupted;
    if (reports) write(study, findings, folder, report);
    return findings;
  }

 private:
  std::vector<std::string> report_files(const fs::path& folder) const {
    std::vector<std::string> files;
    for (const char* name : {"runs.csv", "results.csv", "claims.csv", "report.md"})
      files.push_back((folder / name).string());
    files.push_back(command_.page.empty() ? (folder / "report.html").string() : command_.page);
    return files;
  }
  static void prepare(const fs::path& folder, const std::vector<std::string>& files) {
    study::make_folder(folder);
    check_outputs(files, {});  // before hours of work
  }

  Findings run_remaining(const Study& study, const study::Domain& domain, const fs::path& folder) {
    const auto tell = [&](std::size_t runs, double seconds) {
      if (!command_.messages.quiet)
        message(study.name + ": " + counted(static_cast<std::int64_t>(runs), "run") + ", about " +
                duration_text(seconds) + " with " + counted(command_.threads, "thread") +
                ", by a part of one run of each");
    };
    return study::run_study(study, domain,
                            {.seeds = seeds(study).count,
                             .threads = command_.threads,
                             .folder = folder,
                             .stop = signals_.token(),
                             .estimate = tell,
                             .progress = progress_shown(command_.messages),
                             .first_seed = seeds(study).first,
                             .part = command_.part,
                             .all_there = command_.joined});
  }

  /// Polls nothing: a signal ends it, and what was run is kept.
  void write(const Study& study, const Findings& findings, const fs::path& folder,
             Delivery& report) const {
    const EndAtOnce runs_are_kept;
    auto evidence = study::weigh(study, findings);
    study::decide(evidence);
    std::vector<study::Figure> figures;
    if (findings.whole) {
      figures = study::draw_pictures(study, findings, folder, maps_);
      for (auto& figure : study::draw_portraits(study, folder, maps_))
        figures.push_back(std::move(figure));
    }
    std::string results;
    for (const study::Experiment& experiment : study.experiments)
      results += experiment.name + "\n" + result_table(findings, experiment).csv() + "\n";
    report.write([&](const std::string& file) {
      const std::string name = fs::path(file).filename().string();
      if (is_page(file))
        write_file(file, [&](std::ostream& out) {
          study::write_study_page(out, {study, findings, evidence, maps_, command_.called});
        });
      else
        study::write_text(file, name == "runs.csv"      ? run_table(findings).csv()
                                : name == "results.csv" ? results
                                : name == "claims.csv"  ? evidence_table(evidence).csv()
                                                        : report_page(study, findings, evidence,
                                                                      seeds(study), figures));
    });
  }

  const StudyCommand& command_;
  fs::path maps_;
  SignalWatcher signals_;
  bool interrupted_ = false;
};

/// All studies, each in a folder of its own, and the pages of their claims.
fs::path run_all(Session& session, const std::vector<Study>& all, const StudyCommand& command) {
  const fs::path folder = command.folder;
  const std::vector<std::string> files{(folder / "claims.csv").string(),
                                       (folder / "claims.md").string()};
  Delivery claims(command.part.divided() ? std::vector<std::string>{} : files);
  std::vector<Evidence> evidence;
  std::vector<Findings> findings;
  findings.reserve(all.size());
  for (const Study& study : all) {
    if (session.interrupted()) break;
    findings.push_back(session.run(study, folder / study.name));
    if (command.part.divided() || follows()) continue;
    std::ranges::move(study::weigh(study, findings.back()), std::back_inserter(evidence));
  }
  leave_to_leader();
  if (command.part.divided()) return folder;
  study::decide(evidence);
  std::string called = "lasius study all";
  if (command.seeds > 0) called = study::called("all", {command.first_seed, command.seeds});
  study::make_folder(folder / "claims");
  for (const auto of_one : study::by_study(evidence))
    study::write_text(folder / "claims" / (of_one.front().study->name + ".md"),
                      claim_details(of_one));
  claims.write([&](const std::string& file) {
    study::write_text(
        file, is_table(file) ? evidence_table(evidence).csv() : claims_page(evidence, called));
  });
  return files.back();
}

int finished(const Session& session, const StudyCommand& command, const fs::path& page) {
  leave_to_leader();
  if (session.interrupted()) {
    message("interrupted: " + page.string() + " is partial; the same command goes on from here");
    return kInterrupted;
  }
  if (command.part.divided()) {
    study::write_part(command);
    print(command.folder + "\n");
    return kFound;
  }
  print(page.string() + "\n");
  return kFound;
}

/// The study that `run` asks for, as its file will say it. @throws UsageError
Study short_study(const std::string& text, const std::string& file) {
  try {
    Study study = study::parse_study(text, file);
    study.file = file;
    return study;
  } catch (const Error& fault) {
    if (fault.place().file != file) throw;
    throw UsageError("study run: " + fault.problem() + "; " + fault.remedy());
  }
}

int run_users_study(const StudyCommand& command) {
  const bool is_short = command.name == "run";
  const std::string text =
      is_short ? study::study_text(command.run, {command.first_seed, command.seeds}) : "";
  const std::string file = (fs::path(command.folder) / study::kShortStudy).string();
  Study study = is_short ? short_study(text, file) : study::read_study(command.name);
  if (!was_built(study.kind))
    throw UsageError(study.file + ": this lasius was built without that world");
  try {
    if (study.kind == study::ProblemKind::bitmap)
      study::draw_questions(study, find_maps(command.maps));
  } catch (const Error& fault) {
    if (!is_short || fault.place().file != study.file) throw;
    if (fault.code() != ErrorCode::file_broken)
      throw Error(fault.code(), {.file = command.run.map}, fault.problem(), fault.remedy());
    message(fault.problem() + ": " + fault.remedy());
    return kInvalidQuery;
  }
  if (is_short && !follows()) {
    study::make_folder(command.folder);
    study::write_text(file, text);
  }
  std::vector<study::Contender> contenders;
  for (const study::Experiment& e : study.experiments)
    contenders.insert(contenders.end(), e.contenders.begin(), e.contenders.end());
  if (study.kind == study::ProblemKind::bitmap && !command.messages.quiet) tell_unread(contenders);
  Session session(command);
  (void)session.run(study, command.folder);
  return finished(session, command, fs::path(command.folder) / "report.md");
}

/// -o FILE.html: the page is written there, all else into a folder of the same name without ending.
StudyCommand with_page(StudyCommand command) {
  if (!is_page(command.folder)) return command;
  if (command.name == "all")
    throw UsageError("-o " + command.folder + ": a page is of one study; give a folder");
  command.page = command.folder;
  command.folder = fs::path(command.folder).replace_extension().string();
  return command;
}

}  // namespace

int run_command(const StudyCommand& asked) {
  const StudyCommand command = with_page(asked);
  if (command.name == "run" || is_document(command.name)) return run_users_study(command);
  const auto all = studies(command);
  std::string list;
  std::vector<std::string_view> known{"list", "all"};
  for (const Study& study : all) {
    list += study.name + "\t" + study.summary + "\n";
    known.push_back(study.name);
  }
  if (command.name == "list") {
    print(list);
    return kFound;
  }
  if (std::ranges::find(known, command.name) == known.end())
    throw UsageError("unknown study \"" + command.name + "\"; " +
                     did_you_mean(command.name, known));
  const fs::path folder = command.folder;
  Session session(command);
  fs::path page = folder / "report.md";
  if (command.name == "all")
    page = run_all(session, all, command);
  else
    (void)session.run(*std::ranges::find(all, command.name, &Study::name), folder);
  return finished(session, command, page);
}

}  // namespace lasius::tool
