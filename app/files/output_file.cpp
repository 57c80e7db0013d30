#include "app/files/output_file.h"

#include <algorithm>
#include <cerrno>
#include <climits>
#include <cstdio>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <fmt/core.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include "app/base/interruption.h"
#include "app/base/quoted.h"
#include "app/base/typed_text.h"
#include "app/files/descriptor.h"
#include "app/files/part_file.h"

namespace ghostforce {
namespace {

constexpr std::size_t buffer_size = 1 << 16;

// What is open already is written on as it was opened, and no other file takes its place. -1: no such name.
int descriptor_named(std::string_view path) {
  for (const std::string_view folder : {"/dev/fd/", "/proc/self/fd/"}) {
    if (!path.starts_with(folder)) continue;
    if (const auto descriptor = number_in<int>(path.substr(folder.size()))) return *descriptor;
  }
  return -1;
}

// As far as anybody can tell; of a file nobody waits for a reader.
bool is_file(int descriptor) {
  struct stat status {};
  return fstat(descriptor, &status) != 0 || S_ISREG(status.st_mode);
}

}  // namespace

std::filesystem::path end_of_links(std::filesystem::path path) {
  constexpr int longest_chain = 40;  // as Linux has it
  std::error_code no_link;
  for (int i = 0; i < longest_chain; ++i) {
    const std::filesystem::path next = std::filesystem::read_symlink(path, no_link);
    if (no_link) break;
    path = next.is_absolute() ? next : path.parent_path() / next;
  }
  return path;
}

std::string reason_of(int error) {
  const std::string reason = std::generic_category().message(error);
  switch (error) {
    case ENOENT:
      return reason + "; create the folder, or name another";
    case EACCES:
    case EPERM:
    case EROFS:
      return reason + "; change its permissions, or name another";
    case EISDIR:
      return reason + "; name a file in it";
    case ENOSPC:
    case EDQUOT:
      return reason + "; make room, or name another";
    case ENAMETOOLONG:
      return reason + "; choose a shorter one";
    case EMFILE:
    case ENFILE:
      return reason + "; close other programs, or raise the limit of open files (ulimit -n)";
    default:
      return reason + "; name another";
  }
}

OutputFile::OutputFile(const std::string& path) : shown_(path) {
  if (path == "-" || path == "/dev/stdout") {
    shown_ = "standard output";
    descriptor_ = STDOUT_FILENO;
    has_reader_ = !is_file(descriptor_);
    return;
  }
  if (const int open = descriptor_named(path); open >= 0) {
    // What this program has opened for itself is nothing that a shell has opened.
    const int flags = fcntl(open, F_GETFD);
    descriptor_ = flags >= 0 && (flags & FD_CLOEXEC) == 0 ? fcntl(open, F_DUPFD_CLOEXEC, 0) : -1;
    if (descriptor_ < 0) fail(flags < 0 ? errno : EBADF);
    has_reader_ = !is_file(descriptor_);
    return;
  }
  struct stat status {};
  const bool exists = stat(path.c_str(), &status) == 0;
  if (!exists && errno != ENOENT) fail(errno);
  if (exists && S_ISDIR(status.st_mode)) fail(EISDIR);
  if (exists && !S_ISREG(status.st_mode)) {
    // A pipe or a device: nothing to put in its place.
    descriptor_ = open_unless_interrupted(path.c_str(), O_WRONLY | O_CLOEXEC);
    if (descriptor_ < 0) fail(errno);
    has_reader_ = true;
    return;
  }
  if (exists && access(path.c_str(), W_OK) != 0) fail(errno);

  const std::filesystem::path target = end_of_links(path);
  if (target.filename().empty()) fail(path.empty() ? ENOENT : EISDIR);
  remove_dead_part_files(target.parent_path());
  const PartFile part = make_part_file(target.parent_path());
  if (part.descriptor < 0) fail(errno);
  descriptor_ = part.descriptor;
  temporary_ = part.path;
  if (exists) fchmod(descriptor_, status.st_mode & 07777);  // as far as that is allowed
  target_ = target;
}

OutputFile::~OutputFile() {
  if (is_in_place_) {
    if (temporary_.empty()) {
      unlink(target_.c_str());
    } else {
      exchange_names(temporary_, target_);
    }
  }
  remove_temporary();
  // Last: the lock on the temporary file goes with it.
  if (descriptor_ >= 0 && descriptor_ != STDOUT_FILENO) close(descriptor_);
}

void OutputFile::remove_temporary() noexcept {
  if (!temporary_.empty()) unlink(temporary_.c_str());
  temporary_.clear();
}

void OutputFile::write(std::string_view text) {
  if (buffer_.size() + text.size() > buffer_size) flush();
  buffer_ += text;
  if (buffer_.size() >= buffer_size) flush();
}

void OutputFile::rewrite(std::size_t at, std::string_view text) {
  flush();
  while (!text.empty()) {
    const ssize_t written = pwrite(descriptor_, text.data(), text.size(), static_cast<off_t>(at));
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) fail(errno);
    at += static_cast<std::size_t>(written);
    text.remove_prefix(static_cast<std::size_t>(written));
  }
}

void OutputFile::flush() {
  std::string_view rest = buffer_;
  while (!rest.empty()) {
    const ssize_t written = write_some(rest);
    if (written >= 0) {
      rest.remove_prefix(static_cast<std::size_t>(written));
    } else if (errno == EINTR || errno == EAGAIN) {
      if (!finishes_) stop_if_interrupted();
    } else {
      fail(errno);
    }
  }
  buffer_.clear();
}

// As write(2).
ssize_t OutputFile::write_some(std::string_view text) const {
  if (has_reader_) {
    if (!finishes_) {
      wait_to_write(descriptor_);
    } else if (!wait_for_reader(descriptor_)) {
      stop_if_interrupted();
    }
    // A pipe that can be written to takes this much at once.
    text = text.substr(0, PIPE_BUF);
  }
  return ::write(descriptor_, text.data(), text.size());
}

void OutputFile::finish() {
  flush();
  buffer_.shrink_to_fit();
  if (descriptor_ == STDOUT_FILENO) return;
  if (const int error = sync_file(descriptor_); error != 0) fail(error);
  // Some file systems tell only at a close that the disk is full. The lock stays with the descriptor itself.
  if (const int copy = fcntl(descriptor_, F_DUPFD_CLOEXEC, 0); copy >= 0 && close(copy) != 0 && errno != EINTR) {
    fail(errno);
  }
}

void OutputFile::put_in_place() {
  if (temporary_.empty()) return;
  struct stat status {};
  const bool is_new = lstat(target_.c_str(), &status) != 0;
  if (!is_new && S_ISDIR(status.st_mode)) fail(EISDIR);
  // The old file gets the temporary name.
  const int old = open(target_.c_str(), O_WRONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
  if (old >= 0) lock_part_file(old);
  is_in_place_ = exchange_names(temporary_, target_);
  if (old >= 0) close(is_in_place_ ? std::exchange(descriptor_, old) : old);
  if (is_in_place_) return;
  // Nothing is there yet, or names cannot be exchanged here.
  if (std::rename(temporary_.c_str(), target_.c_str()) != 0) fail(errno);
  temporary_.clear();
  is_in_place_ = is_new;
}

void OutputFile::keep() noexcept {
  is_in_place_ = false;
  remove_temporary();
}

void OutputFile::commit() {
  finish();
  if (temporary_.empty()) return;
  put_in_place();
  if (const int error = sync_folder(std::filesystem::path(target_).parent_path()); error != 0) fail(error);
  keep();
}

void OutputFile::commit_all(std::deque<OutputFile>& files, std::set<std::filesystem::path> folders) {
  // A full disk shows itself here, while all that was there before is still in its place.
  for (OutputFile& file : files) {
    file.finish();
    if (!file.temporary_.empty()) folders.insert(std::filesystem::path(file.target_).parent_path());
  }
  for (OutputFile& file : files) file.put_in_place();
  for (const std::filesystem::path& folder : folders) {
    if (const int error = sync_folder(folder); error != 0) {
      throw Failure(ExitCode::file_trouble, fmt::format("nothing can be written to {}: {}",
                                                        quoted_text(folder.string(), longest_path), reason_of(error)));
    }
  }
  for (OutputFile& file : files) file.keep();
}

bool OutputFile::is_terminal() const noexcept {
  return isatty(descriptor_) != 0;
}

void OutputFile::fail(int error) const {
  if (error == EINTR) stop_if_interrupted();
  if (error == EPIPE) throw BrokenPipe();
  throw Failure(ExitCode::file_trouble,
                fmt::format("{} cannot be written: {}", quoted_text(shown_, longest_path), reason_of(error)));
}

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

int open_growing_file(const std::string& path) noexcept {
  return open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_APPEND | O_CLOEXEC, 0666);
}

Failure no_growing_file(const std::string& path, std::string_view kind, int error) {
  const std::string shown = quoted_text(path, longest_path);
  return Failure(ExitCode::file_trouble,
                 error == EEXIST ? fmt::format("{} already exists, and {} never overwrites a file; choose another name",
                                               shown, kind)
                                 : fmt::format("{} cannot be written: {}", shown, reason_of(error)));
}

int append_whole(int descriptor, std::string_view text) noexcept {
  while (!text.empty()) {
    const ssize_t count = write(descriptor, text.data(), text.size());
    if (count >= 0) {
      text.remove_prefix(static_cast<std::size_t>(count));
    } else if (errno != EINTR) {
      return errno;
    }
  }
  return 0;
}

}  // namespace ghostforce
