#include "app/files/output_folder.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <system_error>
#include <utility>

#include "app/base/failure.h"
#include "app/base/quoted.h"

namespace ghostforce {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const fs::path& path, const std::string& what) {
  throw Failure(ExitCode::file_trouble, fmt::format("{}: {}", quoted_text(path.string(), longest_path), what));
}

void remove_empty(const std::vector<fs::path>& folders) noexcept {
  std::error_code ignored;
  for (const fs::path& folder : folders) fs::remove(folder, ignored);
}

}  // namespace

OutputFolder::OutputFolder(const std::string& path) : path_(path) {
  if (path.empty()) refuse("''", "is not a folder; name one");
  std::error_code error;
  // A slash at the end names the same folder.
  fs::path innermost = path_.has_filename() ? path_ : path_.parent_path();
  std::vector<fs::path> missing;
  for (fs::path at = innermost; !at.empty() && !fs::exists(fs::symlink_status(at, error)); at = at.parent_path()) {
    missing.push_back(at);
  }
  std::ranges::reverse(missing);
  try {
    for (const fs::path& folder : missing) {
      if (fs::create_directory(folder, error)) {
        made_.insert(made_.begin(), folder);
      } else if (error) {
        refuse(folder, fmt::format("the folder cannot be created: {}", reason_of(error.value())));
      }
    }
    if (!fs::is_directory(path_, error)) refuse(path_, "is not a folder; name another, or move what is there");
    if (access(path_.c_str(), W_OK | X_OK) != 0) {
      refuse(path_, fmt::format("nothing can be written there: {}", reason_of(errno)));
    }
  } catch (...) {
    remove_empty(made_);
    throw;
  }
}

OutputFolder::~OutputFolder() {
  files_.clear();
  if (!is_committed_) remove_empty(made_);
}

void OutputFolder::write(const std::string& name, std::string_view content) {
  files_.emplace_back((path_ / name).string()).write(content);
}

void OutputFolder::commit() {
  std::set<fs::path> parents;  // of new folders
  for (const fs::path& folder : made_) parents.insert(folder.parent_path());
  OutputFile::commit_all(files_, std::move(parents));
  is_committed_ = true;
}

}  // namespace ghostforce
