#include "app/shell/web/page_inputs.h"

#include <utility>

#include <imgui.h>

#include "app/shell/portable_inputs.h"
#include "app/shell/spacemouse_input_link.h"
#include "app/shell/web/browser_spacemouse_input.h"

namespace ghostforce {
namespace {

constexpr SpaceMouseWords spacemouse_words{
    .absent = "This page has none yet. Plug one in and press the button: the browser asks which one the page may use.",
    .not_allowed =
        "The browser does not let this page ask for one. If the page is part of another one, open it by itself.",
    .not_opened =
        "One is plugged in, but the browser cannot open it: is another program using it? On Linux, 'ghostforce doctor "
        "--install-udev' of the desktop program lets users open it."};

// With a button that has the browser ask for the device.
class BrowserSpaceMouseLink final : public SpaceMouseInputLink {
 public:
  BrowserSpaceMouseLink(BrowserSpaceMouseInput& input, const Scene& scene, const InputOptions& options)
      : SpaceMouseInputLink(input, scene, options, spacemouse_words), input_(input) {}

  void fill(LoopReading& reading) const override {
    SpaceMouseInputLink::fill(reading);
    reading.draw_input = [this, draw_rest = std::move(reading.draw_input)](const PanelContext& context) {
      if (!newest().connected() && ImGui::Button("Choose a SpaceMouse…")) input_.ask();
      draw_rest(context);
    };
  }

 private:
  BrowserSpaceMouseInput& input_;
};

const InputMaker<BrowserSpaceMouseInput> browser_spacemouse_kind{
    {{spacemouse_hand}}, [](const Scene&, const InputOptions&) { return std::make_unique<BrowserSpaceMouseInput>(); }};

}  // namespace

std::vector<InputEntry> page_inputs() {
  std::vector<InputEntry> devices;
  if (BrowserSpaceMouseInput::is_offered()) devices.push_back(linked<BrowserSpaceMouseLink>(browser_spacemouse_kind));
  return portable_inputs({}, devices);
}

}  // namespace ghostforce
