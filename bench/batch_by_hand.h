// The rival of core/batch.h: its recurrence written by hand with vector types, the state of eight settings in
// registers, everything that can be known beforehand in `HandBlock`. Once for each set of instructions; one thread
// each.
#pragma once

namespace ghostforce::bench {

// Eight settings, in the symbols of core/batch.h, SI units.
struct alignas(64) HandBlock {
  double v_xx[8], v_xy[8], v_yy[8], c[8], w_x[8], w_y[8], n_x[8], n_y[8], n_o[8], goal_x[8], goal_y[8];
  double q_x[8], q_y[8], u_x[8], u_y[8], h[8];
};

void hand_baseline(HandBlock* blocks, long count, long ticks);
void hand_avx2(HandBlock* blocks, long count, long ticks);
void hand_fma(HandBlock* blocks, long count, long ticks);  // AVX2 with fused multiply-adds, which round otherwise

}  // namespace ghostforce::bench
