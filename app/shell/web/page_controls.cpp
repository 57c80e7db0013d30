#include "app/shell/web/page_controls.h"

#include <array>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/shell/web/browser.h"

namespace ghostforce {
namespace {

using Json = nlohmann::ordered_json;

// In the order of their ids; page_controls.js makes an element of each.
constexpr std::array kind_names{"group",  "dialog", "choices", "folded", "rows",   "text",   "told",
                                "status", "alert",  "button",  "file",   "toggle", "choice", "range"};
static_assert(kind_names.size() == static_cast<std::size_t>(StageControlKind::range) + 1);

// What has nothing to say is left out.
Json json_of(const StageControl& control) {
  Json json{
      {"id", control.id}, {"kind", kind_names.at(static_cast<std::size_t>(control.kind))}, {"words", control.words}};
  const auto add = [&](const char* name, const std::string& text) {
    if (!text.empty()) json[name] = text;
  };
  add("about", control.about);
  add("refusal", control.refusal);
  add("language", control.language);
  if (control.is_on) json["is_on"] = true;
  if (control.kind == StageControlKind::range) {
    json["value"] = control.value;
    json["least"] = control.least;
    json["greatest"] = control.greatest;
    json["step"] = control.step;
  }
  for (const StageControl& part : control.parts) json["parts"].push_back(json_of(part));
  return json;
}

std::string css(const Colour& colour) {
  return fmt::format("#{:02x}{:02x}{:02x}", colour.red, colour.green, colour.blue);
}

std::vector<StageControl> controls_of(Application& application) {
  return stage_controls(application.session(), application.reading(), application.stage_reading());
}

}  // namespace

void PageControls::show(Application& application, bool is_later) {
  has_news_ = false;
  std::vector<StageControl> controls = controls_of(application);
  texts_.settle(controls, is_later && !application.stage_reading().moment.is_between());
  const Session& session = application.session();
  const Theme& theme = *session.appearance.theme;
  const StageLanguage::Controls& words = stage_language(session.language).controls;
  Json json{{"language", session.language},
            {"picture", session.face == Face::workbench ? words.picture_alone : words.picture},
            {"about", words.about},
            {"how_to", words.how_to},
            {"colours",
             {{"background", css(theme.background)},
              {"text", css(theme.text)},
              {"field", css(theme.panel_field)},
              {"accent", css(theme.accent)}}}};
  if (session.notice) json["notice_count"] = application.notice_count();
  for (const StageControl& each : controls) json["controls"].push_back(json_of(each));
  std::string text = json.dump();
  if (text == shown_) return;
  browser::show_controls(text);
  shown_ = std::move(text);
}

void PageControls::use(Application& application, std::string_view id, double value) {
  has_news_ = true;
  const std::vector<StageControl> controls = controls_of(application);
  const StageControl* const control = find_control(controls, id);
  if (control == nullptr || !control->act) return;
  if (!control->refusal.empty()) {
    // A range or a choice has already moved: it is to be shown as it is.
    shown_.clear();
    return application.show_notice(control->refusal, false, application.session().language);
  }
  for (const Action& action : control->act(value)) application.act_at_once(action);
}

}  // namespace ghostforce
