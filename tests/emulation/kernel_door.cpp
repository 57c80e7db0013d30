#include "tests/emulation/kernel_door.h"

#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <system_error>

#include <sys/socket.h>
#include <sys/uio.h>
#include <sys/un.h>
#include <unistd.h>

namespace ghostforce {
namespace {

// Each message is three words, the first of which says what it is. In:
constexpr long call_ioctl = 1;  // request, argument
constexpr long call_read = 7;   // address, size
// Out:
constexpr long send_memory = 5;   // address, size; the bytes come back
constexpr long store_memory = 6;  // address, size; the bytes follow; nothing comes back
constexpr long done = 3;          // result, errno
constexpr long make_the_real_call = -100;

struct Message {
  long words[3];
};

bool send_all(int connection, const void* from, std::size_t size) {
  const auto* bytes = static_cast<const char*>(from);
  while (size > 0) {
    const ssize_t sent = send(connection, bytes, size, MSG_NOSIGNAL);
    if (sent < 0 && errno == EINTR) continue;
    if (sent <= 0) return false;
    bytes += sent;
    size -= static_cast<std::size_t>(sent);
  }
  return true;
}

bool receive_all(int connection, void* into, std::size_t size) {
  auto* bytes = static_cast<char*>(into);
  while (size > 0) {
    const ssize_t received = recv(connection, bytes, size, 0);
    if (received < 0 && errno == EINTR) continue;
    if (received <= 0) return false;
    bytes += received;
    size -= static_cast<std::size_t>(received);
  }
  return true;
}

}  // namespace

bool CallerMemory::fetch(std::uintptr_t address, void* into, std::size_t size) const {
  if (size == 0) return true;
  // One system call where this is allowed, a conversation where it is not.
  iovec here{into, size};
  iovec there{reinterpret_cast<void*>(address), size};
  if (process_vm_readv(process_, &here, 1, &there, 1, 0) == static_cast<ssize_t>(size)) return true;
  const Message message{{send_memory, static_cast<long>(address), static_cast<long>(size)}};
  return send_all(connection_, &message, sizeof message) && receive_all(connection_, into, size);
}

bool CallerMemory::store(std::uintptr_t address, const void* from, std::size_t size) const {
  if (size == 0) return true;
  const Message message{{store_memory, static_cast<long>(address), static_cast<long>(size)}};
  return send_all(connection_, &message, sizeof message) && send_all(connection_, from, size);
}

bool CallerMemory::has_gone() const {
  char byte = 0;
  return recv(connection_, &byte, 1, MSG_PEEK | MSG_DONTWAIT) == 0;
}

KernelDoor::KernelDoor(const std::string& socket_path, Open open) : socket_path_(socket_path), open_(std::move(open)) {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  if (socket_path.size() >= sizeof address.sun_path) throw std::runtime_error("too long for a socket: " + socket_path);
  std::memcpy(address.sun_path, socket_path.c_str(), socket_path.size() + 1);
  listener_ = socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
  unlink(socket_path.c_str());
  if (listener_ < 0 || bind(listener_, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0 ||
      listen(listener_, 16) != 0) {
    throw std::system_error(errno, std::generic_category(), socket_path);
  }
  acceptor_ = std::thread([this] { accept_all(); });
}

KernelDoor::~KernelDoor() {
  {
    const std::lock_guard lock(mutex_);
    is_closing_ = true;
    for (const int connection : connections_) shutdown(connection, SHUT_RDWR);
  }
  shutdown(listener_, SHUT_RDWR);
  acceptor_.join();
  for (std::thread& server : servers_) server.join();
  close(listener_);
  unlink(socket_path_.c_str());
}

void KernelDoor::accept_all() {
  while (true) {
    const int connection = accept4(listener_, nullptr, nullptr, SOCK_CLOEXEC);
    if (connection < 0) {
      if (errno == EINTR || errno == ECONNABORTED) continue;
      return;
    }
    const std::lock_guard lock(mutex_);
    if (is_closing_) {
      close(connection);
      return;
    }
    connections_.push_back(connection);
    servers_.emplace_back([this, connection] { serve(connection); });
  }
}

void KernelDoor::serve(int connection) {
  ucred peer{};
  socklen_t size = sizeof peer;
  getsockopt(connection, SOL_SOCKET, SO_PEERCRED, &peer, &size);
  const CallerMemory memory(connection, peer.pid);
  {
    const std::unique_ptr<OpenFile> file = open_(memory);
    Message call{};
    while (receive_all(connection, &call, sizeof call)) {
      CallResult result{make_the_real_call, 0};
      if (call.words[0] == call_ioctl) {
        result =
            file->ioctl(memory, static_cast<unsigned long>(call.words[1]), static_cast<std::uintptr_t>(call.words[2]));
      } else if (call.words[0] == call_read) {
        result =
            file->read(memory, static_cast<std::uintptr_t>(call.words[1]), static_cast<std::size_t>(call.words[2]));
      }
      const Message answer{{done, result.result, result.error}};
      if (!send_all(connection, &answer, sizeof answer)) break;
    }
  }
  {
    const std::lock_guard lock(mutex_);
    std::erase(connections_, connection);
  }
  close(connection);
}

}  // namespace ghostforce
