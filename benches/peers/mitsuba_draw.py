"""Draws the mesh picture with Mitsuba: `mitsuba_draw.py VARIANT OBJ WIDTH HEIGHT`. One sample a pixel, direct light, one thread."""

import sys

import drjit as dr
import mitsuba as mi

from scenes import EYE, FOV, LAMP, LOOK_AT, SKY


def main(variant, obj, width, height):
    mi.set_variant(variant)
    dr.set_thread_count(1)
    matt = lambda color: {"type": "twosided", "bsdf": {"type": "diffuse", "reflectance": {"type": "rgb", "value": color}}}
    flat = mi.ScalarTransform4f().rotate([1, 0, 0], -90).scale([1000, 1000, 1])
    scene = mi.load_dict({
        "type": "scene",
        "integrator": {"type": "direct", "emitter_samples": 1, "bsdf_samples": 0},
        "sensor": {
            "type": "perspective",
            "fov": FOV,
            "fov_axis": "y",
            "to_world": mi.ScalarTransform4f().look_at(origin=EYE, target=LOOK_AT, up=[0, 1, 0]),
            "film": {"type": "hdrfilm", "width": width, "height": height, "rfilter": {"type": "box"}},
            "sampler": {"type": "independent", "sample_count": 1},
        },
        "lamp": {"type": "point", "position": LAMP, "intensity": {"type": "rgb", "value": 100 * SKY}},
        "floor": {"type": "rectangle", "to_world": flat, "bsdf": matt([0.7] * 3)},
        "mesh": {"type": "obj", "filename": obj, "face_normals": True, "bsdf": matt([0.6, 0.3, 0.2])},
    })
    mi.util.write_bitmap("mitsuba.png", mi.render(scene), write_async=False)


if __name__ == "__main__":
    main(sys.argv[1], sys.argv[2], *map(int, sys.argv[3:]))
