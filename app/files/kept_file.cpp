#include "app/files/kept_file.h"

#include <cerrno>
#include <system_error>

#include <fmt/format.h>

#include "app/base/failure.h"
#include "app/base/quoted.h"
#include "app/files/input_file.h"
#include "app/files/kept_text.h"
#include "app/files/output_file.h"

namespace ghostforce {
namespace {

namespace fs = std::filesystem;

std::string shown_path(const fs::path& path) {
  return quoted_text(path.string(), longest_path);
}

// Where a damaged file goes: a name that nothing has yet.
fs::path name_aside(const fs::path& file) {
  std::error_code error;
  for (int number = 1;; ++number) {
    fs::path aside = file;
    aside += number == 1 ? ".damaged" : fmt::format(".damaged-{}", number);
    if (!fs::exists(aside, error)) return aside;
  }
}

}  // namespace

bool load(const KeptFile& file, const std::function<void(TomlReader&)>& read, std::vector<std::string>& remarks) {
  std::error_code error;
  if (file.path.empty() || !fs::exists(file.path, error)) return false;
  const std::string shown = shown_path(file.path);
  if (!fs::is_regular_file(file.path, error)) {
    remarks.push_back(fmt::format("{} is not a file, so {}", shown, file.without));
    return false;
  }
  const FileContents contents = file_contents(file.path);
  if (contents.error != 0) {
    remarks.push_back(fmt::format("{} cannot be read ({}), so {}; the file stays as it is", shown,
                                  unreadable_words(contents.error), file.without));
    return false;
  }
  if (is_of_newer_format(contents.text)) {
    remarks.push_back(fmt::format("{} was written by a newer version of ghostforce, so {}; the file stays as it is",
                                  shown, file.without));
    return false;
  }
  TomlReader reader(file.path.string());
  if (reader.parse(contents.text)) read(reader);
  const std::vector<ReadProblem> problems = reader.problems();
  if (problems.empty()) return true;

  const std::string damage = damage_words(problems);
  const fs::path aside = name_aside(file.path);
  fs::rename(file.path, aside, error);
  remarks.push_back(
      error ? fmt::format("{} is damaged ({}), so {}", shown, damage, file.without)
            : fmt::format("{} was damaged ({}) and is now {}; {}", shown, damage, shown_path(aside), file.without));
  return false;
}

void save(const KeptFile& file, std::string_view text, std::span<const std::string_view> keys) {
  if (file.path.empty()) return;
  std::error_code error;
  const fs::path folder = file.path.parent_path();
  fs::create_directories(folder, error);
  if (error) {
    throw Failure(ExitCode::file_trouble, fmt::format("the folder {} cannot be made: {}, so {} not kept",
                                                      shown_path(folder), error.message(), file.contents));
  }
  // A link to nothing yet is followed; into a pipe nobody may ever look.
  if (const std::string_view kind = kind_instead_of_file(file.path); !kind.empty() && fs::exists(file.path, error)) {
    throw Failure(ExitCode::file_trouble, fmt::format("{} is {}, and {} kept in a file of this name; remove it",
                                                      shown_path(file.path), kind, file.contents));
  }
  // What cannot be read may be worth much all the same.
  const FileContents old = file_contents(file.path);
  if (old.error != 0 && old.error != ENOENT) {
    throw Failure(ExitCode::file_trouble,
                  fmt::format("{} cannot be read ({}) and stays as it is, and {} kept in a file of this name; repair "
                              "or remove it",
                              shown_path(file.path), std::generic_category().message(old.error), file.contents));
  }
  if (is_of_newer_format(old.text)) {
    throw Failure(ExitCode::file_trouble,
                  fmt::format("{} was written by a newer version of ghostforce and stays as it is, so {} not kept; to "
                              "begin anew, move it away",
                              shown_path(file.path), file.contents));
  }
  OutputFile output(file.path.string());
  output.write(kept_beginning(file.comment));
  output.write(text);
  if (!keys.empty()) output.write(without_named_keys(old.text, keys));
  output.commit();
}

void forget(const KeptFile& file) {
  std::error_code error;
  if (file.path.empty() || fs::remove(file.path, error) || !error) return;
  throw Failure(ExitCode::file_trouble, fmt::format("{} cannot be removed: {}, and {} still kept there",
                                                    shown_path(file.path), error.message(), file.contents));
}

}  // namespace ghostforce
