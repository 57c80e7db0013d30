// Frames, signs, units and symbols. Read this first: every other header of
// core/ leans on it.
//
// Units   SI everywhere inside: m, s, kg, N, N/m, N·s/m, rad. Millimetres and
// degrees exist only in scene files and
//         on screen, and are converted where a file is read or a number is
//         drawn.
// Frame   One world frame W, right-handed: x to the right, y up. Angles are
// counter-clockwise from +x. Wall    n is the outward unit normal: it points to
// the free side. The depth d = n·(o − q) is positive inside. Force   f_r is the
// force that the device puts on the hand; f_u is the force that the hand puts
// on the device. Energy  W > 0 means that the rendering has given energy to the
// hand (it was active).
//
// Symbol  Code                  Meaning Unit q_u     goal where the user's hand
// wants the device to be                   m q_h     device where the device is
// m q_p     proxy                 the point that the wall holds back m q_c
// contact               the proxy projected on the wall, (3) m o, n    Wall
// point and outward normal of the linearised constraint          m, 1 P_A
// Actuation.actuated    projector on the degrees of freedom that have a motor 1
// P_N     Actuation.unactuated  projector on those that have none: I − P_A 1
// k_u     Impedances.k_u        stiffness of the user's hand, f_u = k_u (q_u −
// q_h), (1)       N/m k̂_u     believed_k_u          the k_u that the renderer
// believes in                          N/m K_t     Coupling.tracking tracking
// stiffness, f_t = K_t (q_h − q_p), (2)                 N/m k_ta Impedances.k_t
// K_t on actuated degrees of freedom                             N/m k_tn    —
// K_t on non-actuated degrees of freedom: k_ta / ρ               N/m k_c
// Impedances.k_c        constraint stiffness, f_c = k_c (q_c − q_p), (4); inf
// is hard  N/m K_r     Coupling.rendering    rendering stiffness, f_r = K_r
// (q_p − q_h), (5)                N/m d       depth()               n·(o −
// q_u), (8)                                               m ρ tracking_ratio
// k_ta / k_tn; ρ* = 1 + k_r / k̂_u is the cure, (17)              1 κ       —
// k_r / k_u                                                      1
//
// Numbers in round brackets are equation numbers of Lobo & Otaduy, "Rendering
// of Constraints with Underactuated Haptic Devices", IEEE Transactions on
// Haptics, 2020. docs/theory.md lists equation → code → test.
//
// The theory has no dimension, so everything below is written for D = 2, 3 or
// 4; the window draws D = 2.
#pragma once

#include <glm/mat2x2.hpp>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace ghostforce {

template <glm::length_t D>
using Vector = glm::vec<D, double, glm::defaultp>;

// Column-major, as glm stores it; every matrix of the model is symmetric.
template <glm::length_t D>
using Matrix = glm::mat<D, D, double, glm::defaultp>;

}  // namespace ghostforce
