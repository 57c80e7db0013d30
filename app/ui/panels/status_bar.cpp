// The bar at the bottom: where the goal comes from, how the loop keeps time, which scene; and the ways to others.
#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "app/files/scene_file.h"
#include "app/session/key_bindings.h"
#include "app/ui/panels/panel_catalog.h"
#include "app/ui/widgets/controls.h"

namespace ghostforce {
namespace {

struct ShippedScene {
  std::string name;
  std::string title;
  std::string about;
};

const std::vector<ShippedScene>& shipped_scenes() {
  static const std::vector<ShippedScene> scenes = [] {
    std::vector<ShippedScene> list;
    for (const std::string_view name : shipped_scene_names()) {
      const Scene scene = load_scene(std::string(name));
      list.push_back({std::string(name), scene.title, scene.about});
    }
    // fig4-ratio5 comes before fig4-ratio10.
    std::ranges::sort(list, {}, [](const ShippedScene& scene) {
      const std::size_t digits = scene.name.find_last_not_of("0123456789") + 1;
      const std::string number = scene.name.substr(digits);
      return std::pair(scene.name.substr(0, digits), number.empty() ? 0 : std::stoi(number));
    });
    return list;
  }();
  return scenes;
}

void draw_scene_menu(Session& session) {
  if (!ImGui::BeginPopup("scenes")) return;
  close_popup_on_escape();
  for (const ShippedScene& scene : shipped_scenes()) {
    if (ImGui::MenuItem(scene.title.c_str(), scene.name.c_str(), scene.title == session.scene->title))
      session.requests.open_scene = scene.name;
    tooltip(scene.about);
  }
  ImGui::Separator();
  const auto item = [](const char* words, const char* keys) { return ImGui::MenuItem(words, keys); };
  if (item("Open a scene…", "Ctrl+O")) session.dialog = Dialog::open_scene;
  if (item("Save this scene…", "Ctrl+S")) session.dialog = Dialog::save_scene;
  if (item("Save a picture…", "Ctrl+P")) session.dialog = Dialog::save_picture;
  ImGui::Separator();
  if (item("Undo", "Ctrl+Z")) session.requests.undo = true;
  if (item("Redo", "Ctrl+Shift+Z")) session.requests.redo = true;
  ImGui::EndPopup();
}

// What a narrow bar cuts off at its end says so.
std::string shortened(const std::string& text, float room) {
  constexpr std::size_t longest = 200;  // bytes; no bar has room for more
  if (text.size() <= longest && ImGui::CalcTextSize(text.c_str()).x <= room) return text;
  std::string kept = text.substr(0, longest);
  do {
    // Whole letters: the bytes that go on a letter in UTF-8 begin with the bits 10.
    while (!kept.empty() && (static_cast<unsigned char>(kept.back()) & 0xC0U) == 0x80U) kept.pop_back();
    if (!kept.empty()) kept.pop_back();
  } while (!kept.empty() && ImGui::CalcTextSize((kept + "…").c_str()).x > room);
  return kept + "…";
}

}  // namespace

void draw_status_bar(const PanelContext& context) {
  Session& session = context.session;
  const LoopReading& loop = context.loop;
  std::string words = fmt::format("{}   ·   t = {:8.3f} s   ·   {:5.0f} ticks/s   ·   {:3} late", loop.input_title,
                                  context.snapshot.time_s, loop.rate_hz, loop.late_ticks);
  if (loop.dropped_samples > 0) words += fmt::format("   ·   {} samples dropped", loop.dropped_samples);
  if (loop.recording.is_on && loop.recording.dropped > 0) {
    words += fmt::format("   ·   {} samples not recorded", loop.recording.dropped);
  }
  if (loop.refused > 0) words += fmt::format("   ·   {} refused", loop.refused);
  if (loop.diverged) words = "Unstable: the device runs away. Change a setting, undo with Ctrl+Z, or press Alt+R.";
  const std::string remark = loop.remark.empty() ? "" : fmt::format("   ·   {}", loop.remark);
  const ImGuiStyle& style = ImGui::GetStyle();
  const auto width = [](const std::string& text) { return ImGui::CalcTextSize(text.c_str()).x; };
  const float spacing = style.ItemSpacing.x;
  const float help_width = width("F1  Help") + 2.0F * style.FramePadding.x;
  const float right_edge = ImGui::GetContentRegionMax().x;

  // From the right: help, the scene, and the loop's words in what remains.
  const float for_scene = right_edge - help_width - 2.0F * spacing - ImGui::GetCursorPosX() - width(words) -
                          2.0F * style.FramePadding.x - width("  ▾");
  const std::string title = shortened(session.scene->title, std::max(for_scene, 6.0F * ImGui::GetFontSize()));
  const std::string caption = title + "  ▾";
  const float scene_width = width(caption) + 2.0F * style.FramePadding.x;
  const float scene_x = right_edge - help_width - spacing - scene_width;
  const float room = scene_x - spacing - ImGui::GetCursorPosX();

  ImGui::SetCursorPosY(0.5F * (ImGui::GetWindowHeight() - ImGui::GetFrameHeight()));
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(shortened(words, room).c_str());
  tooltip("Who moves the goal, model time, ticks of the loop per second of real time, and ticks that came too late.");
  if (width(words) + width(remark) <= room) {
    ImGui::SameLine(0.0F, 0.0F);
    text_in(context.theme.faint_text, remark);
    tooltip("What the system grants the loop, so that its ticks come in time; ghostforce doctor says why not more.");
  }
  ImGui::SameLine(scene_x);
  if (ImGui::Button((caption + "###scene").c_str())) ImGui::OpenPopup("scenes");
  tooltip(session.scene->about);
  draw_scene_menu(session);
  ImGui::SameLine();
  if (ImGui::Button("F1  Help", {help_width, 0.0F})) open_dialog<Dialog::help>(session);
  tooltip("Every key and every gesture.");
}

}  // namespace ghostforce
