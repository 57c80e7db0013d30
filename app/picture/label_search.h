// LabelSearch: where words could stand beside what they name, best first, as far as marks leave room; and the best
// arrangement of several. Points of the window, y down. Pure but for what is worked out only once; one thread.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/picture/label_obstacles.h"
#include "app/picture/marks.h"
#include "app/picture/screen_box.h"
#include "app/picture/view.h"

namespace ghostforce {

// Which words of a picture they are: the smaller, the more important. One thing has one set of words at a time.
using LabelId = std::uint8_t;
inline constexpr std::size_t most_labels = 16;

// What is to stand somewhere in a region, as near to a place as there is room.
struct LabelBlock {
  LabelId id;
  Vector<2> extent;
  ScreenBox region;
  Vector<2> wanted;                   // of its upper left corner
  std::optional<ScreenPiece> edge{};  // it must lie to the right of this, looking along it
  bool may_cover = false;             // what is to be kept clear if possible, where there is no other place
  std::optional<Vector<2>> named{};   // what the words name: a line leads there where they stand far from it
};

// Words that are to stand beside a mark.
struct LabelRequest {
  LabelId id;
  std::vector<std::string> lines{};  // one may be broken in two
  TextStyle style;
  Vector<2> from{0.0};  // what it names: a point, or all between two
  Vector<2> to{0.0};
  double clearance = 0.0;             // half its thickness
  Vector<2> direction{0.0};           // where from there it had best stand, of any length
  double best_share = 0.5;            // of the way from one end to the other
  bool is_of_long_thing = false;      // which nobody takes for something else, however near other words stand
  double ambiguity_weight = 1.0;      // how bad it is to stand nearer to something else, against the usual
  std::optional<LabelBlock> block{};  // instead of all that: where these words are to stand
  bool may_cover = false;             // what is long and thin, where there is no better place
  bool is_to_come = false;            // its place is kept, so that nothing else moves once it is there
};

// A place relative to what is named, with which it moves.
struct LabelPlace {
  double share = 0.0;      // of the way along that
  Vector<2> side{0.0};     // of the words' box that is away from it: (−1, 0) the left one, for words to its left
  double reach = 0.0;      // from its rim [points of the design]
  bool is_broken = false;  // in two lines

  friend bool operator==(const LabelPlace&, const LabelPlace&) = default;
};

// Words at their place.
struct PlacedLabel {
  std::vector<std::string> lines;
  ScreenBox box;
  double aligned = 0.0;  // of the lines in it: 0 left, 1 right
  double strength = 1.0;
  std::optional<ScreenPiece> leader{};  // to what it names, from which it stands far
};

struct LabelOption {
  LabelPlace place;
  PlacedLabel label;
  double cost;  // the less, the better [points of the design]
};

// In points of the design.
inline constexpr double new_label_air = 5.0;    // to marks and other labels, where words come to stand,
inline constexpr double least_label_air = 2.0;  // and as long as they stand there
inline constexpr double edge_of_labels = 6.0;   // to the window's edge

struct LabelRoom {
  Vector<2> size;  // of the window
  double unit;     // a point of the design
  const MeasureText& measure;
  const LabelObstacles& obstacles;
};

class LabelSearch {
 public:
  // Both must outlive it.
  LabelSearch(const LabelRequest& request, const LabelRoom& room);

  const LabelRequest& request() const noexcept { return request_; }
  // Whether anything of what is named can be seen.
  bool is_seen() const noexcept { return is_seen_; }
  // What is named, as far as it is seen, unless it is so long that nobody takes it for something else.
  std::optional<ScreenPiece> thing() const;
  // Which other words name: these should not stand nearer to it.
  void keep_apart_from(std::vector<ScreenPiece> things) { others_ = std::move(things); }

  // Empty where it is not free of marks.
  std::optional<LabelOption> at(const LabelPlace& place, double air);
  // A choice of free places, best first.
  const std::vector<LabelOption>& options();

 private:
  struct Form {
    std::vector<std::string> lines;
    Vector<2> extent;
  };
  struct Candidate {
    double cost;
    std::uint8_t share;
    std::uint8_t side;
    std::uint8_t reach;
    bool is_broken;
  };

  double points(double of_design) const noexcept { return of_design * room_.unit; }
  const Form& form_of(bool is_broken);
  std::vector<double> shares() const;
  std::vector<Candidate> candidates(const std::vector<double>& shares) const;
  double cost_of(const LabelPlace& place) const;
  double cost_of_doubt(const ScreenBox& box) const;
  bool is_like_another(const LabelOption& option) const;

  const LabelRequest& request_;
  const LabelRoom& room_;
  std::vector<Form> forms_;
  Vector<2> wanted_{0.0};
  Vector<2> from_{0.0};  // what is seen of the thing
  Vector<2> to_{0.0};
  bool is_seen_ = false;
  std::vector<ScreenPiece> others_;
  std::optional<std::vector<LabelOption>> options_;
};

// Neither covers the other or its line.
bool can_stand_together(const PlacedLabel& a, const PlacedLabel& b, double air) noexcept;

// Which option each is best given: empty, or none at all. Words that must be left out are the less important ones, and
// of all ways to give the others a place it is a cheap one. `searches` in the order of their importance.
struct LabelPlan {
  std::vector<std::optional<LabelOption>> options;
  double cost = 0.0;
};
LabelPlan best_label_plan(std::vector<LabelSearch>& searches, double unit);
// Of those that are there and those that are not.
double cost_of_plan(const std::vector<std::optional<LabelOption>>& options) noexcept;

}  // namespace ghostforce
