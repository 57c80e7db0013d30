// KernelDoor: answers the system calls that a program makes on an emulated device file. In that program umockdev's
// preloaded library sends its ioctl(), read() and write() on such a file through a unix socket, one connection per open
// file; this is the other end, with a thread for each of them. (umockdev's own end runs through GLib's main loop and is
// four times slower.)
//
// It may live in the program under test too: then it must not call, while it answers, anything that the preloaded
// library wraps under a lock of its own (read, write, ioctl). Times out never; throws when the socket cannot be made.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace ghostforce {

// The memory of the program that makes a system call, which waits meanwhile.
class CallerMemory {
 public:
  CallerMemory(int connection, int process) : connection_(connection), process_(process) {}

  // False: the program has gone, or has no such memory.
  bool fetch(std::uintptr_t address, void* into, std::size_t size) const;
  bool store(std::uintptr_t address, const void* from, std::size_t size) const;

  // The program has closed the file, or died, and the thread that serves it has yet to hear of it.
  bool has_gone() const;
  int process() const { return process_; }

 private:
  int connection_;
  int process_;
};

// What a system call returns: a result, or -1 and errno.
struct CallResult {
  long result = 0;
  int error = 0;

  static CallResult failure(int error) { return {-1, error}; }
};

// An emulated device file that a program has opened; gone when the program closes it or dies.
class OpenFile {
 public:
  virtual ~OpenFile() = default;
  virtual CallResult ioctl(const CallerMemory& memory, unsigned long request, std::uintptr_t argument) = 0;
  virtual CallResult read(const CallerMemory& memory, std::uintptr_t into, std::size_t size) = 0;
};

class KernelDoor {
 public:
  // What it is given stays as long as the file.
  using Open = std::function<std::unique_ptr<OpenFile>(const CallerMemory&)>;

  KernelDoor(const std::string& socket_path, Open open);
  KernelDoor(const KernelDoor&) = delete;
  KernelDoor& operator=(const KernelDoor&) = delete;
  // Waits until all its threads have ended; files that are still open then fail.
  ~KernelDoor();

 private:
  void accept_all();
  void serve(int connection);

  std::string socket_path_;
  Open open_;
  int listener_ = -1;
  std::mutex mutex_;  // of what follows
  bool is_closing_ = false;
  std::vector<int> connections_;
  std::vector<std::thread> servers_;
  std::thread acceptor_;
};

}  // namespace ghostforce
