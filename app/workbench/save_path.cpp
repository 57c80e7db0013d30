#include "app/workbench/save_path.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <string_view>

#include <fmt/format.h>

#include "app/files/file_exchange.h"
#include "app/widgets/controls.h"

namespace ghostforce {
namespace {

namespace fs = std::filesystem;

struct Verdict {
  bool can_be_written;
  const char* caption;  // of the button
  std::string_view remark;
};

Verdict judge(const std::string& path) {
  const SavePlace& place = save_place();
  if (path.empty()) return {false, "Save", place.nothing_typed};
  if (!place.has_folders && path.find('/') != std::string::npos) return {false, "Save", "Leave out the slash."};
  std::error_code error;
  const fs::path folder = fs::path(path).parent_path();
  if (fs::is_directory(path, error)) return {false, "Save", "This is a folder; add a file name."};
  if (!folder.empty() && !fs::is_directory(folder, error)) return {false, "Save", "There is no such folder."};
  if (fs::exists(path, error)) return {true, "Replace", "This file exists and will be replaced."};
  return {true, "Save", place.new_file};
}

bool has_extension(const std::string& path, std::string_view extension) {
  if (path.size() <= extension.size() || path[path.size() - extension.size() - 1] != '.') return false;
  return std::equal(extension.begin(), extension.end(), path.end() - static_cast<std::ptrdiff_t>(extension.size()),
                    [](char a, char b) { return a == std::tolower(static_cast<unsigned char>(b)); });
}

}  // namespace

const char* format_of(const std::string& path, std::span<const char* const> formats) {
  const auto found = std::ranges::find_if(formats, [&](const char* format) { return has_extension(path, format); });
  return found == formats.end() ? nullptr : *found;
}

void draw_format_choice(std::string& path, std::span<const char* const> formats) {
  const char* const present = format_of(path, formats);
  for (const char* const format : formats) {
    if (format != formats.front()) ImGui::SameLine();
    if (ImGui::RadioButton(format, present == format)) {
      if (present != nullptr) path.resize(path.size() - std::string_view(present).size() - 1);
      path += fmt::format(".{}", format);
      return;
    }
  }
}

bool draw_save_path(const PanelContext& context) {
  Form& form = context.memory.form;
  if (form.belongs_to != context.session.dialog) ImGui::SetKeyboardFocusHere();
  const char* const browse_words = "Browse…";
  const ImGuiStyle& style = ImGui::GetStyle();
  const float browse_width = button_width(browse_words) + style.ItemSpacing.x;
  const bool can_browse = offers_place_chooser();
  ImGui::SetNextItemWidth(dialog_field_width(480.0F, context) - (can_browse ? browse_width : 0.0F));
  const bool entered = text_field("##path", "", form.path);
  if (can_browse) {
    ImGui::SameLine();
    if (ImGui::Button(browse_words)) {
      choose_file({.new_file = form.path});
      form.awaits_place = true;
    }
  }
  const Verdict verdict = judge(form.path);
  text_in(context.theme.faint_text, verdict.remark);
  ImGui::BeginDisabled(!verdict.can_be_written);
  const bool pressed = ImGui::Button(fmt::format("{}###save", verdict.caption).c_str());
  ImGui::EndDisabled();
  ImGui::SameLine();
  if (ImGui::Button("Cancel")) context.apply(CloseDialog{});
  return (entered || pressed) && verdict.can_be_written;
}

}  // namespace ghostforce
