#!/usr/bin/python3
"""A renderer that is elsewhere, for tests: reads what `orbs export -r obj` and `-r ply` write, and nothing else.

    description_renderer.py <scene.obj or description.json> <image.exr> <samples> <seed>

It makes a scene of the description and the meshes, and has it rendered by the program in ORBS_TRACER. So whatever
the description leaves out makes another image than the reference.
"""

import json
import os
import pathlib
import subprocess
import sys

SHAPES = {"rectangle": "rect", "disk": "disk", "sphere": "sphere"}
KEYS = ("type", "reflectance", "roughness", "ior", "colour", "alpha", "radiance")


def lamp(given):
    made = {"type": SHAPES[given["shape"]], "radiance": given["radiance"], "matrix": given["matrix"]}
    if given["shape"] == "rectangle":
        made.update(half_width=given["width_m"] / 2, half_length=given["length_m"] / 2)
    else:
        made["radius"] = given["radius_m"]
    if "ies" in given:
        made["ies"] = {key: given["ies"][key] for key in ("file", "matrix", "point_area")}
    return made


def material(given):
    made = {key: given[key] for key in KEYS if key in given} | {"name": given["name"]}
    if "texture" in given:
        made["texture"] = given["texture"]["file"]
    return made


def textures(materials):
    files = {m["texture"]["file"]: m["texture"] for m in materials if "texture" in m}
    return [{"name": file, "file": file, "wrap_u": t["wrap_u"], "wrap_v": t["wrap_v"]} for file, t in files.items()]


def meshes(given, scene_file):
    """One mesh whose materials the OBJ names, or one for each PLY."""
    if scene_file.suffix == ".obj":
        return [{"name": "all", "file": scene_file.name}] if given["surfaces"] else []
    return [{"name": s["file"], "file": s["file"], "material": s["material"]} for s in given["surfaces"]]


def scene_of(given, scene_file):
    camera = {key: given["camera"][key] for key in ("position", "look_at", "up")}
    camera.update(fov_y=given["camera"]["fov_y_degrees"])
    camera.update(width=given["camera"]["width_px"], height=given["camera"]["height_px"])
    shown = meshes(given, scene_file)
    return {
        "format": "orbs-scene/1", "name": given["scene"], "camera": camera,
        "environment": given["background"]["radiance"],
        "textures": textures(given["materials"]), "materials": [material(m) for m in given["materials"]],
        "meshes": shown, "instances": [{"mesh": mesh["name"]} for mesh in shown],
        "lights": [lamp(one) for one in given["lamps"]],
        "integrator": {"trace_depth": given["trace_depth"]},
    }  # fmt: skip


def main(scene, image, samples, seed):
    scene_file = pathlib.Path(scene)
    given = json.loads((scene_file.parent / "description.json").read_text())
    made = scene_file.parent / "made-of-description.json"
    made.write_text(json.dumps(scene_of(given, scene_file)))
    command = [os.environ["ORBS_TRACER"], str(made), "-o", image, "--spp", samples, "--seed", seed]
    subprocess.run(command, check=True)
    # The program writes the hash of the scene that was made here, which another renderer would not have.
    file = pathlib.Path(image)
    file.write_bytes(file.read_bytes().replace(b"orbs.scene_hash\0", b"made.scene_hash\0"))


main(*sys.argv[1:])
