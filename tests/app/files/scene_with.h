// A good scene as a file has it, with a piece of it replaced, and what the reader says of that. For tests.
#pragma once

#include <ostream>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "app/files/scene_file.h"

namespace ghostforce {

// Line numbers on the right are what the tests below rely on.
inline constexpr std::string_view good_scene =
    "format = 1\n"                                 // 1
    "title  = \"A title\"\n"                       // 2
    "about  = \"What to see.\"\n"                  // 3
    "[wall]\n"                                     // 4
    "point_mm   = [1.0, -2]\n"                     // 5
    "normal_deg = 135.0\n"                         // 6
    "[device]\n"                                   // 7
    "actuated_deg = 0.0\n"                         // 8
    "mass_kg = 0.1\n"                              // 9
    "damping_N_s_per_m = 5.0\n"                    // 10
    "rate_hz = 1000\n"                             // 11
    "[user]\n"                                     // 12
    "k_u_N_per_m = 100.0\n"                        // 13
    "believed_k_u_N_per_m = 50.0\n"                // 14
    "[rendering]\n"                                // 15
    "strategy = \"naive\"\n"                       // 16
    "k_r_N_per_m = 900\n"                          // 17
    "k_t_N_per_m = 800.0\n"                        // 18
    "k_c_N_per_m = 1e5\n"                          // 19
    "tracking_ratio = 11.5\n"                      // 20
    "[goal]\n"                                     // 21
    "path_mm  = [[-40.0, 40.0], [40.0, -40.0]]\n"  // 22
    "times_s  = [0.0, 1.0]\n"                      // 23
    "duration_s = 3.0\n"                           // 24
    "motion = \"minimum-jerk\"\n"                  // 25
    "[view]\n"                                     // 26
    "center_mm = [5.0, 6.0]\n"                     // 27
    "width_mm = 150.0\n";                          // 28

// The good scene with one piece of it replaced.
inline std::string scene_with(std::string_view piece, std::string_view replacement) {
  std::string text(good_scene);
  const std::size_t at = text.find(piece);
  EXPECT_NE(at, std::string::npos) << piece;
  return text.replace(at, piece.size(), replacement);
}

// What the reader says; empty when it takes the scene.
inline std::string refusal(std::string_view text, const std::vector<std::string>& overrides = {}) {
  try {
    read_scene(text, "f.toml", overrides);
  } catch (const ReadError& error) {
    EXPECT_EQ(error.kind(), ReadError::Kind::wrong);
    EXPECT_STRNE(error.what(), "");
    return error.what();
  }
  return "";
}

struct BadFile {
  const char* name;
  std::string_view piece;  // of the good scene
  std::string_view replacement;
  std::string_view place;  // "LINE:COLUMN"
  std::vector<std::string_view> words;
};

inline std::ostream& operator<<(std::ostream& out, const BadFile& bad) {
  return out << bad.name;
}

inline void expect_refused(const BadFile& bad) {
  const std::string said = refusal(scene_with(bad.piece, bad.replacement));
  EXPECT_TRUE(said.starts_with("f.toml:" + std::string(bad.place) + ": ")) << said;
  for (const std::string_view words : bad.words) EXPECT_NE(said.find(words), std::string::npos) << said;
  EXPECT_EQ(said.find('\n'), std::string::npos) << "one problem, one line: " << said;
}

}  // namespace ghostforce
