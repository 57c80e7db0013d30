#include "app/files/descriptor.h"

#include <cerrno>

#include <fcntl.h>

namespace ghostforce {
namespace {

int error_of(int (*sync)(int), int descriptor) noexcept {
  while (sync(descriptor) != 0) {
    if (errno == EINTR) continue;
    const bool is_impossible = errno == EINVAL || errno == EROFS || errno == ENOSYS || errno == EOPNOTSUPP;
    return is_impossible ? 0 : errno;
  }
  return 0;
}

}  // namespace

int sync_file(int descriptor) noexcept {
  return error_of(fsync, descriptor);
}

int sync_data(int descriptor) noexcept {
  return error_of(fdatasync, descriptor);
}

int sync_folder(const std::filesystem::path& folder) noexcept {
  const char* const path = folder.empty() ? "." : folder.c_str();
  const int descriptor = open(path, O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return 0;
  const int error = sync_file(descriptor);
  close(descriptor);
  return error;
}

}  // namespace ghostforce
