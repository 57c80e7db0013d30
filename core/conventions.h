// Frames, signs, units and symbols. Read this first: every other header of core/ leans on it.
//
// Units   SI everywhere inside: m, s, kg, N, N/m, N·s/m, rad. Millimetres and degrees exist only in scene files and on
//         screen; they are converted where a file is read or a number is drawn.
// Frame   One world frame W, right-handed: x to the right, y up.
// Angle   Counter-clockwise from +x is positive.
// Wall    n is the outward unit normal: it points to the free side.
// Depth   d = n·(o − q) is positive inside the wall.
// Force   f_r is the force that the device puts on the hand; f_u is the force that the hand puts on the device.
// Energy  W > 0 means that the rendering has given energy to the hand (it was active).
//
// Symbol  Code                  Unit   Meaning
// ------  --------------------  -----  ------------------------------------------------------------------
// q_u     goal                  m      where the user's hand wants the device to be
// q_h     device                m      where the device is
// q_p     proxy                 m      the point that the wall holds back
// q_c     contact               m      the proxy projected on the wall: q_c = q_p + n n·(o − q_p), (3)
//
// o       Wall.point            m      a point of the linearised constraint
// n       Wall.normal           1      its outward unit normal
// d       depth()               m      depth of the goal inside the wall: d = n·(o − q_u), (8)
//
// P_A     Actuation.actuated    1      projector on the degrees of freedom that have a motor
// P_N     Actuation.unactuated  1      projector on those that have none: P_N = I − P_A
//
// k_u     Stiffnesses.k_u       N/m    stiffness of the user's hand: f_u = k_u (q_u − q_h), (1)
// k̂_u     believed_k_u          N/m    the k_u that the renderer believes in
// K_t     Coupling.tracking     N/m    tracking stiffness: f_t = K_t (q_h − q_p), (2)
// k_ta    Stiffnesses.k_t       N/m    K_t on actuated degrees of freedom, also written k_t
// k_tn    —                     N/m    K_t on non-actuated degrees of freedom: k_tn = k_ta / ρ
// k_c     Stiffnesses.k_c       N/m    constraint stiffness: f_c = k_c (q_c − q_p), (4); inf is hard
// K_r     Coupling.rendering    N/m    rendering stiffness: f_r = K_r (q_p − q_h), (5)
// k_r     Stiffnesses.k_r       N/m    K_r on actuated degrees of freedom
//
// ρ       tracking_ratio        1      k_ta / k_tn; the cure is ρ* = 1 + k_r / k̂_u, (17)
// κ       kappa                 1      k_r / k_u
//
// General scenes (general_tick.h), beyond the paper:
//
// A       ActuationMatrix.columns   1, 1/m  force on the handle per unit effort of each motor, where the handle is
// B       ActuationMatrix.commands  1, m    effort that a renderer with all motors asks of each, per unit force; B A = I
// u       efforts                   N, N·m  of the motors that exist
// C_u     user_compliance           m/N     K_u⁻¹ of the hand; Compliances.user is what the renderer believes
// τ       1/Compliances.force_share 1       k_t / k_r
// λ       multipliers               N       push of each wall; f_c, contact_force, is that of all
// Π       ActuatedProjection        1       projector on what the motors can make, orthogonal in C_u
// s       share                     1       compliance share: 0 naïve rendering, 1 the cure
//
// Numbers in round brackets are equation numbers of Lobo & Otaduy, "Rendering of Constraints with Underactuated Haptic
// Devices", IEEE Transactions on Haptics, 2020. docs/theory.md lists equation → code → test.
//
// The theory has no dimension, so everything below is written for D = 2, 3 or 4; the window draws D = 2.
#pragma once

#include <numbers>

#include <glm/mat2x2.hpp>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace ghostforce {

template <glm::length_t D>
using Vector = glm::vec<D, double, glm::defaultp>;

// Column-major, as glm stores it; every matrix of the paper is symmetric.
template <glm::length_t D>
using Matrix = glm::mat<D, D, double, glm::defaultp>;

// For files, the screen and the published angles of devices.
inline constexpr double mm_per_m = 1000.0;
inline constexpr double radians_per_degree = std::numbers::pi / 180.0;
inline constexpr double degrees_per_radian = 180.0 / std::numbers::pi;

}  // namespace ghostforce
