#include "app/stage/landscape_contours.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

namespace ghostforce {
namespace {

constexpr double quarter_turn = 0.5 * std::numbers::pi;
constexpr int grid_columns = 120;
constexpr int grid_rows = 80;

const double kappa_decades = std::log(shown_kappas.greatest / shown_kappas.least);

double grid_angle(double column) noexcept {
  return quarter_turn * column / grid_columns;
}

double grid_kappa(double row) noexcept {
  return shown_kappas.least * std::exp(kappa_decades * row / grid_rows);
}

// The map's values at the corners of the grid's cells.
class CornerValues {
 public:
  explicit CornerValues(const Landscape& landscape) : values_((grid_columns + 1) * (grid_rows + 1)) {
    std::array<double, grid_columns + 1> cosines{};
    for (int column = 0; column <= grid_columns; ++column) {
      cosines[static_cast<std::size_t>(column)] = std::cos(grid_angle(column));
    }
    auto value = values_.begin();
    for (int row = 0; row <= grid_rows; ++row) {
      const double kappa = grid_kappa(row);
      const double ratio = landscape_ratio(landscape, kappa);
      for (const double cosine : cosines) *value++ = ghost_share(cosine, 1.0 + kappa, ratio, landscape.softness);
    }
  }

  double at(int column, int row) const noexcept {
    return values_[static_cast<std::size_t>(row * (grid_columns + 1) + column)];
  }

 private:
  std::vector<double> values_;
};

// An edge of the grid: from (column, row) to the right or upwards.
struct GridEdge {
  int column;
  int row;
  bool is_upright;
};

// Of one level: which edges its line crosses, and which crossings are joined within a cell. Edges have numbers: the
// level ones first, then the upright ones.
class LevelLines {
 public:
  LevelLines(const Landscape& landscape, const CornerValues& values, double level)
      : landscape_(landscape), values_(values), level_(level), joined_(level_edges + upright_edges, {none, none}) {
    for (int row = 0; row < grid_rows; ++row) {
      for (int column = 0; column < grid_columns; ++column) join_within(column, row);
    }
  }

  void take(std::vector<Contour>& contours) {
    // Lines that begin at the map's edge first: what then is left is closed.
    for (const bool is_open : {true, false}) {
      for (int edge = 0; edge < level_edges + upright_edges; ++edge) {
        const Joined& ends = joined(edge);
        if (ends[0] != none && (ends[1] == none) == is_open) contours.push_back(walked_from(edge));
      }
    }
  }

 private:
  using Joined = std::array<int, 2>;
  static constexpr int none = -1;
  static constexpr int level_edges = grid_columns * (grid_rows + 1);
  static constexpr int upright_edges = (grid_columns + 1) * grid_rows;

  static int level_edge(int column, int row) noexcept { return row * grid_columns + column; }
  static int upright_edge(int column, int row) noexcept { return level_edges + row * (grid_columns + 1) + column; }
  static GridEdge edge_of(int number) noexcept {
    if (number < level_edges) return {number % grid_columns, number / grid_columns, false};
    number -= level_edges;
    return {number % (grid_columns + 1), number / (grid_columns + 1), true};
  }

  Joined& joined(int edge) { return joined_[static_cast<std::size_t>(edge)]; }
  bool is_over(int column, int row) const noexcept { return values_.at(column, row) >= level_; }

  void join(int one, int other) {
    joined(one)[joined(one)[0] == none ? 0 : 1] = other;
    joined(other)[joined(other)[0] == none ? 0 : 1] = one;
  }

  void join_within(int column, int row) {
    const std::array<bool, 4> over{is_over(column, row), is_over(column + 1, row), is_over(column + 1, row + 1),
                                   is_over(column, row + 1)};
    if (std::ranges::count(over, over[0]) == 4) return;
    // Round the cell; side i lies between the corners i and i + 1.
    const std::array<int, 4> sides{level_edge(column, row), upright_edge(column + 1, row), level_edge(column, row + 1),
                                   upright_edge(column, row)};
    std::array<int, 4> crossed{};
    std::size_t count = 0;
    for (std::size_t side = 0; side < 4; ++side) {
      if (over[side] != over[(side + 1) % 4]) crossed[count++] = sides[side];
    }
    if (count == 2) {
      join(crossed[0], crossed[1]);
      return;
    }
    // A saddle: the middle says which two corners belong together.
    const double middle = 0.25 * (values_.at(column, row) + values_.at(column + 1, row) +
                                  values_.at(column + 1, row + 1) + values_.at(column, row + 1));
    const bool is_first_cut_off = (middle >= level_) != over[0];
    join(crossed[0], crossed[is_first_cut_off ? 3 : 1]);
    join(crossed[is_first_cut_off ? 1 : 2], crossed[is_first_cut_off ? 2 : 3]);
  }

  // Uses up what it walks over.
  Contour walked_from(int first) {
    Contour contour{level_, {crossing(first)}};
    int edge = first;
    while (true) {
      Joined& ends = joined(edge);
      const int next = ends[0] != none ? ends[0] : ends[1];
      if (next == none) break;
      (ends[0] != none ? ends[0] : ends[1]) = none;
      Joined& back = joined(next);
      (back[0] == edge ? back[0] : back[1]) = none;
      contour.points.push_back(next == first ? contour.points.front() : crossing(next));
      edge = next;
    }
    return contour;
  }

  // Where the level lies on an edge whose ends lie on both sides of it.
  LandscapePoint crossing(int number) const {
    const GridEdge edge = edge_of(number);
    const auto point_at = [&](double way) -> LandscapePoint {
      return {grid_angle(edge.is_upright ? edge.column : edge.column + way),
              grid_kappa(edge.is_upright ? edge.row + way : edge.row)};
    };
    double from = 0.0, to = 1.0;
    double at_from = values_.at(edge.column, edge.row) - level_;
    double at_to = values_.at(edge.column + (edge.is_upright ? 0 : 1), edge.row + (edge.is_upright ? 1 : 0)) - level_;
    // Regula falsi in the Illinois way: an end that stays counts half the next time.
    constexpr int most_steps = 40;
    constexpr double on_level = 1e-9;  // [1], a ten-millionth of a percent
    double way = 0.0;
    for (int step = 0; step < most_steps; ++step) {
      way = from - at_from * (to - from) / (at_to - at_from);
      const double here = ghost_share(landscape_, point_at(way)) - level_;
      if (std::abs(here) < on_level) break;
      if ((here >= 0.0) == (at_to >= 0.0)) {
        to = way, at_to = here;
        at_from *= 0.5;
      } else {
        from = way, at_from = here;
        at_to *= 0.5;
      }
    }
    return point_at(way);
  }

  const Landscape& landscape_;
  const CornerValues& values_;
  double level_;
  std::vector<Joined> joined_;
};

}  // namespace

Vector<2> map_place(const LandscapePoint& point) noexcept {
  return {point.angle / quarter_turn, std::log(point.kappa / shown_kappas.least) / kappa_decades};
}

LandscapePoint landscape_point_at(const Vector<2>& map_place) noexcept {
  return {quarter_turn * map_place.x, shown_kappas.least * std::exp(kappa_decades * map_place.y)};
}

std::vector<Contour> contours_of(const Landscape& landscape) {
  const CornerValues values(landscape);
  std::vector<Contour> contours;
  for (const double level : contour_levels) LevelLines(landscape, values, level).take(contours);
  return contours;
}

}  // namespace ghostforce
