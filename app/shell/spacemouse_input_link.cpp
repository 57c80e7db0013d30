#include "app/shell/spacemouse_input_link.h"

namespace ghostforce {

EndOfRun end_with(SpaceMouseReading::Trouble trouble) {
  switch (trouble) {
    case SpaceMouseReading::Trouble::none:
      return {};
    case SpaceMouseReading::Trouble::absent:
      return {ExitCode::device_absent, "No SpaceMouse is plugged in. Plug one in, or choose another --input."};
    case SpaceMouseReading::Trouble::not_allowed:
      return {ExitCode::device_refused,
              "This user may not open the SpaceMouse. Run 'ghostforce doctor --install-udev' once, then plug it in "
              "again."};
    case SpaceMouseReading::Trouble::not_opened:
      return {ExitCode::device_refused, "The SpaceMouse cannot be opened. Close the other program that has it."};
  }
  return {};
}

void SpaceMouseInputLink::fill(LoopReading& reading) const {
  reading.draw_input = [this](const PanelContext& context) { draw_spacemouse(context, reading_, words_); };
}

void SpaceMouseInputLink::poll() {
  const SpaceMouseReading& now = input_.reading();
  has_news_ = has_news_ || now.trouble != reading_.trouble || now.connection != reading_.connection ||
              now.reports != reading_.reports;
  reading_ = now;
}

void SpaceMouseInputLink::send(Session& session, double /*interval_s*/) {
  input_.set(session.spacemouse);
  has_news_ = false;
}

}  // namespace ghostforce
