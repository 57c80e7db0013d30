// StageLabels: words beside the marks of the stage. They never cover a mark or each other and are never cut off: they
// ask for a place, the most important are given one first, and who finds none is left out. A label keeps its place
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
#include "app/view/stage/stage_obstacles.h"
#include "app/view/view.h"

namespace ghostforce {

// In the order of their importance.
enum class StageLabel : std::uint8_t {
  numbers,  // the block of the two large numbers
  hint,
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
inline constexpr std::size_t stage_label_count = 12;

// Where the labels of the picture before stood. As it is made: there was none, and labels are there at once.
struct StageLabelMemory {
  struct Place {
    bool is_taken = false;
    // Beside what it names:
    double share = 0.0;      // of the way along that
    Vector<2> side{0.0};     // of the box that is towards it: (−1, 0) the right one, for words to its left
    double reach = 0.0;      // from its rim [points of the design]
    bool is_broken = false;  // in two lines
    Vector<2> corner{0.0};   // of a block, upper left
    double strength = 0.0;   // 0: not to be seen, 1: all there
    double waited_s = 0.0;   // that another place has been better
  };
  std::array<Place, stage_label_count> places{};
  bool has_begun = false;
  Vector<2> size{0.0};  // of that picture
  double unit = 0.0;

  // Whether a label is fading in or about to move.
  bool is_moving() const noexcept;
};

// What is to stand somewhere in a region, as near to a place as there is room.
struct LabelBlock {
  StageLabel id;
  Vector<2> extent;
  ScreenBox region;
  Vector<2> wanted;                   // of its upper left corner
  Vector<2> dearness{1.0, 1.0};       // of each point away from there, across and down
  std::optional<ScreenPiece> edge{};  // it must lie to the right of this, looking along it
  bool may_cover = false;             // what is to be kept clear if possible, where there is no other place
};

// Words that are to stand beside a mark.
struct LabelRequest {
  StageLabel id;
  std::vector<std::string> lines{};  // one may be broken in two
  TextStyle style;
  Vector<2> from{0.0};  // what it names: a point, or all between two
  Vector<2> to{0.0};
  double clearance = 0.0;             // half its thickness
  Vector<2> direction{0.0};           // where from there it had best stand, of any length
  double best_share = 0.5;            // of the way from one end to the other
  std::optional<LabelBlock> block{};  // instead of all that: where these words are to stand
};

struct PlacedLabel {
  std::vector<std::string> lines;
  ScreenBox box;
  double aligned = 0.0;  // of the lines in it: 0 left, 1 right
  double strength = 1.0;
  std::optional<ScreenPiece> leader{};  // to what it names, from which it stands far
};

class StageLabels {
 public:
  // `interval_s`: since the picture before.
  StageLabels(const Vector<2>& size, double unit, const MeasureText& measure, StageLabelMemory& memory,
              double interval_s);
  // A label that nobody asked for begins anew when it comes back.
  ~StageLabels();
  StageLabels(const StageLabels&) = delete;
  StageLabels& operator=(const StageLabels&) = delete;

  // What no label may cover: a thick line with round ends, or a rectangle.
  void keep_clear(const Vector<2>& from, const Vector<2>& to, double radius, Clearance clearance = Clearance::always) {
    obstacles_.add(from, to, radius, clearance);
  }
  void keep_clear(const ScreenBox& box) { obstacles_.add(box); }

  // Each request's place, in their order; empty: there is none. What is found is kept clear. Once for each picture, after
  // all that must be kept clear is known.
  std::vector<std::optional<PlacedLabel>> place(const std::vector<LabelRequest>& requests);

  // At once, and kept clear.
  struct PlacedBlock {
    ScreenBox box;
    double strength;
  };
  std::optional<PlacedBlock> place_block(const LabelBlock& block);

  // Of lines of text, one below the other.
  Vector<2> extent_of(const std::vector<std::string>& lines, const TextStyle& style) const;

 private:
  struct Form;
  struct Candidate;
  class Search;
  using Place = StageLabelMemory::Place;

  double points(double of_design) const { return of_design * unit_; }
  Place& remembered(StageLabel id);
  void move_to(Place& place, const Place& other);
  bool has_waited(Place& place, double at_least_s);
  std::optional<PlacedLabel> place_one(Search& search, const std::vector<ScreenBox>& others);

  Vector<2> size_;
  double unit_;
  const MeasureText& measure_;
  StageLabelMemory& memory_;
  double interval_s_;
  StageObstacles obstacles_;
  std::array<bool, stage_label_count> is_asked_for_{};
};

}  // namespace ghostforce
