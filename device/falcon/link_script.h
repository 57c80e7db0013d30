// LinkScript: what is sent to the chip and what it must answer, as a table of steps that are done one after another,
// without ever waiting: update() does what can be done now. Trivial to make; the tables must outlive it. The driver's
// thread; never allocates or throws.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>

#include "device/falcon/falcon_link.h"

namespace ghostforce {

struct LinkScriptStep {
  enum class Kind : std::uint8_t {
    request,              // the chip is asked for something
    send,                 // `bytes` go out
    stop,                 // the motors' zero goes out, ahead of everything; it is not waited for
    expect,               // `bytes` must come within `duration_ms`, whatever comes before them
    wait,                 // `duration_ms` pass
    await_clear_to_send,  // until the other side raises CTS, but `duration_ms` at most: not all devices do
    flush,                // what has come so far is thrown away
  };

  Kind kind;
  VendorRequest asked{};
  std::string_view bytes{};
  int duration_ms = 0;
};

constexpr LinkScriptStep ask(const VendorRequest& request) noexcept {
  return {.kind = LinkScriptStep::Kind::request, .asked = request};
}

enum class LinkProgress : std::uint8_t { running, done, failed };

class LinkScript {
 public:
  LinkScript() = default;
  explicit LinkScript(std::span<const LinkScriptStep> steps) noexcept : steps_(steps) {}

  // A request that the chip refuses or does not answer is asked this often.
  static constexpr int request_attempts = 3;

  // failed: an answer did not come, to a request least of all. The fault of a link is the caller's to look at.
  LinkProgress update(FalconLink& link) noexcept;

  // The chip has refused a request, each time that it was asked; the rest has been gone through without it.
  bool was_refused() const noexcept { return was_refused_; }

 private:
  LinkProgress pursue(const LinkScriptStep& step, FalconLink& link) noexcept;
  LinkProgress pursue_request(const FalconLink& link) noexcept;
  bool receives(std::string_view bytes, FalconLink& link) noexcept;

  std::span<const LinkScriptStep> steps_;
  std::size_t at_ = 0;
  bool has_begun_ = false;  // the step
  int attempts_ = 0;        // at a request
  bool was_refused_ = false;
  std::int64_t began_ns_ = 0;  // the step
  std::size_t received_ = 0;   // of its bytes
};

}  // namespace ghostforce
