// StageLabels: words beside the marks of the stage. They never cover a mark or each other and are never cut off: they
// ask for a place one after another, the most important first, and who finds none is left out. A label keeps its place
// relative to what it names as long as that is free; one that must change sides fades in at the new one, so that nothing
// jumps while something is dragged. Points of the window; one thread.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/view/marks.h"
#include "app/view/screen_box.h"
#include "app/view/view.h"

namespace ghostforce {

// In the order of their importance.
enum class StageLabel : std::uint8_t {
  numbers,  // the block of the two large numbers
  guess,
  ghost,
  slide,
  handle,
  wall_share,
  hand,
  expected_rest,
  expected_contact,
  motor,
  wall,
};
inline constexpr std::size_t stage_label_count = 11;

// Where the labels of the picture before stood. As it is made: there was none, and labels are there at once.
struct StageLabelMemory {
  struct Place {
    std::optional<std::size_t> candidate;
    double strength = 0.0;  // 0: not to be seen, 1: all there
  };
  std::array<Place, stage_label_count> places{};
  bool has_begun = false;

  // Whether a label is fading in.
  bool is_moving() const noexcept;
};

class StageLabels {
 public:
  // `interval_s`: since the picture before.
  StageLabels(const Vector<2>& size, double unit, const MeasureText& measure, StageLabelMemory& memory,
              double interval_s)
      : size_(size), unit_(unit), measure_(measure), memory_(memory), interval_s_(interval_s) {}
  // A label that nobody asked for begins anew when it comes back.
  ~StageLabels();
  StageLabels(const StageLabels&) = delete;
  StageLabels& operator=(const StageLabels&) = delete;

  // What no label may cover: a thick line with round ends, or a rectangle.
  void keep_clear(const Vector<2>& from, const Vector<2>& to, double radius);
  void keep_clear(const ScreenBox& box);

  struct Request {
    StageLabel id;
    std::vector<std::string> lines;
    TextStyle style;
    Vector<2> anchor;     // what it names
    double clearance;     // radius of that
    Vector<2> direction;  // where from there it had best stand, of any length
  };
  struct Found {
    ScreenBox box;
    double strength;
    bool is_far;  // so that a line should lead from it to its anchor
  };
  // Round the anchor, near before far, as close to the wanted direction as can be. What is found is kept clear.
  std::optional<Found> place(const Request& request);

  // At the first of these corners where so large a block covers nothing.
  std::optional<Found> place_block(StageLabel id, const Vector<2>& extent, const std::vector<Vector<2>>& corners);

  // Of lines of text, one below the other.
  Vector<2> extent_of(const std::vector<std::string>& lines, const TextStyle& style) const;

 private:
  struct Obstacle {
    Vector<2> from;
    Vector<2> to;
    double radius;
  };
  template <typename BoxOf>
  std::optional<Found> choose(StageLabel id, std::size_t count, const BoxOf& box_of, std::size_t first_far);
  bool is_free(const ScreenBox& box) const;

  Vector<2> size_;
  double unit_;
  const MeasureText& measure_;
  StageLabelMemory& memory_;
  double interval_s_;
  std::vector<Obstacle> obstacles_;
  std::vector<ScreenBox> boxes_;
  std::array<bool, stage_label_count> is_asked_for_{};
};

}  // namespace ghostforce
