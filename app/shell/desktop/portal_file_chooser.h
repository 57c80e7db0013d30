// PortalFileChooser: the desktop's own dialogs for files, where its portal is on the person's D-Bus
// (org.freedesktop.portal.FileChooser). On a thread of its own; nobody waits for it. Without such a bus, a portal or
// libsystemd it is not there.
#pragma once

#include <atomic>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "app/files/descriptor.h"
#include "app/files/file_exchange.h"

namespace ghostforce {

class PortalFileChooser final : public FileChooser {
 public:
  // `parent`: the window that its dialogs belong to, as portals call it ("x11:1a"); empty: it has no name.
  explicit PortalFileChooser(std::string parent);
  ~PortalFileChooser() override;
  PortalFileChooser(const PortalFileChooser&) = delete;
  PortalFileChooser& operator=(const PortalFileChooser&) = delete;

  bool is_there() const noexcept override { return is_there_; }
  void ask(const FileQuestion& question) override;
  bool has_answer() const noexcept override { return has_answer_; }
  FileAnswer take_answer() override;

 private:
  void watch() noexcept;
  std::optional<FileQuestion> take_question();
  void answer(FileAnswer answer);

  std::string parent_;
  Descriptor news_;  // something to read: there is a question, or it is to end
  std::atomic<bool> is_ending_{false};
  std::atomic<bool> is_there_{false};
  std::atomic<bool> has_answer_{false};
  std::mutex mutex_;  // of the next two
  std::optional<FileQuestion> question_;
  FileAnswer answer_;
  std::thread thread_;  // last: it uses what stands above
};

}  // namespace ghostforce
