#!/usr/bin/env python3
"""A ray tracer with the record hook in it, in each place that it belongs: example.py X Y WIDTH HEIGHT traces a pixel of example.json."""
import sys
from math import inf, pi, sqrt, tan

from raytree_hook import hit, pixel_begin, pixel_end, ray_begin, ray_end, term

EYE, LAMP, BACKGROUND, AMBIENT, DEPTH = [0, 1, 4], [3, 4, 3], [0.2, 0.3, 0.5], 0.1, 3
BALLS = {"ball": ([0, 1, 0], 1), "pearl": ([1.4, 0.4, 0.8], 0.4)}
DIFFUSE = {"ball": [0.1, 0.1, 0.12], "pearl": [0.6, 0.55, 0.5], "floor": [0.6, 0.55, 0.5]}
MIRROR = {"ball": 0.8, "pearl": 0.2, "floor": 0.2}


def axpy(s, a, b): return [s * x + y for x, y in zip(a, b)]
def dot(a, b): return sum(x * y for x, y in zip(a, b))
def unit(a): return [x / sqrt(dot(a, a)) for x in a]


def closest(o, d, t_max=inf):
    """t, name and normal of what the ray meets first."""
    found = None
    if d[1] < 0 and 0 < -o[1] / d[1] < t_max:
        found = t_max, *_ = (-o[1] / d[1], "floor", [0, 1, 0])
    for name, (center, radius) in BALLS.items():
        f = axpy(-1, center, o)
        b = dot(d, f)
        root = b * b - dot(f, f) + radius * radius
        t = -b - sqrt(root) if root >= 0 else inf
        if 1e-9 < t < t_max:
            found = t_max, *_ = (t, name, unit(axpy(t, d, f)))
    return found


def radiance(kind, o, d, depth, weight=None):
    ray_begin(kind, o, d, weight=weight)
    color, met = BACKGROUND, closest(o, d)
    if met is None:
        term("background", BACKGROUND)
    else:
        t, name, n = met
        point, mirror = axpy(t, d, o), [MIRROR[name]] * 3
        hit(t, name, point, n)
        color = [AMBIENT * k for k in DIFFUSE[name]]
        term("ambient", color)
        to_lamp = axpy(-1, point, LAMP)
        l, distance = unit(to_lamp), sqrt(dot(to_lamp, to_lamp))
        if dot(n, l) > 0:
            ray_begin("L", point, l, light="lamp")
            blocker = closest(axpy(1e-9, n, point), l, distance)
            if blocker:
                hit(blocker[0], blocker[1])
            ray_end()
            if not blocker:
                diffuse = [k * dot(n, l) for k in DIFFUSE[name]]
                term("diffuse", diffuse, light="lamp")
                color = axpy(1, color, diffuse)
        if depth < DEPTH:
            reflected = radiance("R", axpy(1e-9, n, point), unit(axpy(-2 * dot(n, d), n, d)), depth + 1, mirror)
            color = axpy(MIRROR[name], reflected, color)
    ray_end(color)
    return color


x, y, width, height = map(int, sys.argv[1:5])
half = tan(pi / 6)
d = unit([(2 * (x + 0.5) / width - 1) * half * width / height, (1 - 2 * (y + 0.5) / height) * half, -1])
pixel_begin(x, y)
color = radiance("I", EYE, d, 0)
pixel_end(color)
print(*color)
