// The words that a frame of Dear ImGui shows, read from its draw lists: where each is, and which are cut off or lie on
// top of each other. After a frame; the scene's words lie beneath all windows and do not count.
#pragma once

#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <imgui_internal.h>

namespace ghostforce {

// Letters side by side.
struct ScreenWords {
  std::string text;
  std::string window;
  ImRect ink;
  ImRect clip;
};

namespace screen_text {

using Corner = std::pair<float, float>;

// Which letter is where in the atlas.
inline std::map<Corner, ImWchar> letters_in_atlas() {
  std::map<Corner, ImWchar> letters;
  ImFontAtlasBuilder& builder = *ImGui::GetIO().Fonts->Builder;
  for (int i = 0; i < builder.BakedPool.Size; ++i) {
    for (const ImFontGlyph& glyph : builder.BakedPool[i].Glyphs) {
      letters[{glyph.U0, glyph.V0}] = static_cast<ImWchar>(glyph.Codepoint);
    }
  }
  return letters;
}

inline std::string utf8(ImWchar letter) {
  std::array<char, 5> bytes{};
  ImTextCharToUtf8(bytes.data(), letter);
  return bytes.data();
}

inline void add_letter(std::vector<ScreenWords>& all, const ScreenWords& letter, bool is_next) {
  if (is_next && !all.empty()) {
    ScreenWords& last = all.back();
    const float height = std::max(last.ink.GetHeight(), letter.ink.GetHeight());
    const float gap = letter.ink.Min.x - last.ink.Max.x;
    const bool is_beside =
        letter.ink.Min.y < last.ink.Max.y + 0.5F * height && letter.ink.Max.y > last.ink.Min.y - 0.5F * height;
    if (is_beside && gap > -1.5F && gap < 0.8F * height) {
      if (gap > 0.22F * height) last.text += ' ';
      last.text += letter.text;
      last.ink.Add(letter.ink);
      return;
    }
  }
  all.push_back(letter);
}

// As it is called now. A list keeps the name that its window had when it was made, which may be gone.
inline std::string owner_of(const ImDrawList& list) {
  for (const ImGuiWindow* const window : ImGui::GetCurrentContext()->Windows) {
    if (window->DrawList == &list) return window->Name;
  }
  return list._OwnerName == nullptr ? "" : list._OwnerName;
}

inline void read_list(const ImDrawList& list, const std::map<Corner, ImWchar>& letters, std::vector<ScreenWords>& all) {
  const std::string window = owner_of(list);
  for (const ImDrawCmd& command : list.CmdBuffer) {
    const auto vertex = [&](unsigned int i) -> const ImDrawVert& {
      return list.VtxBuffer[static_cast<int>(command.VtxOffset + i)];
    };
    const auto index = [&](unsigned int i) -> unsigned int {
      return list.IdxBuffer[static_cast<int>(command.IdxOffset + i)];
    };
    bool is_next = false;
    for (unsigned int i = 0; i + 6 <= command.ElemCount;) {
      const unsigned int a = index(i);
      const bool is_quad = index(i + 1) == a + 1 && index(i + 2) == a + 2 && index(i + 3) == a &&
                           index(i + 4) == a + 2 && index(i + 5) == a + 3;
      const auto letter = is_quad ? letters.find({vertex(a).uv.x, vertex(a).uv.y}) : letters.end();
      if (letter == letters.end()) {
        i += 3;
        is_next = false;
        continue;
      }
      const ImVec4& clip = command.ClipRect;
      add_letter(all,
                 {utf8(letter->second), window, {vertex(a).pos, vertex(a + 2).pos}, {clip.x, clip.y, clip.z, clip.w}},
                 is_next);
      is_next = true;
      i += 6;
    }
  }
}

}  // namespace screen_text

inline std::vector<ScreenWords> words_on_screen() {
  std::vector<ScreenWords> all;
  const std::map<screen_text::Corner, ImWchar> letters = screen_text::letters_in_atlas();
  for (const ImDrawList* list : ImGui::GetDrawData()->CmdLists) {
    if (screen_text::owner_of(*list) != "##Background") screen_text::read_list(*list, letters, all);
  }
  return all;
}

// Words that lie wholly beyond the edge of their window are not drawn at all: they show in how far a window that cannot
// be scrolled would have to be.
inline void add_lost(std::vector<std::string>& faults) {
  constexpr float slack = 1.5F;  // [points]
  for (const ImGuiWindow* const window : ImGui::GetCurrentContext()->Windows) {
    if (!window->WasActive || (window->Flags & ImGuiWindowFlags_NoScrollWithMouse) == 0) continue;
    // What reaches into the margin is seen.
    const ImVec2 lost{window->ScrollMax.x - window->WindowPadding.x, window->ScrollMax.y - window->WindowPadding.y};
    if (lost.x > slack || lost.y > slack) {
      faults.push_back(fmt::format("{} points to the right or {} below are lost ({})", lost.x, lost.y, window->Name));
    }
  }
}

// A sentence for each. What is scrolled out of sight above or below is not cut off.
inline std::vector<std::string> faults_of(const std::vector<ScreenWords>& all) {
  constexpr float slack = 1.5F;  // [points]
  std::vector<std::string> faults;
  add_lost(faults);
  const auto about = [](const ScreenWords& words) {
    return fmt::format("'{}' ({}, at {:.0f}, {:.0f})", words.text, words.window, words.ink.Min.x, words.ink.Min.y);
  };
  for (const ScreenWords& words : all) {
    const ImGuiWindow* const window = ImGui::FindWindowByName(words.window.c_str());
    const bool scrolls =
        window != nullptr && window->ScrollMax.y > 0.0F && (window->Flags & ImGuiWindowFlags_NoScrollWithMouse) == 0;
    ImRect inked = words.ink;
    if (scrolls) {
      inked.Min.y = std::max(inked.Min.y, words.clip.Min.y);
      inked.Max.y = std::min(inked.Max.y, words.clip.Max.y);
    }
    ImRect clip = words.clip;
    clip.Expand(slack);
    if (!clip.Contains(inked)) faults.push_back(fmt::format("{} is cut off", about(words)));
    const bool has_underscore =
        words.text.find("k_") != std::string::npos || words.text.find("q_") != std::string::npos;
    if (has_underscore) faults.push_back(fmt::format("{} has no index", about(words)));
  }
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (std::size_t k = i + 1; k < all.size(); ++k) {
      if (all[i].window != all[k].window) continue;
      ImRect a = all[i].ink, b = all[k].ink;
      a.ClipWithFull(all[i].clip);
      b.ClipWithFull(all[k].clip);
      const float across = std::min(a.Max.x, b.Max.x) - std::max(a.Min.x, b.Min.x);
      const float down = std::min(a.Max.y, b.Max.y) - std::max(a.Min.y, b.Min.y);
      if (across > slack && down > slack) {
        faults.push_back(fmt::format("{} lies on {}", about(all[i]), about(all[k])));
      }
    }
  }
  return faults;
}

}  // namespace ghostforce
