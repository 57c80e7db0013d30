// A run read back: what `simulate`, `replay` and recordings write (run.h), once from its beginning to its end.
// What a crash leaves is taken: a last line that is cut, lost samples that are told, a header without rows. Whatever
// else is damaged is an error with the line's number. Not for the servo thread.
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "app/files/run.h"

namespace ghostforce {

// Takes one tick after the other. `run` is what was told up to there; its warnings come with the end.
using TakeTick = std::function<void(const RunFacts& run, const RunTick& tick)>;

// `shown_path` is what warnings and messages call the file. Throws ReadError(wrong) where the text is no run, is
// damaged, or is longer than a scene may be (most_ticks), which a damaged time makes of it.
Run read_run(std::string_view text, std::string_view shown_path);

// With progress on a terminal. Every tick is kept: about 1.2 GB for an hour at 1 kHz. Throws
// ReadError: unreadable where the file cannot be read, or its ticks have no room in the memory; wrong as above; and
// Failure(interrupted).
Run load_run(const std::string& path);

// The same without keeping a tick, however long the run is. `doing` is what the progress on a terminal is called.
RunFacts stream_run(const std::string& path, std::string_view doing, bool shows_progress, const TakeTick& take);

}  // namespace ghostforce
