// Whether a handle stays where its forces balance. Pure, never allocates or throws, any thread.
//
// Moved a little and then by nothing but the balance of forces, b q̇ = K_u (q_u − q) + f(q), it comes back if
// K_u − ∂f/∂q has both eigenvalues right of 0: its trace and its determinant are positive. f is what the loop renders
// there, with all that A changes beside the place (docs/theory.md, "Any device").
#pragma once

#include "core/general_tick.h"

namespace ghostforce {

// `handle`, `proxy`: at rest under some hand [m].
bool leads_back(const GeneralScene& scene, const GeneralStrategy& strategy, const Vector<2>& handle,
                const Vector<2>& proxy) noexcept;

}  // namespace ghostforce
