#include "device/motors/guard_memory.h"

namespace ghostforce {

GuardAction guard_action(bool has_ended, bool may_push, std::int64_t beat_ns, bool program_is_gone,
                         std::int64_t now_ns) noexcept {
  if (has_ended || (program_is_gone && !may_push)) return GuardAction::end;
  if (may_push && (program_is_gone || now_ns - beat_ns >= longest_beat_gap_ns)) return GuardAction::stop_motors;
  return GuardAction::watch;
}

}  // namespace ghostforce
