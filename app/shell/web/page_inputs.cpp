#include "app/shell/web/page_inputs.h"

#include <algorithm>
#include <span>
#include <utility>

#include <emscripten.h>
#include <imgui.h>

#include "app/shell/input_link.h"
#include "app/shell/spacemouse_input_link.h"
#include "device/spacemouse/spacemouse_report.h"

EM_JS_DEPS(browser_spacemouse, "$stringToUTF8")
// clang-format off
EM_JS(bool, has_hid, (), { return Boolean(navigator.hid); })
EM_JS(void, begin_spacemouse, (void* input, void* buffer, int buffer_size, int logitech, int connexion, int usage_page,
                               int usage, int absent, int not_allowed, int not_opened), {
  const hid = navigator.hid;
  const mice = Module["spaceMice"] ||= new Map();
  // Another scene makes another input: the person has not chosen it just now.
  const is_chosen = mice.size === 0;
  const filters = [logitech, connexion].map((vendorId) => ({ vendorId, usagePage: usage_page, usage }));
  const is_one = (device) => filters.some((filter) => filter.vendorId === device.vendorId && device.collections.some(
      (each) => each.usagePage === filter.usagePage && each.usage === filter.usage));
  let device = null;
  let is_searching = false;
  let is_over = false;
  const take = (event) => {
    const size = Math.min(event.data.byteLength, buffer_size);
    HEAPU8.set(new Uint8Array(event.data.buffer, event.data.byteOffset, size), buffer);
    _ghostforce_spacemouse_report(input, event.reportId, size);
  };
  // The first that can be opened. Returns what is in the way, or nothing.
  const open_one_of = async (devices) => {
    let trouble = absent;
    for (const each of devices.filter(is_one)) {
      try {
        if (!each.opened) await each.open();
      } catch (error) {
        trouble = not_opened;
        continue;
      }
      if (is_over) {
        each.close().catch(() => {});
        return;
      }
      device = each;
      device.addEventListener("inputreport", take);
      stringToUTF8(device.productName, buffer, buffer_size);
      _ghostforce_spacemouse_opened(input);
      return;
    }
    return trouble;
  };
  const search = async (asks) => {
    if (device || is_searching) return;
    is_searching = true;
    let trouble;
    try {
      await null;  // the input before this one ends meanwhile,
      await Module["spaceMouseClosing"];  // and lets go of its device
      trouble = await open_one_of(await hid.getDevices());
      if (trouble !== undefined && asks && !is_over && navigator.userActivation.isActive) {
        const chosen = await hid.requestDevice({ filters });
        if (chosen.length > 0) trouble = await open_one_of(chosen);
      }
    } catch (error) {
      trouble = error.name === "SecurityError" ? not_allowed : absent;
    }
    is_searching = false;
    if (trouble !== undefined && !is_over) _ghostforce_spacemouse_missing(input, trouble);
  };
  const come = () => search(false);
  const leave = (event) => {
    if (event.device !== device) return;
    device.removeEventListener("inputreport", take);
    device = null;
    _ghostforce_spacemouse_missing(input, absent);
  };
  hid.addEventListener("connect", come);
  hid.addEventListener("disconnect", leave);
  mice.set(input, {
    ask: () => search(true),
    end() {
      is_over = true;
      hid.removeEventListener("connect", come);
      hid.removeEventListener("disconnect", leave);
      device?.removeEventListener("inputreport", take);
      if (device) Module["spaceMouseClosing"] = device.close().catch(() => {});
    },
  });
  search(is_chosen);
})
EM_JS(void, ask_for_spacemouse, (void* input), { Module["spaceMice"].get(input).ask(); })
EM_JS(void, end_spacemouse, (void* input), {
  Module["spaceMice"].get(input).end();
  Module["spaceMice"].delete(input);
})
// clang-format on

namespace ghostforce {
  namespace {

  constexpr SpaceMouseWords spacemouse_words{
      .absent =
          "This page has none yet. Plug one in and press the button: the browser asks which one the page may use.",
      .not_allowed =
          "The browser does not let this page ask for one. If the page is part of another one, open it by itself.",
      .not_opened =
          "One is plugged in, but the browser cannot open it: is another program using it? On Linux, 'ghostforce "
          "doctor "
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
      {{spacemouse_hand}},
      [](const Scene&, const InputOptions&) { return std::make_unique<BrowserSpaceMouseInput>(); }};

  }  // namespace

  std::vector<InputEntry> page_inputs() {
    std::vector<InputEntry> devices;
    if (BrowserSpaceMouseInput::is_offered()) devices.push_back(linked<BrowserSpaceMouseLink>(browser_spacemouse_kind));
    return portable_inputs({}, devices);
  }

  struct BrowserSpaceMouseInput::Events {
    static BrowserSpaceMouseInput& input_of(void* input) { return *static_cast<BrowserSpaceMouseInput*>(input); }

    static void opened(void* input) { input_of(input).open_with_name(input_of(input).buffer_text()); }
    static void missing(void* input, int trouble) {
      input_of(input).be_without(static_cast<SpaceMouseReading::Trouble>(trouble));
    }
    static void report(void* input, int number, int size) {
      input_of(input).take(static_cast<std::uint8_t>(number), static_cast<std::size_t>(size));
    }
  };

  bool BrowserSpaceMouseInput::is_offered() {
    return has_hid();
  }

  BrowserSpaceMouseInput::BrowserSpaceMouseInput() {
    using Trouble = SpaceMouseReading::Trouble;
    begin_spacemouse(this, buffer_.data(), static_cast<int>(buffer_.size()), logitech_vendor, connexion_vendor,
                     desktop_usage_page, multi_axis_controller_usage, static_cast<int>(Trouble::absent),
                     static_cast<int>(Trouble::not_allowed), static_cast<int>(Trouble::not_opened));
  }

  BrowserSpaceMouseInput::~BrowserSpaceMouseInput() {
    end_spacemouse(this);
  }

  void BrowserSpaceMouseInput::ask() {
    ask_for_spacemouse(this);
  }

  std::string_view BrowserSpaceMouseInput::buffer_text() const noexcept {
    const auto end = std::ranges::find(buffer_, 0);
    return {reinterpret_cast<const char*>(buffer_.data()), static_cast<std::size_t>(end - buffer_.begin())};
  }

  void BrowserSpaceMouseInput::open_with_name(std::string_view name) noexcept {
    reading_.trouble = SpaceMouseReading::Trouble::none;
    reading_.connection = ++connections_;
    reading_.name = {};
    std::ranges::copy(name.substr(0, reading_.name.size() - 1), reading_.name.begin());
    publish(reading_);
  }

  void BrowserSpaceMouseInput::be_without(SpaceMouseReading::Trouble trouble) noexcept {
    state_ = {};
    show(state_, reading_);
    reading_.trouble = trouble;
    reading_.connection = 0;
    publish(reading_);
  }

  void BrowserSpaceMouseInput::take(std::uint8_t number, std::size_t size) noexcept {
    if (!take_report(number, std::span(buffer_).first(size), state_)) return;
    ++reading_.reports;
    show(state_, reading_);
    publish(reading_);
  }

}  // namespace ghostforce
extern "C" {
EMSCRIPTEN_KEEPALIVE void ghostforce_spacemouse_opened(void* input) {
  ghostforce::BrowserSpaceMouseInput::Events::opened(input);
}
EMSCRIPTEN_KEEPALIVE void ghostforce_spacemouse_missing(void* input, int trouble) {
  ghostforce::BrowserSpaceMouseInput::Events::missing(input, trouble);
}
EMSCRIPTEN_KEEPALIVE void ghostforce_spacemouse_report(void* input, int number, int size) {
  ghostforce::BrowserSpaceMouseInput::Events::report(input, number, size);
}
}  // extern "C"
