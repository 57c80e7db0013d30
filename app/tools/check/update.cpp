#include "app/tools/check/case_folder.h"

#include <algorithm>
#include <deque>
#include <filesystem>
#include <map>
#include <system_error>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/base/failure.h"
#include "app/base/interruption.h"
#include "app/base/progress.h"
#include "app/base/quoted.h"
#include "app/base/shell_word.h"
#include "app/files/input_file.h"
#include "app/files/output_file.h"
#include "app/files/png_file.h"
#include "app/files/png_writer.h"
#include "app/files/read_error.h"
#include "app/tools/check/rendered_cases.h"
#include "app/tools/check/verdict.h"

namespace ghostforce {
namespace {

void refuse_cases_without_golden(const std::vector<const Case*>& chosen) {
  std::vector<std::string> problems;
  for (const Case* const each : chosen) {
    if (each->expectation == Expectation::golden) continue;
    problems.push_back(fmt::format("{}: {} has no golden to update: it is compared with the picture of {}",
                                   place_words(each->other_place), quoted_text(each->name), quoted_text(each->other)));
  }
  if (!problems.empty()) throw Failure(ExitCode::wrong_call, fmt::format("{}", fmt::join(problems, "\n")));
}

// Whether what is written to the path would come to lie outside the folder in which the path is.
bool leads_out(const std::filesystem::path& path) {
  std::error_code error;
  const std::filesystem::path folder = std::filesystem::weakly_canonical(path.parent_path() / ".", error);
  const std::filesystem::path end = std::filesystem::weakly_canonical(path, error);
  return std::mismatch(folder.begin(), folder.end(), end.begin(), end.end()).first != folder.end();
}

// Drawing takes long, a pipe would take what is drawn for ever, and who sends a folder of cases with a link in it could
// have any file overwritten.
void refuse_what_cannot_be_written(const std::vector<Case>& all, const std::vector<const Case*>& chosen) {
  std::vector<std::string> written;
  for (const Case* const each : chosen) written.insert(written.end(), {each->golden_path(), each->path});
  if (const std::vector<std::string> inputs = sources_overwritten_by(all, written); !inputs.empty()) {
    throw Failure(ExitCode::wrong_call, fmt::format("{}", fmt::join(inputs, "\n")));
  }
  std::vector<std::string> problems;
  std::map<std::filesystem::path, std::string> targets;  // and by which path each was reached
  for (const Case* const each : chosen) {
    const std::string golden = each->golden_path();
    if (const std::string_view kind = kind_instead_of_file(golden); !kind.empty()) {
      problems.push_back(
          fmt::format("{} cannot be written: it is {}; remove it", quoted_text(golden, longest_path), kind));
      continue;
    }
    std::error_code unknown;
    if (std::filesystem::weakly_canonical(golden, unknown).extension() != ".png") {
      problems.push_back(fmt::format("{} cannot be written: it is a link to a file that is not a picture; remove it",
                                     quoted_text(golden, longest_path)));
    }
    for (const std::string& path : {golden, each->path}) {
      const auto [same, is_new] = targets.try_emplace(std::filesystem::weakly_canonical(path, unknown), path);
      if (!is_new) {
        problems.push_back(
            fmt::format("{} cannot be written: it is a link to the same file as {}; replace it with a file",
                        quoted_text(path, longest_path), quoted_text(same->second, longest_path)));
      }
      if (!leads_out(path)) continue;
      problems.push_back(fmt::format(
          "{} cannot be written: it is a link that leads out of its folder; replace it with the file itself",
          quoted_text(path, longest_path)));
    }
  }
  if (!problems.empty()) throw Failure(ExitCode::file_trouble, fmt::format("{}", fmt::join(problems, "\n")));
}

bool is_stored(const Case& each, const Image& image) {
  std::error_code unknown;
  if (!std::filesystem::exists(each.golden_path(), unknown)) return false;
  try {
    PngFile golden(each.golden_path());
    return golden.width() == image.width && golden.height() == image.height && golden.read() == image;
  } catch (const ReadError&) {
    return false;  // what cannot be read is to be replaced
  }
}

// On the disk already; commit_all() puts it in place in the end.
void add_file(std::deque<OutputFile>& files, const std::string& path, const std::string& content) {
  OutputFile& file = files.emplace_back(path);
  file.write(content);
  file.finish();
}

}  // namespace

StoredGoldens update_goldens(const std::vector<Case>& all, const std::vector<const Case*>& chosen,
                             std::optional<Renderer> renderer) {
  refuse_cases_without_golden(chosen);
  refuse_what_cannot_be_written(all, chosen);
  RenderedCases rendered(all, chosen, renderer);
  std::deque<OutputFile> files;
  StoredGoldens stored;
  Progress progress("drawing", static_cast<std::int64_t>(chosen.size()), true);
  for (const Case* const each : chosen) {
    stop_if_interrupted();
    const RenderedCase drawn = rendered.draw(each->name);
    const std::string path = each->golden_path();
    const bool is_equal = is_stored(*each, drawn.image);
    if (!is_equal) add_file(files, path, png_bytes(drawn.image));
    if (!is_equal || !each->origin) {
      const std::string before = content_of(*each).text;
      const std::string after = with_origin(before, drawn.origin, each->path);
      if (after != before) add_file(files, each->path, after);
    }
    const std::string shown = quoted_text(path, longest_path);
    stored.lines.push_back(is_equal ? fmt::format("{} is already identical and stays as it is", shown)
                                    : fmt::format("wrote {}; look at it before you commit it", shown));
    if (const std::string wrong = wrong_numbers(check_numbers(*each, drawn.numbers)); !wrong.empty()) {
      stored.has_wrong_numbers = true;
      stored.lines.back() += fmt::format("; {} still fails: {}", quoted_text(each->name), wrong);
    }
    progress.at(static_cast<std::int64_t>(stored.lines.size()));
  }
  stop_if_interrupted();
  OutputFile::commit_all(files);
  return stored;
}

std::string update_command(std::string_view folder, std::string_view name) {
  // What begins with a dash would be taken for an option.
  const std::string from_here = folder.starts_with('-') ? fmt::format("./{}", folder) : std::string(folder);
  return fmt::format("ghostforce check {} --update{}{}", shell_word(from_here), name.starts_with('-') ? "=" : " ",
                     shell_word(name));
}

}  // namespace ghostforce
