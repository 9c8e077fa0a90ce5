"""Record hook: put this file beside your ray tracer, and it writes the ray trees that `raytree diff` and the debugger read.

Nothing is written unless the environment says where: RAYTREE_RECORD=rays.json RAYTREE_PIXEL=160,100 python3 your_tracer.py
Without RAYTREE_PIXEL every pixel is recorded. One thread only.
"""
import json
import os

_path, _wanted = os.environ.get("RAYTREE_RECORD"), os.environ.get("RAYTREE_PIXEL")
_file = open(_path, "w", encoding="utf-8") if _path else None
_pixel, _open, _count = None, [], 0  # the pixel that is recorded, its rays that are under way, how many it has sent

def _vector(v): return None if v is None else [float(x) for x in v]


def pixel_begin(x, y):
    """Before the eye ray of a pixel."""
    global _pixel, _open, _count
    if _file and _wanted in (None, f"{x},{y}"):
        _pixel, _open, _count = [x, y], [], 0


def ray_begin(kind, origin, direction, light=None, weight=None):
    """A ray is sent: I from the eye, L to the light of this name, R reflected, T transmitted, both with their weight."""
    global _count
    if _pixel:
        _open.append({
            "pixel": _pixel, "id": _count, "parent": _open[-1]["id"] if _open else None, "kind": kind, "light": light, "terms": [],
            "origin": _vector(origin), "direction": _vector(direction), "weight": [1, 1, 1] if kind == "I" else _vector(weight)})
        _count += 1


def hit(t, thing, point=None, normal=None):
    """The ray meets a thing of this name; of an L ray: it is in the way."""
    if _pixel:
        _open[-1]["hit"] = {"t": float(t), "object": thing, "point": _vector(point), "normal": _vector(normal)}


def term(name, value, light=None):
    """The ray's radiance grows by an ambient, diffuse, specular, emission or background term."""
    if _pixel:
        _open[-1]["terms"].append({"term": name, "value": _vector(value), "light": light})


def ray_end(radiance=None):
    """The ray is done, and so are those that it sent."""
    if _pixel:
        ray = _open.pop()
        words = ("lit", "blocked") if ray["kind"] == "L" else ("miss", "hit")
        line = {**ray, "outcome": words["hit" in ray], "radiance": _vector(radiance), "terms": ray["terms"] or None}
        _file.write(json.dumps(line) + "\n")


def pixel_end(color):
    """After the eye ray: linear red, green and blue of the pixel."""
    global _pixel
    if _pixel:
        _file.write(json.dumps({"pixel": _pixel, "color": _vector(color)}) + "\n")
        _pixel = _file.flush()
