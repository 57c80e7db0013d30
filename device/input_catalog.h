// The one list of inputs: the command line, the input panel and the tests walk it. A new kind of input is its own file
// and one row in input_catalog.cpp. Immutable after start, any thread; making an input allocates and may throw.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "core/scene.h"
#include "device/falcon/falcon.h"
#include "device/falcon_usb/usb_search.h"
#include "device/input/input.h"
#include "device/virtual_falcon/virtual_link.h"

namespace ghostforce {

// What making an input may need besides the scene.
struct InputOptions {
  FalconOptions falcon;
  UsbId falcon_id = falcon_usb_id;
  std::string falcon_serial{};  // empty: the first of them
  Misbehaviour misbehaviour;    // of the virtual Falcon
  VirtualLink::Clock virtual_falcon_clock = VirtualLink::Clock::monotonic;
  std::shared_ptr<const GoalPath> recorded_hand{};  // what replay replays; null: none is loaded, the scene's path
};

struct InputKind {
  std::string_view name;      // on the command line
  std::string_view title;     // on screen
  std::string_view sentence;  // what it does, for a person who hovers over it
  std::unique_ptr<Input> (*make)(const Scene&, const InputOptions&);
  bool is_scripted = false;      // the same goal at the same tick every time: it starts where its path does
  bool needs_recording = false;  // InputOptions::recorded_hand
};

std::span<const InputKind> input_catalog() noexcept;

// Null when no kind has that name.
const InputKind* find_input(std::string_view name) noexcept;

}  // namespace ghostforce
