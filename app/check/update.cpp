#include "app/check/update.h"

#include <filesystem>
#include <system_error>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/check/gallery.h"
#include "app/failure.h"
#include "app/file_kind.h"
#include "app/interruption.h"
#include "app/output_file.h"
#include "app/png_file.h"
#include "app/printable.h"
#include "app/progress.h"

namespace ghostforce {
namespace {

// A file to be written; empty content: it stays as it is.
struct Change {
  const Case* changed = nullptr;
  std::string golden;
  std::string text;
};

void refuse_cases_without_golden(const std::vector<const Case*>& chosen) {
  std::vector<std::string> problems;
  for (const Case* const each : chosen) {
    if (each->wanted == Wanted::golden) continue;
    problems.push_back(fmt::format("{}: {} has no golden to update: it is compared with the picture of {}",
                                   each->other_place, printable(each->name), printable(each->other)));
  }
  if (!problems.empty()) throw Failure(ExitCode::wrong_call, fmt::format("{}", fmt::join(problems, "\n")));
}

// Drawing takes long, and a pipe would take what is drawn for ever.
void refuse_goldens_that_are_no_files(const std::vector<const Case*>& chosen) {
  std::vector<std::string> problems;
  for (const Case* const each : chosen) {
    const std::string path = each->golden_path();
    const std::string_view kind = kind_instead_of_file(path);
    if (kind.empty()) continue;
    problems.push_back(fmt::format("{} cannot be written: it is {}; remove it", printable(path, longest_path), kind));
  }
  if (!problems.empty()) throw Failure(ExitCode::file_trouble, fmt::format("{}", fmt::join(problems, "\n")));
}

bool is_stored(const Case& each, const Image& image) {
  std::error_code unknown;
  if (!std::filesystem::exists(each.golden_path(), unknown)) return false;
  try {
    return read_png(each.golden_path()) == image;
  } catch (const Failure&) {
    return false;  // what cannot be read is to be replaced
  }
}

void write_whole(const std::string& path, const std::string& content) {
  OutputFile file(path);
  file.write(content);
  file.commit();
}

}  // namespace

std::vector<std::string> update_goldens(const std::vector<Case>& all, const std::vector<const Case*>& chosen) {
  refuse_cases_without_golden(chosen);
  refuse_goldens_that_are_no_files(chosen);
  Gallery gallery(all, chosen);
  std::vector<Change> changes;
  Progress progress("drawing", static_cast<std::int64_t>(chosen.size()), true);
  for (const Case* const each : chosen) {
    stop_if_interrupted();
    const DrawnCase drawn = gallery.draw(each->name);
    Change change{each, {}, {}};
    const bool is_equal = is_stored(*each, drawn.image);
    if (!is_equal) change.golden = png_bytes(drawn.image);
    if (!is_equal || !each->origin) change.text = with_origin(each->text, drawn.origin, each->path);
    changes.push_back(std::move(change));
    progress.at(static_cast<std::int64_t>(changes.size()));
  }
  stop_if_interrupted();
  // Only now, so that an interruption or a case that cannot be changed leaves the whole folder as it was.
  std::vector<std::string> lines;
  for (const Change& change : changes) {
    const std::string path = printable(change.changed->golden_path(), longest_path);
    if (!change.golden.empty()) {
      write_whole(change.changed->golden_path(), change.golden);
      lines.push_back(fmt::format("wrote {}; look at it before you commit it", path));
    } else {
      lines.push_back(fmt::format("{} is equal already and stays as it is", path));
    }
    if (!change.text.empty() && change.text != change.changed->text) write_whole(change.changed->path, change.text);
  }
  return lines;
}

}  // namespace ghostforce
