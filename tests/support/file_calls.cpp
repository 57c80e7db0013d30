#include "tests/support/file_calls.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <map>
#include <mutex>
#include <thread>

namespace ghostforce {
namespace {

struct Notes {
  std::mutex mutex;
  bool is_on = false;
  std::thread::id creator;
  std::vector<FileCall> calls;
  std::map<std::string, int, std::less<>> failing;
};

Notes& notes() {
  static Notes all;
  return all;
}

// The errno that the call fails with; 0: it goes on.
int note(std::string_view call, const std::string& path) {
  Notes& all = notes();
  const std::lock_guard lock(all.mutex);
  if (!all.is_on) return 0;
  struct stat status {};
  const bool is_there = stat(path.c_str(), &status) == 0;
  all.calls.push_back({std::string(call), path, is_there ? static_cast<std::size_t>(status.st_size) : 0,
                       std::this_thread::get_id() == all.creator});
  const auto failing = all.failing.find(call);
  return failing == all.failing.end() ? 0 : failing->second;
}

std::string path_of(int descriptor) {
  std::error_code ignored;
  return std::filesystem::read_symlink("/proc/self/fd/" + std::to_string(descriptor), ignored).string();
}

// As the C library's: −1 and errno.
template <typename... Arguments>
int do_or_fail(int error, long number, Arguments... arguments) {
  if (error == 0) return static_cast<int>(syscall(number, arguments...));
  errno = error;
  return -1;
}

}  // namespace

FileCalls::FileCalls() {
  Notes& all = notes();
  const std::lock_guard lock(all.mutex);
  all.is_on = true;
  all.creator = std::this_thread::get_id();
  all.calls.clear();
  all.failing.clear();
}

FileCalls::~FileCalls() {
  Notes& all = notes();
  const std::lock_guard lock(all.mutex);
  all.is_on = false;
}

std::vector<FileCall> FileCalls::all() const {
  const std::lock_guard lock(notes().mutex);
  return notes().calls;
}

std::ptrdiff_t FileCalls::count(std::string_view call, std::string_view path) const {
  const std::vector<FileCall> calls = all();
  return std::ranges::count_if(calls, [&](const FileCall& one) { return one.call == call && one.path == path; });
}

FileCall FileCalls::last(std::string_view call, std::string_view path) const {
  FileCall found;
  for (const FileCall& one : all()) {
    if (one.call == call && one.path == path) found = one;
  }
  return found;
}

bool FileCalls::was_made_by_this_thread(std::string_view call) const {
  const std::vector<FileCall> calls = all();
  return std::ranges::any_of(calls, [&](const FileCall& one) { return one.call == call && one.is_by_creator; });
}

void FileCalls::fail(std::string_view call, int error) {
  const std::lock_guard lock(notes().mutex);
  notes().failing[std::string(call)] = error;
}

}  // namespace ghostforce

extern "C" {

int fsync(int descriptor) {
  return ghostforce::do_or_fail(ghostforce::note("fsync", ghostforce::path_of(descriptor)), SYS_fsync, descriptor);
}

int fdatasync(int descriptor) {
  return ghostforce::do_or_fail(ghostforce::note("fdatasync", ghostforce::path_of(descriptor)), SYS_fdatasync,
                                descriptor);
}

int rename(const char* from, const char* to) noexcept {
  return ghostforce::do_or_fail(ghostforce::note("rename", to), SYS_renameat2, AT_FDCWD, from, AT_FDCWD, to, 0U);
}

int renameat2(int from_folder, const char* from, int to_folder, const char* to, unsigned int flags) noexcept {
  return ghostforce::do_or_fail(ghostforce::note("renameat2", to), SYS_renameat2, from_folder, from, to_folder, to,
                                flags);
}
}
