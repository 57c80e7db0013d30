#include "app/widgets/picture_card.h"

#include <algorithm>
#include <cmath>

#include "app/widgets/controls.h"
#include "app/widgets/symbol_text.h"

namespace ghostforce {
namespace {

// Words in a box, as many as it has room for.
void words_in_box(ImFont* font, Colour colour, ImVec2 corner, ImVec2 end, const std::string& words) {
  ImGui::PushFont(font, 0.0F);
  ImDrawList& draw_list = *ImGui::GetWindowDrawList();
  const ImVec2 room{end.x - corner.x, end.y - corner.y};
  draw_symbol_lines(draw_list, corner, packed(colour), as_much_as_fits(words, room), room.x);
  ImGui::PopFont();
}

}  // namespace

bool draw_picture_card(const PanelContext& context, const PictureCard& card, ImVec2 size, const CardPicture& picture) {
  const Theme& theme = context.theme;
  const float padding = card_padding * context.scale;
  const float picture_height = size.y - 2.0F * padding;
  const ImVec2 picture_size{std::round(picture_height * card.picture_width / card_picture_height),
                            std::round(picture_height)};
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const ImVec2 end{corner.x + size.x, corner.y + size.y};
  ImGui::PushID(card.id);
  const bool pressed = ImGui::InvisibleButton("card", size, ImGuiButtonFlags_EnableNav);
  ImGui::PopID();
  ImDrawList& draw_list = *ImGui::GetWindowDrawList();
  const float rounding = ImGui::GetStyle().FrameRounding;
  const bool is_hovered = ImGui::IsItemHovered();
  draw_list.AddRectFilled(corner, end, packed(mix(theme.panel_field, theme.accent, is_hovered ? 0.16 : 0.0)), rounding);
  draw_list.AddRect(corner, end, packed(card.is_marked ? theme.accent : theme.panel_border), rounding, 0,
                    (card.is_marked ? 2.5F : 1.0F) * context.scale);
  const ImVec2 from{corner.x + padding, corner.y + padding};
  const ImVec2 to{from.x + picture_size.x, from.y + picture_size.y};
  draw_list.AddImage(ImTextureID{picture(picture_size)}, from, to, {0.0F, 1.0F}, {1.0F, 0.0F});
  draw_list.AddRect(from, to, packed(theme.panel_border), 0.0F, 0, context.scale);
  const float line = ImGui::GetTextLineHeight();
  const ImVec2 words{to.x + 1.5F * padding, from.y};
  const float right = end.x - padding;
  const float bottom = end.y - padding;
  words_in_box(context.fonts.bold, theme.text, words, {right, words.y + 2.0F * line}, card.title);
  ImGui::PushFont(context.fonts.bold, 0.0F);
  const float title_width = symbol_text_width(card.title);
  ImGui::PopFont();
  const float about_y = words.y + (title_width > right - words.x ? 2.0F : 1.0F) * line;
  const float about_end = card.remark.empty() ? bottom : bottom - line;
  words_in_box(context.fonts.regular, card.is_open ? theme.accent : theme.faint_text, {words.x, about_y},
               {right, about_end}, card.about);
  if (!card.remark.empty()) {
    words_in_box(context.fonts.bold, theme.accent, {words.x, about_end}, {right, bottom + 1.0F}, card.remark);
  }
  return pressed;
}

CardRows::CardRows(const PanelContext& context, float card_width, int most_columns, std::size_t count, float beside) {
  const ImGuiStyle& style = ImGui::GetStyle();
  const auto most = static_cast<float>(most_columns);
  const float width = dialog_field_width(most * (card_width + 6.0F) + 14.0F, context);
  const float room = width - style.ScrollbarSize;
  columns_ = std::clamp(static_cast<int>(room / (card_width * context.scale)), 1, most_columns);
  const float gap = style.ItemSpacing.y;
  const auto columns = static_cast<float>(columns_);
  const auto rows = static_cast<float>((static_cast<int>(count) + columns_ - 1) / columns_);
  // Beside title, margins, field and buttons. Where these are as high as fingers want them, less.
  const float taller = std::max(0.0F, ImGui::GetFrameHeight() - 1.6F * ImGui::GetFontSize());
  const float rest = ImGui::GetIO().DisplaySize.y - beside * context.scale - 2.0F * gap - 3.0F * taller;
  // So that four lines of words fit.
  const float padding = 2.0F * card_padding * context.scale;
  const float lowest = 4.0F * ImGui::GetTextLineHeight() + 2.0F + padding;
  const float usual = card_picture_height * context.scale + padding;
  const float fitting = std::floor((rest + gap) / rows - gap);
  card_ = {std::floor((room - (columns - 1.0F) * gap) / columns), fitting < lowest ? usual : std::min(fitting, usual)};
  const float all = std::ceil(rows * (card_.y + gap) - gap);
  size_ = {width, all <= rest ? all : std::max(rest, card_.y)};
}

void CardRows::begin_card(std::size_t number) const {
  if (number % static_cast<std::size_t>(columns_) != 0) ImGui::SameLine();
}

}  // namespace ghostforce
