"""Where everything comes to rest in wall45, by the closed form of docs/theory.md, written down once more: what the page
shows is compared with this, not with itself."""
import math

K_U, K_R, K_T, K_C = 200.0, 600.0, 600.0, 1e5  # of the shipped scene wall45 [N/m]
OPTIMAL_RATIO = 1.0 + K_R / K_U


class Rest:
    """The equilibrium for a goal [m]; `force` is the rendered one [N]."""

    def __init__(self, goal, strategy, normal_deg=135.0):
        normal = (math.cos(math.radians(normal_deg)), math.sin(math.radians(normal_deg)))
        # The only motor pushes along x; with both motors every direction is actuated.
        along_motor = normal if strategy == "full" else (normal[0], 0.0)
        across = (normal[0] - along_motor[0], normal[1] - along_motor[1])
        ratio = OPTIMAL_RATIO if strategy == "anisotropic" else 1.0
        depth = -(normal[0] * goal[0] + normal[1] * goal[1])
        pull = tuple((1.0 + K_R / K_U) * a + ratio * b for a, b in zip(along_motor, across))
        compliance = (normal[0] * pull[0] + normal[1] * pull[1]) / K_T
        constraint_force = K_C * depth / (1.0 + K_C * compliance) if depth > 0.0 else 0.0
        self.force = tuple(K_R / K_T * constraint_force * a for a in along_motor)
        self.device = tuple(g + f / K_U for g, f in zip(goal, self.force))
        self.proxy = tuple(g + constraint_force / K_T * p for g, p in zip(goal, pull))


def ghost_force(goal, strategy, normal_deg=135.0):
    """Along the motor, in excess of the fully actuated device's; its magnitude [N]."""
    if strategy == "full":
        return 0.0
    return abs(Rest(goal, strategy, normal_deg).force[0] - Rest(goal, "full", normal_deg).force[0])
