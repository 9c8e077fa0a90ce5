#!/usr/bin/env python3
"""A Whitted ray tracer that prints ray trees: tracer.py FLAT.json WIDTH HEIGHT PIXELS

FLAT.json is a flat scene (`raytree scenes SCENE --flat`) of planes, spheres and triangles, PIXELS a file with `x y` a line.
For each pixel one line of JSON is printed: its colour, and its ray tree in the format of `raytree trace`.

L = Le + Ka Ia + sum over lights (Kd (N.L) + Ks (R.V)^n) I + Wr L(R) + Wt L(T), Wr = Kr + F Kt, Wt = (1 - F) Kt
"""
import json
import sys
from math import inf, sqrt

EPSILON = 1e-4  # how far from its surface a ray starts, in metres: else it would hit the surface again
AIR = 1.0  # index of refraction
BLACK = [0.0, 0.0, 0.0]


# ---------------------------------------------------------------------------------------------------------------- vectors

def add(a, b):
    return [x + y for x, y in zip(a, b)]


def sub(a, b):
    return [x - y for x, y in zip(a, b)]


def times(a, b):
    """Channel by channel."""
    return [x * y for x, y in zip(a, b)]


def scale(s, a):
    return [s * x for x in a]


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def length(a):
    return sqrt(dot(a, a))


def unit(a):
    """The vector with length 1; 0 stays 0."""
    return scale(1 / (length(a) or 1), a)


# ----------------------------------------------------------------------------------------------------------------- shapes
# Each function gives t, where the ray o + t d crosses the shape, and the normal there, outwards; None if it does not.

def hit_plane(o, d, point, normal):
    slope = dot(normal, d)
    if slope == 0:
        return None
    t = dot(normal, sub(point, o)) / slope
    return (t, normal) if t > 0 else None


def hit_triangle(o, d, corners):
    a, b, c = corners
    normal = unit(cross(sub(b, a), sub(c, a)))
    hit = hit_plane(o, d, a, normal)
    if hit is None:
        return None
    p = add(o, scale(hit[0], d))
    for start, end in (a, b), (b, c), (c, a):
        if dot(normal, cross(sub(end, start), sub(p, start))) < 0:
            return None
    return hit


def hit_sphere(o, d, center, radius):
    f = sub(o, center)
    b = -dot(f, d)
    root = b * b - (dot(f, f) - radius * radius)
    if root < 0:
        return None
    near, far = b - sqrt(root), b + sqrt(root)
    t = near if near > 0 else far
    if t <= 0:
        return None
    return t, unit(sub(add(o, scale(t, d)), center))


def hit_shape(o, d, shape):
    if shape["kind"] == "plane":
        return hit_plane(o, d, shape["point"], shape["normal"])
    if shape["kind"] == "triangle":
        return hit_triangle(o, d, shape["corners"])
    return hit_sphere(o, d, shape["center"], shape["radius"])


# ----------------------------------------------------------------------------------------------------------------- optics

def reflect(d, n):
    """R = I - 2 (N.I) N"""
    return unit(sub(d, scale(2 * dot(n, d), n)))


def refract(d, n, n1, n2):
    """T = eta I + (eta c - sqrt(k)) N, or None under total internal reflection; and k."""
    eta = n1 / n2
    c = -dot(n, d)
    k = 1 - eta * eta * (1 - c * c)
    if k <= 0:
        return None, k
    return unit(add(scale(eta, d), scale(eta * c - sqrt(k), n))), k


def fresnel(cos_i, cos_t, n1, n2):
    """The share that is reflected: the mean of both polarisations."""
    s = (n1 * cos_i - n2 * cos_t) / (n1 * cos_i + n2 * cos_t)
    p = (n1 * cos_t - n2 * cos_i) / (n1 * cos_t + n2 * cos_i)
    return (s * s + p * p) / 2


# ------------------------------------------------------------------------------------------------------------- the tracer

class Tracer:
    def __init__(self, scene):
        self.scene = scene
        self.depth = scene["settings"]["depth"]
        self.lights = scene["lights"]
        self.materials = {m["name"]: m for m in scene["materials"]}

    def eye_ray(self, x, y, width, height):
        """Origin and direction of the ray through the middle of a pixel."""
        camera = self.scene["camera"]
        half = camera["half_height"]
        film_x, film_y = x + 0.5, y + 0.5
        right = (2 * film_x / width - 1) * half * width / height
        up = (1 - 2 * film_y / height) * half
        d = sub(add(scale(right, camera["u"]), scale(up, camera["v"])), camera["w"])
        return camera["eye"], unit(d)

    def closest(self, o, d, t_max=inf):
        """t, normal and shape of the first thing that a ray meets before t_max."""
        closest = None
        for shape in self.scene["objects"]:
            hit = hit_shape(o, d, shape)
            if hit and hit[0] < t_max:
                t_max = hit[0]
                closest = (*hit, shape)
        return closest

    def trace(self, node, depth):
        """Follows an I, R or T ray: fills in its node of the tree, and gives its radiance."""
        o, d = node["origin"], node["direction"]
        found = self.closest(o, d)
        if found is None:
            node["outcome"] = "miss"
            node["terms"] = [{"term": "background", "value": self.scene["background"]}]
            node["radiance"] = self.scene["background"]
            return node["radiance"]
        t, outward, shape = found
        side = "front" if dot(outward, d) <= 0 else "back"
        normal = outward if side == "front" else scale(-1, outward)
        point = add(o, scale(t, d))
        node["outcome"] = "hit"
        node["hit"] = {
            "t": t, "object": shape["name"], "primitive": shape.get("primitive", 0), "point": point,
            "geometric_normal": normal, "normal": normal, "side": side, "material": shape["material"],
        }
        material = self.materials[shape["material"]]
        self.local_light(node, material)
        radiance = BLACK
        for term in node["terms"]:
            radiance = add(radiance, term["value"])
        for ray, weight in self.secondary_rays(node, material, depth):
            radiance = add(radiance, times(weight, self.trace(ray, depth + 1)))
        node["radiance"] = radiance
        return radiance

    # What the surface sends out by itself, and of the light that is everywhere and that of the lamps.

    def local_light(self, node, material):
        emission = material["emission"]
        ambient = times(material["ambient"], self.scene["ambient"])
        if any(emission):
            node["terms"].append({"term": "emission", "value": emission})
        if any(ambient):
            node["terms"].append({"term": "ambient", "value": ambient})
        shows_lights = any(material["diffuse"]) or any(material["specular"])
        for light in self.lights:
            if shows_lights:
                self.light_terms(node, light, material)
            else:
                node["absent"].append({"kind": "L", "light": light["name"], "reason": "no-local-light"})

    def light_terms(self, node, light, material):
        """The diffuse and the specular term of a light, unless something is in its way."""
        point, n = node["hit"]["point"], node["hit"]["normal"]
        l, distance, intensity = self.arriving(light, point)
        n_dot_l = dot(n, l)
        if n_dot_l <= 0:
            absent = {"kind": "L", "light": light["name"], "reason": "facing-away", "n_dot_l": n_dot_l}
            node["absent"].append(absent)
            return
        start = add(point, scale(EPSILON, n))
        blocker = self.blocker(start, light)
        lit = blocker is None
        shadow = self.ray("L", start, l, light=light["name"], outcome="lit" if lit else "blocked")
        if distance < inf:
            shadow["t_max"] = distance
        if blocker:
            shadow["hit"] = {"t": blocker[0], "object": blocker[2]["name"]}
        node["children"].append(shadow)
        if not lit:
            return
        diffuse = scale(n_dot_l, times(material["diffuse"], intensity))
        node["terms"].append({"term": "diffuse", "light": light["name"], "value": diffuse, "n_dot_l": n_dot_l})
        if any(material["specular"]):
            mirrored = sub(scale(2 * n_dot_l, n), l)
            to_viewer = scale(-1, node["direction"])
            r_dot_v = max(dot(mirrored, to_viewer), 0.0)
            highlight = r_dot_v ** material["shininess"] if r_dot_v > 0 else 0.0
            specular = scale(highlight, times(material["specular"], intensity))
            node["terms"].append({"term": "specular", "light": light["name"], "value": specular, "r_dot_v": r_dot_v})

    def arriving(self, light, point):
        """L, the distance to the light, and I, what arrives from there at a point."""
        if light["kind"] == "directional":
            return scale(-1, light["direction"]), inf, light["intensity"]
        to_light = sub(light["position"], point)
        r = length(to_light)
        a, b, c = light["attenuation"]
        intensity = scale(1 / (a + b * r + c * r * r), light["intensity"])
        return unit(to_light), r, intensity

    def blocker(self, start, light):
        """What stands between a point and a light."""
        l, distance, _ = self.arriving(light, start)
        return self.closest(start, l, distance)

    # The rays that go on.

    def secondary_rays(self, node, material, depth):
        """The R and T rays that the hit sends, each with its weight."""
        d, n, side = node["direction"], node["hit"]["normal"], node["hit"]["side"]
        kr, kt = material["mirror"], material["transmission"]
        share, t = 0.0, None  # an opaque surface
        no_t = {"reason": "no-transmission"}
        if any(kt):
            n1, n2 = (AIR, material["ior"]) if side == "front" else (material["ior"], AIR)
            t, k = refract(d, n, n1, n2)
            if t is None:
                share = 1.0
                no_t = {"reason": "total-internal-reflection", "k": k}
            else:
                share = fresnel(-dot(n, d), -dot(n, t), n1, n2)
            node["boundary"] = {"n1": n1, "n2": n2, "reflectance": share}
        wr, wt = add(kr, scale(share, kt)), scale(1 - share, kt)
        wanted = [
            ("R", reflect(d, n) if any(wr) else None, 1, wr, {"reason": "no-reflection"}),
            ("T", t, -1, wt, no_t),
        ]
        rays = []
        for kind, direction, away, weight, absent in wanted:
            if direction is None:
                node["absent"].append({"kind": kind, **absent})
            elif depth >= self.depth:
                node["absent"].append({"kind": kind, "reason": "depth-limit"})
            else:
                start = add(node["hit"]["point"], scale(away * EPSILON, n))
                ray = self.ray(kind, start, direction, weight=weight)
                node["children"].append(ray)
                rays.append((ray, weight))
        return rays

    @staticmethod
    def ray(kind, origin, direction, **more):
        """A node of the tree."""
        node = {"kind": kind, "origin": origin, "direction": direction, **more}
        if kind != "L":
            node.update(terms=[], absent=[])
        node["children"] = []
        return node

    def pixel(self, x, y, width, height):
        """The document of a pixel."""
        root = self.ray("I", *self.eye_ray(x, y, width, height), weight=[1.0, 1.0, 1.0])
        linear = self.trace(root, 0)
        shown = scale(self.scene["settings"]["exposure"], linear)
        return {
            "scene": {"name": self.scene["name"]}, "image": {"width": width, "height": height},
            "pixel": {"x": x, "y": y}, "color": {"linear": linear, "srgb8": [srgb8(c) for c in shown]}, "root": root,
        }


def srgb8(c):
    """A channel as the screen takes it: clamped, with the curve of sRGB, 0 to 255."""
    c = min(max(c, 0.0), 1.0)
    curve = 12.92 * c if c <= 0.0031308 else 1.055 * c ** (1 / 2.4) - 0.055
    return int(curve * 255 + 0.5)


def check(scene):
    """Ends the program if there is something in the scene that this tracer does not draw."""
    unknown = [s["name"] for s in scene["objects"] if s["kind"] not in ("plane", "sphere", "triangle")]
    unknown += [s["name"] for s in scene["objects"] if "to_world" in s or "normals" in s]
    unknown += [light["name"] for light in scene["lights"] if light["kind"] not in ("point", "directional")]
    unknown += [m["name"] for m in scene["materials"] if "checker" in m]
    if unknown:
        sys.exit(f"tracer.py does not draw `{unknown[0]}` of {scene['name']}")


def write_picture(tracer, width, height, folder):
    """The whole picture as NAME.ppm in a folder, NAME that of the scene."""
    with open(f"{folder}/{tracer.scene['name']}.ppm", "wb") as file:
        file.write(b"P6 %d %d 255\n" % (width, height))
        for y in range(height):
            row = [tracer.pixel(x, y, width, height)["color"]["srgb8"] for x in range(width)]
            file.write(bytes(channel for color in row for channel in color))


def main():
    if len(sys.argv) not in (5, 6):
        sys.exit("usage: tracer.py FLAT.json WIDTH HEIGHT PIXELS [FOLDER]")
    with open(sys.argv[1], encoding="utf-8") as file:
        scene = json.load(file)
    check(scene)
    width, height = int(sys.argv[2]), int(sys.argv[3])
    with open(sys.argv[4], encoding="utf-8") as file:
        pixels = [[int(word) for word in line.split()] for line in file if line.strip()]
    tracer = Tracer(scene)
    for x, y in pixels:
        print(json.dumps(tracer.pixel(x, y, width, height)))
    if len(sys.argv) == 6:
        write_picture(tracer, width, height, sys.argv[5])


if __name__ == "__main__":
    main()
