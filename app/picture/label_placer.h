// LabelPlacer: words beside the marks of a picture. They never cover a mark or each other and are never cut off: they
// ask for a place, and where there is not room for all, the less important ones are left out. A label keeps its place
// relative to what it names as long as that is free; one that must change sides fades in at the new one, so that
// nothing jumps while something is dragged. Legend and scale bars find their corners here, too. Points of the window;
// one thread.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/picture/label_obstacles.h"
#include "app/picture/label_search.h"
#include "app/picture/screen_box.h"
#include "app/picture/view.h"
#include "core/strategy.h"

namespace ghostforce {

// Where the labels of the picture before stood. As it is made: there was none, and labels are there at once.
struct LabelMemory {
  struct Place {
    bool is_taken = false;
    LabelPlace beside{};        // what it names,
    Vector<2> corner{0.0};      // or a block's upper left
    double strength = 0.0;      // 0: not to be seen, 1: all there
    double waited_s = 0.0;      // for a place, or for a better one
    std::uint64_t settled = 0;  // the picture in which there was none
  };
  std::array<Place, most_labels> places{};
  bool has_begun = false;
  Vector<2> size{0.0};  // of that picture
  double unit = 0.0;
  std::uint64_t picture = 0;   // its number: the same where nothing moves
  std::uint64_t arranged = 0;  // the one that all were last arranged for
  double rested_s = 0.0;       // with words that could be arranged better

  // Whether a label is fading in or may yet move.
  bool is_moving() const noexcept;
};

class LabelPlacer {
 public:
  // `interval_s`: since the picture before.
  LabelPlacer(const Vector<2>& size, double unit, const MeasureText& measure, LabelMemory& memory, double interval_s);
  // A label that nobody asked for begins anew when it comes back.
  ~LabelPlacer();
  LabelPlacer(const LabelPlacer&) = delete;
  LabelPlacer& operator=(const LabelPlacer&) = delete;

  // What no label may cover: a thick line with round ends, or a rectangle.
  void keep_clear(const Vector<2>& from, const Vector<2>& to, double radius, Clearance clearance = Clearance::always) {
    obstacles_.add(from, to, radius, clearance);
  }
  void keep_clear(const ScreenBox& box) { obstacles_.add(box); }

  const LabelObstacles& obstacles() const noexcept { return obstacles_; }
  const Vector<2>& size() const noexcept { return size_; }
  double unit() const noexcept { return unit_; }
  double interval_s() const noexcept { return interval_s_; }
  // There was no picture before, so that all is there at once.
  bool is_first() const noexcept { return !memory_.has_begun; }

  // Each request's place, in their order; empty: there is none. Once for each picture, after all that must be kept
  // clear is known.
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
  using Place = LabelMemory::Place;
  using Options = std::vector<std::optional<LabelOption>>;

  double points(double of_design) const { return of_design * unit_; }
  Place& remembered(LabelId id);
  void move_to(Place& place, const LabelPlace& beside, const Vector<2>& corner);
  // Counts on a wait; true once it has been that long.
  bool has_waited(Place& place, double at_least_s) const;

  // Empty: it is near enough, or something lies between.
  std::optional<ScreenPiece> leader_to(const Vector<2>& named, const ScreenBox& box) const;
  void arrange_anew(std::vector<LabelSearch>& searches, Options& options);
  void keep_or_find(std::vector<LabelSearch>& searches, Options& options);
  void arrange_at_rest(std::vector<LabelSearch>& searches, Options& options);
  void take_or_wait(LabelSearch& search, Place& place, const Options& options, const std::vector<ScreenBox>& others,
                    std::optional<LabelOption>& option);

  Vector<2> size_;
  double unit_;
  const MeasureText& measure_;
  LabelMemory& memory_;
  double interval_s_;
  LabelObstacles obstacles_;
  std::array<bool, most_labels> is_asked_for_{};
  std::uint64_t picture_ = 0;
};

// Where something that has only a few places stood in the picture before. As it is made: there was none.
struct CornerMemory {
  std::optional<std::size_t> place{};
  double strength = 0.0;      // 0: not to be seen, 1: all there
  double waited_s = 0.0;      // for a place, or for a better one
  std::uint64_t picture = 0;  // its number: the same where nothing moves
  bool is_best = true;        // of that picture, as far as anybody has looked

  bool is_moving() const noexcept { return !is_best || waited_s > 0.0 || (place && strength < 1.0); }
};

struct CornerPlace {
  std::size_t place;  // which of them
  double strength;    // 1: all there
};

// What stands beside the scene, legend and scale bars, takes the first of a few places that covers no mark. It stays
// there as long as it covers none, however good another place becomes while things move. `places`: best first; they
// come in forms, the next of which is only used where there is no room for the one before, and each has as many places.
// Empty: there is room in none. Where it stands is kept clear of labels.
std::optional<CornerPlace> place_in_corner(const std::vector<ScreenBox>& places, std::size_t places_of_form,
                                           LabelPlacer& labels, CornerMemory& memory);

enum class Corner : std::uint8_t { upper_left, upper_right, lower_left, lower_right };
ScreenBox box_in_corner(Corner corner, const Vector<2>& extent, const Vector<2>& size, double margin);

// Where words, legend and scale bars of a pane of the workbench's picture before stood, so that they stand still while
// something is dragged. As it is made: there was none.
struct PaneMemory {
  LabelMemory labels{};
  CornerMemory legend{};
  CornerMemory scales{};

  bool is_moving() const noexcept { return labels.is_moving() || legend.is_moving() || scales.is_moving(); }
};

using PictureMemory = std::array<PaneMemory, strategy_count>;  // as many panes as there can be

}  // namespace ghostforce
