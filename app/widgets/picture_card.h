// Cards to choose something by: a picture with a title and a few words, in rows. Within a frame.
#pragma once

#include <cstddef>
#include <functional>
#include <string>

#include "app/widgets/panel_context.h"

namespace ghostforce {

struct PictureCard {
  int id = 0;  // among the cards of its window
  std::string title;
  std::string about;
  std::string remark{};          // below; may be empty
  float picture_width = 112.0F;  // of one as high as card_picture_height; in a lower card it is less wide
  bool is_marked = false;        // Enter takes it
  bool is_open = false;          // it is what is on the screen
};

inline constexpr float card_picture_height = 92.0F;
inline constexpr float card_padding = 4.0F;

// OpenGL's name for a picture of that size [points].
using CardPicture = std::function<unsigned int(ImVec2)>;

// True when it was pressed.
bool draw_picture_card(const PanelContext& context, const PictureCard& card, ImVec2 size, const CardPicture& picture);

// Where so many cards have room in a dialog. They are lower than usual where all are in sight then; else it scrolls.
class CardRows {
 public:
  // `card_width`: as a card would like to be; `beside`: height of the window that is not theirs [points].
  CardRows(const PanelContext& context, float card_width, int most_columns, std::size_t count, float beside = 200.0F);

  int columns() const noexcept { return columns_; }
  ImVec2 card_size() const noexcept { return card_; }
  ImVec2 size() const noexcept { return size_; }
  // Before each card, in their order.
  void begin_card(std::size_t number) const;

 private:
  int columns_;
  ImVec2 card_{};
  ImVec2 size_{};
};

}  // namespace ghostforce
