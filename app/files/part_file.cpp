#include "app/files/part_file.h"

#include <dirent.h>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <memory>
#include <mutex>
#include <set>
#include <string_view>

#include <fmt/format.h>

namespace ghostforce {
namespace {

constexpr std::string_view begin = ".ghostforce-";
constexpr std::string_view end = ".part";

// Few enough to be sure that the folder, not bad luck, is the matter.
constexpr int tries = 100;

bool is_part_name(std::string_view name) noexcept {
  if (!name.starts_with(begin) || !name.ends_with(end) || name.size() <= begin.size() + end.size()) return false;
  name = name.substr(begin.size(), name.size() - begin.size() - end.size());
  return name.find_first_not_of("0123456789-") == std::string_view::npos;
}

bool leads_to(const std::string& path, int descriptor) noexcept {
  struct stat named {};
  struct stat opened {};
  return lstat(path.c_str(), &named) == 0 && fstat(descriptor, &opened) == 0 && named.st_dev == opened.st_dev &&
         named.st_ino == opened.st_ino;
}

// Whoever holds the lock may remove the file. Where there are no locks it is nobody's, and stays.
bool lock(int descriptor) noexcept {
  return flock(descriptor, LOCK_EX | LOCK_NB) == 0;
}

void remove_if_dead(const std::string& path) noexcept {
  const int descriptor = open(path.c_str(), O_RDWR | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
  if (descriptor < 0) return;
  struct stat status {};
  const bool is_file = fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode);
  if (is_file && lock(descriptor) && leads_to(path, descriptor)) unlink(path.c_str());
  close(descriptor);
}

// Many files may wait for the same commit, each open for the sake of its lock. False: that is all that the system
// allows.
bool allow_more_files() noexcept {
  rlimit limit{};
  if (getrlimit(RLIMIT_NOFILE, &limit) != 0 || limit.rlim_cur >= limit.rlim_max) return false;
  limit.rlim_cur = limit.rlim_max;
  return setrlimit(RLIMIT_NOFILE, &limit) == 0;
}

}  // namespace

PartFile make_part_file(const std::filesystem::path& folder) {
  static std::atomic<int> number = 0;
  for (int i = 0;; ++i) {
    // A short name of its own: the file's name with something added may be too long.
    PartFile part{folder / fmt::format("{}{}-{}{}", begin, getpid(), number++, end), -1};
    part.descriptor = open(part.path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (part.descriptor < 0 && errno == EMFILE && allow_more_files()) continue;
    if (part.descriptor < 0 && (errno != EEXIST || i == tries)) return part;
    if (part.descriptor < 0) continue;
    // Another process may have seen it before it was locked, and taken it for a dead one.
    if (!lock(part.descriptor) && errno == EWOULDBLOCK) {
      close(part.descriptor);
      continue;
    }
    if (leads_to(part.path, part.descriptor)) return part;
    close(part.descriptor);
  }
}

bool exchange_names(const std::string& one, const std::string& other) noexcept {
  return renameat2(AT_FDCWD, one.c_str(), AT_FDCWD, other.c_str(), RENAME_EXCHANGE) == 0;
}

void lock_part_file(int descriptor) noexcept {
  lock(descriptor);
}

void remove_dead_part_files(const std::filesystem::path& folder) {
  // Once for each folder: who writes a thousand files need not look a thousand times.
  static std::mutex mutex;
  static std::set<std::filesystem::path> cleaned;
  {
    const std::lock_guard lock(mutex);
    if (!cleaned.insert(folder).second) return;
  }
  const std::unique_ptr<DIR, int (*)(DIR*)> names(opendir(folder.empty() ? "." : folder.c_str()), closedir);
  if (!names) return;
  while (const dirent* const entry = readdir(names.get())) {
    if (is_part_name(entry->d_name)) remove_if_dead(folder / entry->d_name);
  }
}

}  // namespace ghostforce
