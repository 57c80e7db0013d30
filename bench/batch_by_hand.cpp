// Compiled once for each set of instructions, see CMakeLists.txt: GHOSTFORCE_HAND names the function,
// GHOSTFORCE_HAND_WIDTH is the number of doubles in a register.
#include "bench/batch_by_hand.h"

#include <cstring>

namespace ghostforce::bench {
namespace {

typedef double Register __attribute__((vector_size(8 * GHOSTFORCE_HAND_WIDTH)));
constexpr int width = GHOSTFORCE_HAND_WIDTH;
constexpr int registers =
    2;  // of each number; with more of them the state would not fit, with one each sum is waited for
constexpr int together = registers * width;

void load(const double* numbers, Register (&to)[registers]) {
  std::memcpy(&to, numbers, sizeof to);
}

void store(const Register (&from)[registers], double* numbers) {
  std::memcpy(numbers, &from, sizeof from);
}

}  // namespace

void GHOSTFORCE_HAND(HandBlock* blocks, long count, long ticks) {
  for (HandBlock* block = blocks; block != blocks + count; ++block) {
    for (int part = 0; part < 8; part += together) {
      Register v_xx[registers], v_xy[registers], v_yy[registers], c[registers], w_x[registers], w_y[registers];
      Register n_x[registers], n_y[registers], n_o[registers], goal_x[registers], goal_y[registers];
      Register q_x[registers], q_y[registers], u_x[registers], u_y[registers], h[registers];
      load(block->v_xx + part, v_xx);
      load(block->v_xy + part, v_xy);
      load(block->v_yy + part, v_yy);
      load(block->c + part, c);
      load(block->w_x + part, w_x);
      load(block->w_y + part, w_y);
      load(block->n_x + part, n_x);
      load(block->n_y + part, n_y);
      load(block->n_o + part, n_o);
      load(block->goal_x + part, goal_x);
      load(block->goal_y + part, goal_y);
      load(block->q_x + part, q_x);
      load(block->q_y + part, q_y);
      load(block->u_x + part, u_x);
      load(block->u_y + part, u_y);
      load(block->h + part, h);
      for (long k = 0; k < ticks; ++k) {
#pragma GCC unroll 4
        for (int i = 0; i < registers; ++i) {
          const Register inside = n_o[i] - n_x[i] * q_x[i] - n_y[i] * q_y[i];
          const Register x = v_xx[i] * u_x[i] + v_xy[i] * u_y[i] + w_x[i] * h[i] + c[i] * (goal_x[i] - q_x[i]);
          const Register y = v_xy[i] * u_x[i] + v_yy[i] * u_y[i] + w_y[i] * h[i] + c[i] * (goal_y[i] - q_y[i]);
          h[i] = inside > 0.0 ? inside : Register{};
          u_x[i] = x;
          u_y[i] = y;
          q_x[i] += x;
          q_y[i] += y;
        }
      }
      store(q_x, block->q_x + part);
      store(q_y, block->q_y + part);
      store(u_x, block->u_x + part);
      store(u_y, block->u_y + part);
      store(h, block->h + part);
    }
  }
}

}  // namespace ghostforce::bench
