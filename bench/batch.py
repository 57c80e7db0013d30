"""The loop of (23)(24)(25) in NumPy, for batch_bench, which starts this as a child: settings come in on the standard
input, then requests; what is asked for goes out on the standard output, as doubles.

A setting is 18 doubles: wall point x y, wall normal x y, actuated direction x y, m, b, rate, k_u, k_r, k_t, k_c, rho;
then start x y and goal x y. A request is a line: how many settings, ticks, and "vectorised" or "straight". The answer is
device x y and force x y of each setting.
"""

import sys

import numpy as np

columns = 18
inp = sys.stdin.buffer
out = sys.stdout.buffer


def vectorised(settings, ticks):
    """All settings at once, an array per number; what the settings fix is computed beforehand."""
    ox, oy, nx, ny, ax, ay, m, b, rate, k_u, k_r, k_t, k_c, rho, sx, sy, gx, gy = settings.T.copy()
    dt = 1.0 / rate
    mass = m + dt * b + dt * dt * k_u
    k_xx, k_xy, k_yy = k_r * ax * ax, k_r * ax * ay, k_r * ay * ay
    # K_t^-1 n, and the step per metre of depth
    along = ax * nx + ay * ny
    cx = (ax * along + rho * (nx - ax * along)) / k_t
    cy = (ay * along + rho * (ny - ay * along)) / k_t
    scale = 1.0 / (1.0 / k_c + nx * cx + ny * cy)
    step_x, step_y = cx * scale, cy * scale
    keep, pull, push = m / mass, dt * k_u / mass, dt / mass
    r_xx, r_xy, r_yy = push * k_xx, push * k_xy, push * k_yy
    wall = nx * ox + ny * oy
    x, y, px, py = sx, sy, sx, sy
    vx, vy = np.zeros_like(x), np.zeros_like(x)
    for _ in range(ticks):
        ex, ey = px - x, py - y
        vx = keep * vx + pull * (gx - x) + r_xx * ex + r_xy * ey
        vy = keep * vy + pull * (gy - y) + r_xy * ex + r_yy * ey
        depth = np.maximum(wall - nx * x - ny * y, 0.0)
        px, py = x + step_x * depth, y + step_y * depth
        x, y = x + dt * vx, y + dt * vy
    ex, ey = px - x, py - y
    return np.column_stack((x, y, k_xx * ex + k_xy * ey, k_xy * ex + k_yy * ey))


def straight_one(setting, ticks):
    """One setting, the formulas as the paper writes them."""
    o, n, a = setting[0:2], setting[2:4], setting[4:6]
    m, b, rate, k_u, k_r, k_t, k_c, rho = setting[6:14]
    start, q_u = setting[14:16], setting[16:18]
    dt = 1.0 / rate
    P_A = np.outer(a, a)
    P_N = np.eye(2) - P_A
    K_r = k_r * P_A
    C = (P_A / k_t + rho * P_N / k_t) @ n
    q_h, q_p, v = start, start, np.zeros(2)
    for _ in range(ticks):
        force = k_u * (q_u - q_h) + K_r @ (q_p - q_h)
        v = (m * v + dt * force) / (m + dt * b + dt * dt * k_u)
        depth = n @ (o - q_h)
        q_p = q_h + C * depth / (1.0 / k_c + n @ C) if depth > 0.0 else q_h
        q_h = q_h + dt * v
    return np.concatenate((q_h, K_r @ (q_p - q_h)))


def straight(settings, ticks):
    return np.array([straight_one(setting, ticks) for setting in settings])


count = int(inp.readline())
all_settings = np.frombuffer(inp.read(8 * columns * count)).reshape(count, columns)
ways = {"vectorised": vectorised, "straight": straight}
for line in inp:
    how_many, ticks, way = line.split()
    out.write(np.ascontiguousarray(ways[way.decode()](all_settings[: int(how_many)], int(ticks))).tobytes())
    out.flush()
