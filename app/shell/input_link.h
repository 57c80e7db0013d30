// InputLink: what the window does with the input in use, frame by frame, and what that input shows on the screen. The
// servo owns the input; its link, made together with it, is the only one here that knows of which class it is. A new
// input is a file for it in device, and a row in portable_inputs(); one with something to show has a file for its link
// too. A link is for the UI thread; the lists of inputs are for any, and to make an input allocates and may throw.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/base/failure.h"
#include "app/shell/receipt.h"
#include "app/state/session.h"
#include "core/scene.h"
#include "core/snapshot.h"
#include "device/falcon/falcon.h"
#include "device/haply/haply.h"
#include "device/input/input.h"
#include "device/report/input_choice.h"
#include "device/virtual_falcon/virtual_link.h"
#include "device/virtual_haply/haply_fault.h"

namespace ghostforce {

// What making an input may need besides the scene.
struct InputOptions {
  FalconOptions falcon;
  HaplyOptions haply;
  InjectedFault injected_fault;             // of the virtual Falcon
  InjectedHaplyFault injected_haply_fault;  // of the virtual Haply
  VirtualLink::Clock virtual_falcon_clock = VirtualLink::Clock::monotonic;
  std::shared_ptr<const GoalPath>
      recorded_hand{};  // what replay replays; null: none is loaded, replay the scene's path
};

struct InputKind : InputChoice {
  bool is_scripted = false;        // gives the same goal at the same tick in each run, and starts where its path does
  bool needs_recording = false;    // InputOptions::recorded_hand
  bool hand_is_simulated = false;  // though it has motors: a rehearsal
};

// A kind, and how one is made of it: as the class that it is.
template <typename Made>
struct InputMaker : InputKind {
  std::function<std::unique_ptr<Made>(const Scene&, const InputOptions&)> make;
};

// How a run of the window ended: for scripts a number, for the people who read their logs a sentence.
struct EndOfRun {
  ExitCode code = ExitCode::done;
  std::string words;  // empty where all went well
};

// As it is, for an input with which nothing is to be done.
class InputLink {
 public:
  InputLink() = default;
  InputLink(const Input&, const Scene&, const InputOptions&) {}
  InputLink(const InputLink&) = delete;
  InputLink& operator=(const InputLink&) = delete;
  virtual ~InputLink() = default;

  // Once, before the first tick of the input. What the input changes in how the window behaves it says to the session.
  virtual void begin(Session& /*session*/) {}

  // Each sample of the run that is on the screen, in their order.
  virtual void add(const Snapshot& /*snapshot*/) {}

  // Often, whether a frame is drawn or not: what the input knows by now.
  virtual void poll() {}

  // What of that the screen shows; everything that is not the input's is in the reading already.
  virtual void fill(LoopReading& /*reading*/) const {}

  // At the end of a frame, before the session goes to the servo: what the input is told. `interval_s`: of real time.
  virtual void send(Session& /*session*/, double /*interval_s*/) {}

  // Nothing comes from the input while the person does nothing and time is paused: it need not be looked at often.
  virtual bool is_idle() const noexcept { return true; }

  // A device is looked for or opened, which takes the system as long as it takes: ticks that come late meanwhile say
  // nothing about the loop.
  virtual bool is_opening() const noexcept { return false; }

  // What the reading's draw_input shows has changed since the last frame; the rest of the reading tells it by itself.
  virtual bool has_news() const noexcept { return false; }

  // Why another input may not take its place now, in words; empty: it may.
  virtual std::string why_not_leave() { return {}; }

  // For the receipt of a session: the device as it is now, and what is wrong with it, by its name in files.
  virtual std::optional<DeviceFacts> device() const { return {}; }
  virtual std::string_view fault() const noexcept { return {}; }

  // Where the readiness that it shows does not tell it.
  virtual EndOfRun end() const { return {}; }
};

struct LinkedInput {
  std::unique_ptr<Input> input;
  std::unique_ptr<InputLink> link;  // must not outlive the input
};

// A row of the list of inputs that the window is given.
struct InputEntry : InputKind {
  std::function<LinkedInput(const Scene&, const InputOptions&)> make;
};

// The row for what this maker makes: each with a Link(input, scene, options, more...).
template <typename Link, typename Made, typename... More>
InputEntry linked(const InputMaker<Made>& maker, const More&... more) {
  return {maker, [make = maker.make, more...](const Scene& scene, const InputOptions& options) {
            std::unique_ptr<Made> input = make(scene, options);
            auto link = std::make_unique<Link>(*input, scene, options, more...);
            return LinkedInput{std::move(input), std::move(link)};
          }};
}

// The input in the hand of the scene, which may tremble, drift and change its grip; a virtual device has such a hand
// itself.
LinkedInput make_in_hand_of(const Scene& scene, const InputEntry& entry, const InputOptions& options);

// Null when none has that name.
const InputEntry* find_input(std::span<const InputEntry> inputs, std::string_view name) noexcept;

// The inputs as a person may choose among them. `has_recording`: one is loaded that can be replayed.
std::vector<InputChoice> choices_of(std::span<const InputEntry> inputs, bool has_recording);

// To an input whose goal the pointer of the window moves.
class PointerLink : public InputLink {
 public:
  PointerLink(PointerTarget& target, const Scene&, const InputOptions&) : target_(target) {}

  void begin(Session& session) override;
  void fill(LoopReading& reading) const override { reading.refused += target_.ignored_moves(); }
  void send(Session& session, double interval_s) override;

 private:
  PointerTarget& target_;
  Vector<2> sent_goal_{0.0};
  std::uint32_t restarts_ = 0;
};

// --- The inputs that need nothing but this program ---

class FalconInput;
class VirtualFalconInput;
struct FalconReport;

// How far a Falcon is, found out by who knows what to do about it; may be empty.
using ReadinessOf =
    std::function<std::vector<ReadinessStepState>(const FalconReport& report, const MotorReport& motors)>;

extern const InputMaker<VirtualFalconInput> virtual_falcon_kind;

// In the order in which people see them. `devices`: those that this front of the program adds, which come before what
// rehearses them; the desktop's are in app/cli/desktop_inputs.h.
std::vector<InputEntry> portable_inputs(const ReadinessOf& readiness_of, const std::vector<InputEntry>& devices = {});

// A link that is more than a few lines is in a file of its own, which gives its row of the list.
InputEntry circle_entry();
InputEntry virtual_falcon_entry(const ReadinessOf& readiness_of);
// Of a Falcon on whatever cable the maker gives it.
InputEntry falcon_entry(const InputMaker<FalconInput>& maker, const ReadinessOf& readiness_of);

}  // namespace ghostforce
