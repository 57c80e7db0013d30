// Proxy drift at rest over the tracking ratio ρ, and over how wrong the renderer's belief about the hand is.
#pragma once

#include "app/figures/curves.h"
#include "app/figures/figure.h"

namespace ghostforce {

inline constexpr std::string_view over_ratio = "tracking ratio";
inline constexpr std::string_view over_belief = "believed over true k_u";

// Panels: the two words above; series: anisotropic. x: ρ [1], or k̂_u/k_u [1]; y: drift along the wall, positive the way
// that naïve rendering drifts [mm].
Curves proxy_drifts();
Figure proxy_drift_figure(const FigureRequest& request);

}  // namespace ghostforce
