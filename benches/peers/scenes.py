"""The same pictures for raytree, POV-Ray and Mitsuba: a shape on a floor under one lamp, a mesh, and mirrors with glass.

POV-Ray's space is left-handed, so all z change their signs there. Its `ambient` is a factor on a shape's own colour, its highlight
(R.V)^n as ours.
"""

import json
import math
from dataclasses import dataclass, field

EYE, LOOK_AT, FOV = [0, 2.4, 5], [0, 0.8, 0], 40
LAMP, POWER, SKY = [-3, 6, 5], 0.8, 0.5
FLOOR, AMBIENT = 0.7, 0.2


@dataclass
class Picture:
    """A picture: its objects in the languages of those that draw it, and a flag for raytree."""

    name: str
    # For raytree, as JSON.
    objects: list
    # For POV-Ray.
    povray: str
    # A mesh for Mitsuba: corners and triangles.
    mesh: tuple = None
    # Bounces.
    depth: int = 5
    # Materials for raytree besides that of the shape.
    materials: dict = field(default_factory=dict)


def vector(v):
    """A point in POV-Ray's space."""
    return f"<{v[0]:.12g},{v[1]:.12g},{-v[2]:.12g}>"


def shape(name, ours, theirs):
    """A shape with a highlight."""
    kind, rest = ours
    finish = "pigment { rgb <0.6,0.3,0.2> } finish { ambient 0.2 diffuse 1 phong 0.4 phong_size 50 } }\n"
    return Picture(name, [{kind: {"name": name, "material": "shape", **rest}}], f"{theirs} {finish}")


def bowl_of_patch():
    """Control points of a patch with a bump."""
    height = lambda i, j: 0.6 + (0.9 if 0 < i < 3 and 0 < j < 3 else 0.2 * i)
    return [[[-1.2 + 0.8 * i, height(i, j), -1.0 + 0.7 * j] for i in range(4)] for j in range(4)]


def hyperboloid(waist, radius, half):
    """The open hyperboloid of one sheet as POV-Ray's general quadric, cut off by a box."""
    x, y = 1 / waist**2, (radius**2 / waist**2 - 1) / half**2
    cut = f"box {{ <-2,{1 - half},-2>,<2,{1 + half},2> }}"
    bound = f"box {{ <-1,{1 - half},-1>,<1,{1 + half},1> }}"
    equation = f"<{x:.12g},{-y:.12g},{x:.12g}>,<0,0,0>,<0,0,0>,-1 translate y"
    return f"quadric {{ {equation} clipped_by {{ {cut} }} bounded_by {{ {bound} }}"


def bumpy_ball(rows):
    """Corners and triangles of a ball with bumps, 4 `rows` (`rows` - 1) triangles."""
    columns, corners, triangles = 2 * rows, [], []
    for i in range(rows + 1):
        for j in range(columns):
            polar, turn = math.pi * i / rows, 2 * math.pi * j / columns
            r = 0.9 * (1 + 0.05 * math.sin(14 * polar) * math.sin(14 * turn))
            direction = (math.sin(polar) * math.cos(turn), math.cos(polar), math.sin(polar) * math.sin(turn))
            corners.append([r * direction[0], 1 + r * direction[1], r * direction[2]])
    for i in range(rows):
        for j in range(columns):
            a, b = i * columns + j, i * columns + (j + 1) % columns
            c, d = a + columns, b + columns
            triangles += ([] if i == 0 else [(a, b, d)]) + ([] if i == rows - 1 else [(a, d, c)])
    return corners, triangles


def mesh(rows):
    """A mesh of matt triangles with flat normals."""
    corners, triangles = bumpy_ball(rows)
    points = ",".join(map(vector, corners))
    faces = ",".join("<%d,%d,%d>" % t for t in triangles)
    theirs = f"mesh2 {{ vertex_vectors {{ {len(corners)},{points} }} face_indices {{ {len(triangles)},{faces} }}"
    theirs += " pigment { rgb <0.6,0.3,0.2> } finish { ambient 0.2 diffuse 1 } }\n"
    ours = [{"obj": {"name": "ball", "material": "matt", "file": "mesh.obj"}}]
    return Picture("mesh", ours, theirs, mesh=(corners, triangles))


def mirrors_and_glass():
    """Balls of glass, a mirror, and shiny ones."""
    glass = "pigment { rgbt <1,1,1,0.9> } finish { ambient 0 diffuse 0 reflection 0.1 } interior { ior 1.5 } }\n"
    mirror = "pigment { rgb 0 } finish { ambient 0 diffuse 0 reflection 1 } }\n"
    shiny = "pigment { rgb <0.6,0.3,0.2> } finish { ambient 0.2 diffuse 1 phong 0.4 phong_size 50 reflection 0.1 } }\n"
    balls = [("mirror", [-1.2, 0.9, 0], 0.9), ("glass", [0.9, 0.7, 1], 0.7), ("glass", [-0.1, 0.4, 2.1], 0.4)]
    balls += [("shiny", [-2.4 + 1.2 * i, 0.4, -1.6], 0.4) for i in range(5)]
    finish = {"glass": glass, "mirror": mirror, "shiny": shiny}
    theirs = "".join(f"sphere {{ {vector(c)}, {r} {finish[m]}" for m, c, r in balls)
    ours = [{"sphere": {"name": f"ball {i}", "material": m, "center": c, "radius": r}} for i, (m, c, r) in enumerate(balls)]
    materials = {
        "glass": {"transmission": [0.9] * 3, "mirror": [0.1] * 3, "ior": 1.5},
        "mirror": {"mirror": [1] * 3},
        "shiny": {**MATERIALS["shape"], "mirror": [0.1] * 3},
    }
    return Picture("mirrors and glass", ours, theirs, depth=7, materials=materials)


MATERIALS = {
    "floor": {"ambient": [AMBIENT * FLOOR] * 3, "diffuse": [FLOOR] * 3},
    "matt": {"ambient": [0.12, 0.06, 0.04], "diffuse": [0.6, 0.3, 0.2]},
    "shape": {"ambient": [0.12, 0.06, 0.04], "diffuse": [0.6, 0.3, 0.2], "specular": [0.4] * 3, "shininess": 50},
}


def pictures():
    """All of them."""
    axis = [[-0.3, 0.1, 0], [0.2, 1.9, -0.2]]
    ends = {"base": axis[0], "top": axis[1]}
    ring = {"center": [0, 1, 0], "axis": [0, 0.6, 0.8], "major": 0.9, "minor": 0.3}
    turned = f"rotate <{-math.degrees(math.atan2(0.8, 0.6)):.12g},0,0> translate y"
    tower = {"base": [0, 0.1, 0], "top": [0, 1.9, 0], "waist": 0.4, "radius": 0.9, "open": True}
    balls = [{"sphere": {"name": "ball", "center": [0, 1, 0], "radius": 1}}]
    balls += [{"sphere": {"name": "hole", "center": [0.4, 1.4, 0.7], "radius": 0.7}}]
    patch = bowl_of_patch()
    points = ",".join(vector(p) for row in patch for p in row)
    return [
        shape("sphere", ("sphere", {"center": [0, 1, 0], "radius": 1}), "sphere { y, 1"),
        shape("cylinder", ("cylinder", {**ends, "radius": 0.7}), f"cylinder {{ {vector(axis[0])}, {vector(axis[1])}, 0.7"),
        shape("cone", ("cone", {**ends, "radius": 0.9}), f"cone {{ {vector(axis[0])}, 0.9, {vector(axis[1])}, 0"),
        shape("hyperboloid", ("hyperboloid", tower), hyperboloid(0.4, 0.9, 0.9)),
        shape("torus", ("torus", ring), f"torus {{ 0.9, 0.3 {turned}"),
        shape("torus, their exact roots", ("torus", ring), f"torus {{ 0.9, 0.3 sturm {turned}"),
        shape(
            "ball minus ball",
            ("csg", {"op": "difference", "parts": balls}),
            f"difference {{ sphere {{ y, 1 }} sphere {{ {vector([0.4, 1.4, 0.7])}, 0.7 }}",
        ),
        shape(
            "Bezier patch",
            ("bezier", {"degree": [3, 3], "patches": [patch]}),
            f"bicubic_patch {{ type 1 flatness 0.001 u_steps 4 v_steps 4 {points}",
        ),
        mesh(158),
        mirrors_and_glass(),
    ]


def for_raytree(picture):
    """The picture as a scene file."""
    floor = {"plane": {"name": "floor", "material": "floor", "point": [0, 0, 0], "normal": [0, 1, 0]}}
    return json.dumps({
        "format": "raytree-scene/1",
        "name": picture.name,
        "camera": {"eye": EYE, "look_at": LOOK_AT, "vertical_fov": FOV},
        "background": [SKY] * 3,
        "ambient": [1, 1, 1],
        "materials": {**MATERIALS, **picture.materials},
        "lights": [{"point": {"name": "lamp", "position": LAMP, "intensity": [POWER] * 3}}],
        "objects": [floor, *picture.objects],
        "settings": {"depth": picture.depth},
    })


def for_povray(picture, aspect):
    """The picture as a scene for POV-Ray 3.7; `aspect` is width / height."""
    width = math.degrees(2 * math.atan(aspect * math.tan(math.radians(FOV) / 2)))
    return "\n".join([
        "#version 3.7;",
        f"global_settings {{ assumed_gamma 1.0 max_trace_level {picture.depth + 1} }}",
        f"background {{ rgb {SKY} }}",
        f"camera {{ perspective location {vector(EYE)} right x*{aspect:.12g} up y angle {width:.12g} look_at {vector(LOOK_AT)} }}",
        f"light_source {{ {vector(LAMP)} rgb {POWER} }}",
        f"plane {{ y, 0 pigment {{ rgb {FLOOR} }} finish {{ ambient {AMBIENT} diffuse 1 }} }}",
        picture.povray,
    ])


def as_obj(mesh):
    """A mesh as an OBJ file."""
    corners, triangles = mesh
    lines = ["v %.12g %.12g %.12g" % tuple(c) for c in corners]
    lines += ["f %d %d %d" % tuple(i + 1 for i in t) for t in triangles]
    return "\n".join(lines) + "\n"
