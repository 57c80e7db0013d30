#include "device/motor_guard/guard_page.h"

namespace ghostforce {

GuardDeed deed_of(bool has_ended, bool may_push, std::int64_t beat_ns, bool program_is_gone,
                  std::int64_t now_ns) noexcept {
  if (has_ended || (program_is_gone && !may_push)) return GuardDeed::end;
  if (may_push && (program_is_gone || now_ns - beat_ns >= longest_beat_gap_ns)) return GuardDeed::stop_motors;
  return GuardDeed::watch;
}

}  // namespace ghostforce
