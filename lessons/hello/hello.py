#!/usr/bin/env python3
"""The ray of one pixel, and the first thing that it meets: hello.py FLAT.json X Y WIDTH HEIGHT"""
import json
import sys
from math import sqrt


def add(a, b): return [x + y for x, y in zip(a, b)]
def sub(a, b): return [x - y for x, y in zip(a, b)]
def mul(s, a): return [s * x for x in a]
def dot(a, b): return sum(x * y for x, y in zip(a, b))
def unit(a): return mul(1 / sqrt(dot(a, a)), a)


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def plane(o, d, point, n):
    """t where the ray o + t d crosses a plane, and the plane's normal."""
    return (dot(n, sub(point, o)) / dot(n, d), n) if dot(n, d) else None


def triangle(o, d, a, b, c):
    n = unit(cross(sub(b, a), sub(c, a)))
    hit = plane(o, d, a, n)
    if hit:
        p = add(o, mul(hit[0], d))
        inside = all(dot(n, cross(sub(q, p0), sub(p, p0))) >= 0 for p0, q in ((a, b), (b, c), (c, a)))
        return hit if inside else None


def sphere(o, d, c, r):
    b, f = dot(d, sub(c, o)), sub(o, c)
    root = b * b - (dot(f, f) - r * r)
    if root >= 0:
        t = b - sqrt(root) if b - sqrt(root) > 0 else b + sqrt(root)
        return t, unit(sub(add(o, mul(t, d)), c))


def meet(o, d, s):
    if s["kind"] == "plane": return plane(o, d, s["point"], s["normal"])
    if s["kind"] == "triangle": return triangle(o, d, *s["corners"])
    if s["kind"] == "sphere": return sphere(o, d, s["center"], s["radius"])


scene = json.load(open(sys.argv[1]))
x, y, width, height = map(int, sys.argv[2:6])
cam = scene["camera"]
right = (2 * (x + 0.5) / width - 1) * cam["half_height"] * width / height
up = (1 - 2 * (y + 0.5) / height) * cam["half_height"]
o, d = cam["eye"], unit(sub(add(mul(right, cam["u"]), mul(up, cam["v"])), cam["w"]))
root = {"kind": "I", "origin": o, "direction": d, "outcome": "miss"}
hits = [(hit, s["name"]) for s in scene["objects"] if (hit := meet(o, d, s)) and hit[0] > 0]
if hits:
    (t, n), name = min(hits)
    n = n if dot(n, d) < 0 else mul(-1, n)
    root |= {"outcome": "hit", "hit": {"t": t, "object": name, "point": add(o, mul(t, d)), "geometric_normal": n}}
print(json.dumps({"pixel": {"x": x, "y": y}, "root": root}))
