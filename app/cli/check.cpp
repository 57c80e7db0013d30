// ghostforce check: screenshot regression. Draws a folder of cases and compares each with the picture stored beside it.
// Or, of lessons: says whether they can be read and done.
#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include "app/base/failure.h"
#include "app/base/interruption.h"
#include "app/base/progress.h"
#include "app/base/quoted.h"
#include "app/base/typed_text.h"
#include "app/base/words.h"
#include "app/cli/command.h"
#include "app/cli/option.h"
#include "app/cli/picture_options.h"
#include "app/files/input_file.h"
#include "app/files/toml_document.h"
#include "app/state/lesson_file.h"
#include "app/state/lesson_search.h"
#include "app/tools/check/case_folder.h"
#include "app/tools/check/evaluation.h"
#include "app/tools/check/report.h"

namespace ghostforce {
namespace {

// Of one lesson. Returns how many of its steps are wrong.
std::size_t print_findings(const Lesson& lesson, const std::string& shown, Lines& lines) {
  std::vector<std::string_view> languages;
  for (const auto& [language, words] : lesson.words) languages.push_back(language);
  lines.write(fmt::format("{}: \"{}\", {} steps, languages: {}", shown, words_in(lesson, "en").title,
                          lesson.steps.size(), listed(languages)));
  std::size_t wrong = 0;
  std::size_t longest = 0;
  for (const LessonStep& step : lesson.steps) longest = std::max(longest, step.name.size());
  const std::vector<LessonStepFinding> findings = examine_lesson(lesson);
  for (std::size_t i = 0; i < findings.size(); ++i) {
    const LessonStepFinding& found = findings[i];
    lines.write(fmt::format("  {:2} {:5}  {:{}}  {}", i + 1, found.is_good ? "ok" : "WRONG", lesson.steps[i].name,
                            longest, found.words));
    if (!found.example.empty()) lines.write(fmt::format("            for example: {}", found.example));
    if (!found.is_good) ++wrong;
  }
  for (const std::string_view language : languages_missing_in(lesson)) {
    lines.write(fmt::format("  not translated yet: there is no [{}]", language));
  }
  return wrong;
}

// A case of a picture; then a person has named it instead of its folder.
bool is_case(const std::string& path) {
  TomlReader reader(path);
  return reader.parse(file_contents(path).text) && reader.find("", "scene");
}

// A word on the command line that is rather a lesson than a folder of cases.
bool may_be_lesson(const std::string& word) {
  std::error_code unknown;
  if (std::filesystem::is_directory(word, unknown)) return false;
  const std::vector<std::string_view> shipped = shipped_lesson_names();
  return std::ranges::find(shipped, word) != shipped.end() || (word.ends_with(".toml") && !is_case(word));
}

// Reads each as the window would, and prints what it finds, step by step. Returns an exit code: done; answer_is_no
// where a step cannot be done; wrong_call or file_trouble where a lesson cannot be read.
int check_lessons(const std::vector<std::string>& lessons) {
  Lines lines;
  ExitCode end = ExitCode::done;
  std::size_t wrong = 0;
  for (const std::string& name : lessons) {
    stop_if_interrupted();
    const std::string shown = quoted_text(name, longest_path);
    try {
      const std::size_t steps = print_findings(load_lesson(name), shown, lines);
      if (steps == 0) continue;
      ++wrong;
      if (end == ExitCode::done) end = ExitCode::answer_is_no;
    } catch (const ReadError& error) {
      ++wrong;
      end = std::max(end, exit_code_of(error.kind()));
      lines.write(fmt::format("{}: cannot be read as a lesson", shown));
      say("{}\n", error.what());
    }
  }
  lines.write(fmt::format("{} {}, {} wrong", lessons.size(), lessons.size() == 1 ? "lesson" : "lessons", wrong));
  return static_cast<int>(end);
}

struct CheckOptions {
  std::vector<std::string> paths;  // a folder of cases, or lessons
  std::string folder;              // the former
  std::vector<std::string> only;
  std::vector<std::string> update;
  bool updates = false;       // --update is there, with names or without
  bool asks_nothing = false;  // --yes
  std::string report;
  int jobs = 1;
  bool json = false;
  std::optional<Renderer> renderer;

  // Whether there is nothing but paths.
  bool is_plain() const { return only.empty() && !updates && report.empty() && jobs == 1 && !json && !renderer; }
};

// Where it cannot be read, that is said later.
std::vector<std::filesystem::path> files_in(const std::string& folder) {
  std::error_code ignored;
  return paths_in(folder, ignored);
}

// Of a folder the cases and the goldens beside them: all that is read there.
std::vector<std::string> files_read(const std::string& folder) {
  if (may_be_lesson(folder)) return {folder};
  std::vector<std::string> read;
  for (const std::filesystem::path& path : files_in(folder)) {
    if (path.extension() != ".toml") continue;
    read.push_back(path.string());
    read.push_back(std::filesystem::path(path).replace_extension(".png").string());
  }
  return read;
}

// The report's pictures would lie among the goldens.
void refuse_report_among_cases(const CheckOptions& options) {
  std::error_code error;
  if (options.report.empty() || !std::filesystem::equivalent(options.report, options.folder, error)) return;
  throw Failure(ExitCode::wrong_call, fmt::format("--report {}: this is the folder of the cases; name another",
                                                  quoted_text(options.report, longest_path)));
}

// The files of a report, of those that are there.
std::vector<std::string> report_files(const std::string& folder) {
  std::vector<std::string> paths;
  for (const std::filesystem::path& path : files_in(folder)) {
    if (ReportFolder::may_write(path.string())) paths.push_back(path.string());
  }
  return paths;
}

void refuse_report_over_scenes(const CheckOptions& options, const std::vector<Case>& cases) {
  const std::vector<std::string> problems = sources_overwritten_by(cases, report_files(options.report));
  if (!problems.empty()) {
    throw Failure(ExitCode::wrong_call,
                  fmt::format("--report {}: {}", quoted_text(options.report, longest_path), fmt::join(problems, "\n")));
  }
}

// The report's pictures are named after their cases.
void refuse_names_too_long_for_report(const CheckReport& report) {
  constexpr std::size_t longest = 240;  // of the 255 bytes that a file's name may have
  for (const Case* const each : report.cases) {
    if (report.to_folder.empty() || each->name.size() <= longest) continue;
    throw Failure(ExitCode::wrong_call,
                  fmt::format("{}: the name has {} bytes, and the pictures of a report have longer ones; choose one of "
                              "{} bytes at most",
                              quoted_text(each->path, longest_path), each->name.size(), longest));
  }
}

void tell_of_failure(const Verdict& verdict) {
  say("{}: {}\n", quoted_text(verdict.name), verdict.reason);
  if (!verdict.remark.empty()) say("  {}\n", verdict.remark);
  if (!verdict.remedy.empty()) say("  if the new picture is right: {}\n", verdict.remedy);
}

void tell_of_leniency(const std::vector<Verdict>& verdicts) {
  const auto count = std::ranges::count_if(verdicts, &Verdict::is_lenient);
  if (count == 0) return;
  say("{} of the goldens {} drawn by another renderer than this graphics card. Their cases state no tolerance, so "
      "{:g} % of the pixels may differ by more than {} of 255: docs/check.md.\n",
      count, count == 1 ? "was" : "were", 100.0 * graphics_card_tolerance.share, graphics_card_tolerance.channel);
}

// Hands on each verdict with its case, in the order of `chosen`, and tells on a terminal how far it is. Throws what
// evaluate_all() does; and Failure: interrupted.
void evaluate_with_progress(const std::vector<Case>& cases, const std::vector<const Case*>& chosen,
                            const Evaluation& how, const Lines& lines,
                            const std::function<void(const Case&, Verdict)>& take) {
  {
    std::size_t done = 0;
    Progress progress("checking", static_cast<std::int64_t>(chosen.size()), !lines.is_terminal());
    evaluate_all(cases, chosen, how, [&](Verdict verdict) {
      take(*chosen[done++], std::move(verdict));
      progress.at(static_cast<std::int64_t>(done));
    });
  }
  stop_if_interrupted();
}

// Those that a new golden would mend, and whether others fail. Says what is wrong with each.
struct FailedCases {
  std::vector<const Case*> mendable;
  bool has_others = false;
};
FailedCases failed_cases(const CheckOptions& options, const std::vector<Case>& cases, Lines& lines) {
  const std::vector<const Case*> all = chosen_cases(cases, {}, "--update");
  FailedCases failed;
  const auto sort_in = [&](const Case& checked, const Verdict& verdict) {
    if (!verdict.passes) {
      lines.write(fmt::format("FAIL {}  {}{}", quoted_text(verdict.name, longest_path), verdict.reason,
                              verdict.remedy.empty() && !verdict.is_file_trouble ? "; no new golden mends that" : ""));
    }
    if (!verdict.remedy.empty()) failed.mendable.push_back(&checked);
    failed.has_others = failed.has_others || (!verdict.passes && verdict.remedy.empty());
  };
  evaluate_with_progress(cases, all, {.folder = options.folder, .renderer = options.renderer}, lines, sort_in);
  return failed;
}

bool is_agreed(const CheckOptions& options, std::size_t count) {
  say("Look first at what 'ghostforce check {} --report DIR' shows. {} [y/N] ",
      quoted_text(options.folder, longest_path),
      count == 1 ? "Store a new golden for this case?" : fmt::format("Store new goldens for these {} cases?", count));
  const InputLine line = read_line(STDIN_FILENO);
  if (!line.is_whole) say("\n");
  // Also where the newline is missing: a script may leave it out.
  return line.text == "y" || line.text == "Y" || line.text == "yes";
}

int update(const CheckOptions& options) {
  const std::vector<Case> cases = read_case_folder(options.folder);
  Lines lines;
  // CLI11 gives an option without its words one empty word.
  const bool is_named = options.update != std::vector<std::string>{""};
  const FailedCases failed = is_named ? FailedCases{} : failed_cases(options, cases, lines);
  const std::vector<const Case*> chosen = is_named ? chosen_cases(cases, options.update, "--update") : failed.mendable;
  if (chosen.empty()) {
    lines.write("no case needs a new golden");
    return static_cast<int>(failed.has_others ? ExitCode::answer_is_no : ExitCode::done);
  }
  if (!is_named && !options.asks_nothing && !is_agreed(options, chosen.size())) {
    lines.write("nothing was stored; --yes stores without a question");
    return static_cast<int>(ExitCode::answer_is_no);
  }
  const StoredGoldens stored = update_goldens(cases, chosen, options.renderer);
  for (const std::string& line : stored.lines) lines.write(line);
  return static_cast<int>(stored.has_wrong_numbers ? ExitCode::answer_is_no : ExitCode::done);
}

// `has_report` is true from when the report is written.
int check_cases(const CheckOptions& options, bool& has_report) {
  const std::vector<Case> cases = read_case_folder(options.folder);
  CheckReport report{
      .folder = options.folder, .to_folder = options.report, .cases = chosen_cases(cases, options.only, "--only")};
  refuse_report_over_scenes(options, cases);
  refuse_names_too_long_for_report(report);
  std::optional<ReportFolder> to_folder;
  if (!options.report.empty()) to_folder.emplace(options.report);

  Lines lines;
  const auto write_line = [&](const std::string& line) {
    if (!options.json) lines.write(line);
  };
  const Evaluation evaluation{.folder = options.folder,
                              .wants_pictures = to_folder.has_value(),
                              .jobs = options.jobs,
                              .renderer = options.renderer};
  evaluate_with_progress(cases, report.cases, evaluation, lines, [&](const Case&, Verdict verdict) {
    if (to_folder) to_folder->take_pictures(verdict);
    const std::string name = quoted_text(verdict.name, longest_path);
    write_line(verdict.passes ? fmt::format("pass {}", name) : fmt::format("FAIL {}  {}", name, verdict.reason));
    report.verdicts.push_back(std::move(verdict));
  });
  if (to_folder) to_folder->write(report);
  has_report = to_folder.has_value();
  write_line(report.counts());
  if (options.json) lines.write(report_as_json(report));
  for (const Verdict& verdict : report.verdicts) {
    if (!verdict.passes) tell_of_failure(verdict);
  }
  tell_of_leniency(report.verdicts);
  if (std::ranges::any_of(report.verdicts, &Verdict::is_file_trouble)) return static_cast<int>(ExitCode::file_trouble);
  return static_cast<int>(report.failed() > 0 ? ExitCode::answer_is_no : ExitCode::done);
}

int check(const CheckOptions& options) {
  refuse_report_among_cases(options);
  bool has_report = false;
  try {
    return check_cases(options, has_report);
  } catch (...) {
    if (!options.report.empty() && !has_report) ReportFolder::remove_earlier_pages(options.report);
    throw;
  }
}

// What is neither a folder nor a file is most likely the name of a lesson where it is nearly one.
void refuse_mistyped_lesson(const CheckOptions& options) {
  for (const std::string& path : options.paths) {
    std::error_code error;
    if (may_be_lesson(path) || std::filesystem::status(path, error).type() != std::filesystem::file_type::not_found) {
      continue;
    }
    const std::string meant = did_you_mean(path, shipped_lesson_names());
    if (meant.empty()) continue;
    throw Failure(ExitCode::wrong_call,
                  fmt::format("there is no folder or lesson '{}'{}", quoted_text(path, longest_path), meant));
  }
}

int check_any(CheckOptions& options) {
  refuse_mistyped_lesson(options);
  const auto lessons = std::ranges::count_if(options.paths, may_be_lesson);
  const bool are_all_lessons = static_cast<std::size_t>(lessons) == options.paths.size();
  if (!are_all_lessons && options.paths.size() > 1) {
    throw Failure(ExitCode::wrong_call, "check takes either one folder of cases or lessons; call it once for each");
  }
  if (are_all_lessons) {
    if (options.is_plain()) return check_lessons(options.paths);
    throw Failure(
        ExitCode::wrong_call,
        "--only, --update, --report, --jobs, --json and --renderer are for a folder of cases; leave them out");
  }
  options.folder = options.paths.front();
  return options.updates ? update(options) : check(options);
}

}  // namespace

std::function<int()> attach_check(CLI::App& command, FileOptions& files) {
  const auto options = std::make_shared<CheckOptions>();
  files.reads(
      add_option(command, "PATH", options->paths,
                 "The folder with the cases, each a NAME.toml with its golden NAME.png; or lessons, each a .toml "
                 "file or the name of a shipped one")
          ->required()
          ->check(suggests(shipped_lesson_names())),
      files_read);
  CLI::Option* const only = add_option(command, "--only CASE", options->only, "Check only these cases");
  CLI::Option* const update_option =
      add_option(command, "--update CASE", options->update,
                 "Store new goldens for these cases; without a name, for all that fail, after a question")
          ->expected(0, CLI::detail::expected_max_vector_size)
          ->excludes(only);
  command.add_flag("--yes", options->asks_nothing, "Store them without a question")->needs(update_option);
  files.writes(add_option(command, "--report DIR", options->report,
                          "Write report.html, junit.xml and the pictures of cases that fail into this folder")
                   ->check([](const std::string& folder) { return std::string(folder.empty() ? "name a folder" : ""); })
                   ->excludes(update_option),
               report_files);
  add_option(command, "--jobs N", options->jobs,
             fmt::format("Draw in N processes at once, 1 to {}; default: 1", most_jobs))
      ->check(whole_number_between(1, most_jobs))
      ->excludes(update_option);
  command.add_flag("--json", options->json, "Print one JSON document for programs instead of lines")
      ->excludes(update_option);
  attach_renderer(command, options->renderer);
  return [options, update_option] {
    options->updates = update_option->count() > 0;
    return check_any(*options);
  };
}

}  // namespace ghostforce
