#include "app/cli/spacemouse_input_link.h"

#include "app/ui/panels/spacemouse.h"

namespace ghostforce {

EndOfVisit end_with(SpaceMouseReading::Trouble trouble) {
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
  reading.draw_input = [this](const PanelContext& context) { draw_spacemouse(context, reading_); };
}

bool SpaceMouseInputLink::has_news() {
  const SpaceMouseReading& now = input_.reading();
  return now.trouble != reading_.trouble || now.connection != reading_.connection || now.reports != reading_.reports;
}

}  // namespace ghostforce
