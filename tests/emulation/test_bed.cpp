#include "tests/emulation/test_bed.h"

#include <cerrno>
#include <filesystem>
#include <stdexcept>

#include <dlfcn.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <umockdev.h>
#include <unistd.h>

namespace ghostforce {

TestBed::TestBed() : testbed_(umockdev_testbed_new()) {
  // umockdev's library sleeps for no time after each call that it forwards, which takes as long as the thread's timers
  // may be off: 50 us, unless told otherwise. As the servo's thread does; threads that are made later inherit it.
  prctl(PR_SET_TIMERSLACK, 1UL, 0UL, 0UL, 0UL);
  // Only now: umockdev remembers the first answer.
  if (!umockdev_in_mock_environment()) throw std::runtime_error("start this through umockdev-wrapper");
  gchar* root = umockdev_testbed_get_root_dir(testbed_);
  root_ = root;
  g_free(root);
  std::filesystem::create_directories(root_ + "/dev/bus/usb");
  add(std::string("P: ") + hub +
      "\nE: DEVNAME=/dev/bus/usb/001/001\nE: DEVTYPE=usb_device\nE: SUBSYSTEM=usb\nA: busnum=1\\n\nA: devnum=1\\n\n"
      "A: speed=480\\n\nA: bConfigurationValue=1\\n\nA: bDeviceClass=09\\n\nA: idVendor=1d6b\\n\nA: idProduct=0002\\n\n"
      "H: descriptors=12010002090001406b1d020000060302010109021900010100e0000904000001090000000705810304000c\n");
}

TestBed::~TestBed() {
  g_object_unref(testbed_);
}

DeviceFile TestBed::make_file(const std::string& path, KernelDoor::Open open) {
  DeviceFile file;
  file.path = path;
  file.terminal = std::make_unique<Terminal>();
  const std::filesystem::path name = root_ + path;
  const std::filesystem::path socket = root_ + "/ioctl" + path;
  std::filesystem::create_directories(name.parent_path());
  std::filesystem::create_directories(socket.parent_path());
  file.door = std::make_unique<KernelDoor>(socket, std::move(open));
  std::filesystem::create_symlink(file.terminal->path(), name);
  return file;
}

std::string DeviceFile::number() const {
  const dev_t number = terminal->number();
  return std::to_string(major(number)) + ":" + std::to_string(minor(number));
}

void TestBed::remove_name(const std::string& path) {
  unlink((root_ + path).c_str());
  unlink((root_ + "/ioctl" + path).c_str());
}

void TestBed::make_unreadable(const std::string& path) {
  std::filesystem::remove(root_ + path);
  std::filesystem::create_directory(root_ + path);  // no mode keeps root from reading
}

void TestBed::set_mode(const std::string& path, mode_t mode) {
  if (chmod((root_ + path).c_str(), mode) != 0) throw std::runtime_error("cannot change the mode of " + path);
}

void TestBed::add(const std::string& description) {
  GError* error = nullptr;
  umockdev_testbed_add_from_string(testbed_, description.c_str(), &error);
  if (error == nullptr) return;
  const std::string message = error->message;
  g_error_free(error);
  throw std::runtime_error(message + " in:\n" + description);
}

void TestBed::remove(const std::string& syspath) {
  const std::string path = "/sys" + syspath;
  umockdev_testbed_uevent(testbed_, path.c_str(), "remove");
  umockdev_testbed_remove_device(testbed_, path.c_str());
  // umockdev leaves the link by the device's number, which the next device may have again.
  const std::filesystem::path links = root_ + "/sys/dev/char";
  if (!std::filesystem::exists(links)) return;
  for (const auto& link : std::filesystem::directory_iterator(links)) {
    if (!std::filesystem::exists(link.path())) std::filesystem::remove(link.path());
  }
}

std::string hex_of(const std::string& bytes) {
  static constexpr char digits[] = "0123456789abcdef";
  std::string text;
  for (const char letter : bytes) {
    const auto byte = static_cast<unsigned char>(letter);
    text += digits[byte >> 4U];
    text += digits[byte & 15U];
  }
  return text;
}

}  // namespace ghostforce

// In place of the C library's, for umockdev. A program that closes its socket in the moment in which it is to be told of
// a device is told nothing, as the kernel has it; umockdev would abort.
extern "C" ssize_t sendmsg(int socket, const msghdr* message, int flags) {
  static const auto send_on = reinterpret_cast<ssize_t (*)(int, const msghdr*, int)>(dlsym(RTLD_NEXT, "sendmsg"));
  const ssize_t sent = send_on(socket, message, flags);
  if (sent >= 0 || errno != ECONNREFUSED) return sent;
  std::size_t size = 0;
  for (std::size_t i = 0; i < message->msg_iovlen; ++i) size += message->msg_iov[i].iov_len;
  return static_cast<ssize_t>(size);
}
