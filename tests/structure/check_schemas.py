#!/usr/bin/env python3
"""Every case, scene and configuration file against data/schema, which editors complete and check with.

    check_schemas.py <repository>

The schemas are also shown to refuse: each example in WRONG is a right file with one mistake.
"""
import copy
import json
import pathlib
import sys

try:
    import jsonschema
except ImportError:
    sys.exit("python3-jsonschema is missing: ./bootstrap test installs it.")

SCENE = {
    "format": "orbs-scene/1",
    "name": "all kinds",
    "camera": {"position": [0, 0, 1], "look_at": [0, 0, 0], "fov_y": 45, "width": 8, "height": 8, "shutter": [0, 0.5],
               "end": {"position": [1, 0, 1]}},
    "cameras": {"left-1": {"position": [0, 0, 2], "look_at": [0, 0, 0]}},
    "textures": [{"name": "t", "file": "t.png", "wrap_u": "clamp"}],
    "materials": [
        {"name": "a", "type": "lambert", "reflectance": [0.5, 0.5, 0.5], "texture": {"name": "t", "matrix": [{"scale": 2}]}},
        {"name": "b", "type": "rough_glass", "ior": 1.5, "alpha": 0.1},
        {"name": "c", "type": "conductor", "index": {"n": 0.2, "k": {"wavelengths": [400, 700], "values": [2, 3]}}, "alpha": 0.2},
        {"name": "d", "type": "dielectric", "index": {"sellmeier": {"b": [1], "c_um2": [0.01]}}, "film": {"index": 1.3, "height_nm": 5}},
        {"name": "e", "type": "lambert", "reflectance": {"spectrum": "s", "scale": 0.5}},
        {"name": "f", "type": "polariser", "axis": [1, 0, 0]},
        {"name": "g", "type": "retarder", "axis": [1, 0, 0], "retardance_deg": 90},
        {"name": "h", "type": "fluorescent", "reflectance": [0, 0, 0], "reradiation": {"first_nm": 400, "width_nm": 50, "bins": 2, "shares": [[0, 0], [1, 0]]}},
    ],
    "spectra": [{"name": "s", "wavelengths": [400, 500], "values": [0, 1], "beyond": "zero"}, {"name": "w", "illuminant": "D50"}],
    "shapes": [
        {"type": "sphere", "centre": [0, 0, 0], "radius": 1, "material": "a"},
        {"type": "cone", "radius": 1, "height": 2, "caps": False, "material": "a", "matrix": [{"scale": 2}]},
        {"type": "implicit", "expression": "x^2 - 1", "low": [-2, -2, -2], "high": [2, 2, 2], "material": "a"},
        {"type": "plugin", "plugin": "saddle", "numbers": {"k": 1}, "material": "a"},
        {"type": "difference", "operands": [{"type": "box", "half_sizes": [1, 1, 1]}, {"type": "half_space", "material": "b"}], "material": "a"},
    ],
    "outputs": {"stokes": True},
    "meshes": [
        {"name": "m", "generator": "sphere", "radius": 1, "segments": 8, "material": "a"},
        {"name": "p", "parts": [{"generator": "plane", "half_size": 1, "material": "a", "matrix": [{"rotate_x": 90}]}]},
        {"name": "f", "file": "f.ply", "materials": ["a", "b"]},
        {"name": "s", "material": "a", "subdivision": {
            "points": [0, 0, 0], "faces": [0, 1, 2], "face_sizes": [3], "creases": [{"points": [0, 1], "sharpness": 0.5}],
            "corners": [{"points": [2]}], "levels": 2, "displacement": {"expression": "x", "origin": [0, 0, 0]}}},
        {"name": "i", "positions": [], "normals": [], "triangles": [], "triangle_materials": [{"material": "a", "count": 1}],
         "end": {"positions": [], "normals": []}},
    ],
    "instances": [{"mesh": "m", "matrix": [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1], "remap": ["a", "b"],
                   "end_matrix": [{"rotate_y": 30}]}],
    "lights": [{"type": "disk", "radius": 1, "radiance": [1, 1, 1], "ies": {"file": "l.ies", "point_area": True}}],
    "integrator": {"trace_depth": 5},
}
CASE = {
    "format": "orbs-case/2",
    "requirement": "M2",
    "title": "t",
    "tests": "t",
    "typical_mistake": "t",
    "scenes": [{"name": "1", "file": "1.json", "spp": 8}, {"name": "2", "file": "2.json", "reference": "1", "camera": "left"}],
    "gates": [{"metric": "psnr_srgb8", "min": 30, "reason": "another formula"}],
    "masks": [{"scene": "1", "rectangles": [[0, 0, 4, 4]], "reason": "edges"}],
    "path_shares": [{"scene": "1", "class": "EDSSL-T", "min_share": 0.01}],
    "condition_map": {"max": 0.001, "reason": "as the gate of the mean"},
}
CONFIGURATION = {
    "format": "orbs-configuration/1",
    "defaults": {"suite": "orbs", "jobs": 1},
    "suites": [{"name": "orbs", "cases": "data/cases/orbs", "references": "data/references/orbs"}],
    "renderers": [{"name": "r", "executable": "r", "declares": "G1", "command": ["{executable}", "{scene}", "{output}", "{plugin}"], "plugins": ["{build}/p.so"]}],
    "expected": [{"renderer": "r*", "version": ">=3.4 <4", "scene": "a,b", "suite": "orbs", "size": "1/4", "verdict": "fail", "reason": "t", "until": "2026-11-25", "measure": {"psnr_srgb8": 30.5, "pixels [0,0,1,1]": None}}],
}
RENDER_TIMES = {
    "format": "orbs-render-times/1",
    "machine": "2 cores",
    "suite": "orbs",
    "size": "1/4",
    "renders": [{"renderer": "r", "scene": "1", "spp": 16, "cpu_seconds": 1.5}],
}
FORMATS = {
    "scene": "orbs-scene/1",
    "case": "orbs-case/2",
    "configuration": "orbs-configuration/1",
    "render times": "orbs-render-times/1",
}
# Path to a member, and the wrong value that it is given there; the word None takes the member away.
WRONG = [
    (SCENE, ["colour"], 1),
    (SCENE, ["camera", "position"], None),
    (SCENE, ["camera", "fov_y"], 180),
    (SCENE, ["camera", "width"], 8.5),
    (SCENE, ["camera", "shutter"], [0, 1.5]),
    (SCENE, ["camera", "shutter"], [0]),
    (SCENE, ["camera", "end", "fov_y"], 30),
    (SCENE, ["meshes", 3, "end"], {"file": "e.ply"}),
    (SCENE, ["meshes", 4, "end", "normals"], None),
    (SCENE, ["meshes", 4, "end", "file"], "e.ply"),
    (SCENE, ["instances", 0, "end_matrix"], 1),
    (SCENE, ["lights", 0, "end_matrix"], [{"scale": 2}]),
    (SCENE, ["textures", 0, "wrap_v"], "mirrored"),
    (SCENE, ["textures", 0, "filter"], "bilinear"),
    (SCENE, ["meshes", 3, "subdivision", "levels"], 0),
    (SCENE, ["meshes", 3, "subdivision", "face_sizes", 0], 2),
    (SCENE, ["meshes", 3, "subdivision", "creases", 0, "sharpness"], -1),
    (SCENE, ["meshes", 3, "subdivision", "displacement", "height"], 1),
    (SCENE, ["meshes", 3, "triangle_materials"], [{"material": "a", "count": 1}]),
    (SCENE, ["materials", 0, "type"], "lambertian"),
    (SCENE, ["materials", 0, "ior"], 1.5),
    (SCENE, ["materials", 0, "reflectance", 0], 1.5),
    (SCENE, ["materials", 0, "texture", "matrix", 0], {"scale": 2, "rotate_x": 1}),
    (SCENE, ["materials", 1, "alpha"], 0),
    (SCENE, ["materials", 2, "index", "k"], None),
    (SCENE, ["materials", 2, "index", "n"], 0),
    (SCENE, ["materials", 2, "ior"], 1.5),
    (SCENE, ["materials", 3, "film", "height_nm"], -1),
    (SCENE, ["materials", 3, "index", "cauchy"], [1.5]),
    (SCENE, ["materials", 4, "reflectance", "spectrum"], None),
    (SCENE, ["materials", 4, "texture"], "t"),
    (SCENE, ["materials", 5, "axis"], [1, 0]),
    (SCENE, ["materials", 7, "reradiation", "peak_per_nm"], 1),
    (SCENE, ["materials", 7, "reradiation", "width_nm"], 2001),
    (SCENE, ["spectra", 0, "beyond"], "ends"),
    (SCENE, ["spectra", 1, "illuminant"], "F2"),
    (SCENE, ["shapes", 0, "type"], "cone"),
    (SCENE, ["shapes", 0, "material"], None),
    (SCENE, ["shapes", 1, "radius"], -1),
    (SCENE, ["shapes", 1, "waist_radius"], 1),
    (SCENE, ["shapes", 2, "expression"], 1),
    (SCENE, ["shapes", 2, "high"], None),
    (SCENE, ["shapes", 4, "type"], "half_space"),
    (SCENE, ["shapes", 4, "operands", 0, "half_sizes"], [1, 1]),
    (SCENE, ["shapes", 0, "radius"], 1e13),
    (SCENE, ["cameras", "left-1", "look_at"], None),
    (SCENE, ["cameras"], {}),
    (SCENE, ["cameras"], {"../left": {"position": [0, 0, 2], "look_at": [0, 0, 0]}}),
    (SCENE, ["shapes", 3, "plugin"], "../saddle"),
    (SCENE, ["shapes", 3, "plugin"], "saddle.so"),
    (SCENE, ["shapes", 3, "plugin"], None),
    (SCENE, ["shapes", 3, "numbers", "k"], "1"),
    (SCENE, ["shapes", 3, "radius"], 1),
    (SCENE, ["outputs", "stokes"], 1),
    (SCENE, ["lights", 0, "reflectance"], [2, 0, 0]),
    (SCENE, ["meshes", 0, "half_size"], 1),
    (SCENE, ["meshes", 0, "material"], None),
    (SCENE, ["meshes", 0, "matrix"], [{"scale": 2}]),
    (SCENE, ["meshes", 1, "parts", 0, "half_size"], "1"),
    (SCENE, ["meshes", 2, "file"], "f.stl"),
    (SCENE, ["instances", 0, "matrix", 15], None),
    (SCENE, ["lights", 0, "half_width"], 1),
    (SCENE, ["lights", 0, "radiance", 0], -1),
    (SCENE, ["integrator", "trace_depth"], 0),
    (SCENE, ["integrator", "distance"], 1),
    (SCENE, ["integrator", "type"], "ambient_occlusion"),
    (SCENE, ["integrator", "metric"], "ward"),
    (CASE, ["scenes"], []),
    (CASE, ["scenes", 1, "reference"], "../1"),
    (CASE, ["scenes", 1, "camera"], ""),
    (CASE, ["gates", 0, "min"], None),
    (CASE, ["requirement"], "M"),
    (CASE, ["masks", 0, "reason"], None),
    (CASE, ["path_shares", 0, "class"], "LDE"),
    (CASE, ["gates", 0, "reason"], None),
    (CASE, ["gates", 0, "reason"], ""),
    (CASE, ["gates", 0, "metric"], None),
    (CASE, ["gates", 0, "max"], "1"),
    (CASE, ["mean_ratio"], 0.01),
    (CASE, ["condition_map", "max"], -1),
    (CASE, ["condition_map", "reason"], None),
    (CONFIGURATION, ["renderers", 0, "comand"], []),
    (CONFIGURATION, ["renderers", 0, "name"], "a b"),
    (CONFIGURATION, ["renderers", 0, "plugins"], []),
    (CONFIGURATION, ["renderers", 0, "native_scenes"], ".xml"),
    (CONFIGURATION, ["renderers", 0, "scene_format"], "native"),
    (CONFIGURATION, ["renderers", 0, "transports"], {"polarized": "p"}),
    (CONFIGURATION, ["renderers", 0, "transports"], {"rgb": ""}),
    (CONFIGURATION, ["renderers", 0, "render_seconds"], {"pattern": "(.*)", "file": "times.json", "key": "t"}),
    (CONFIGURATION, ["renderers", 0, "render_seconds"], {"file": "times.json"}),
    (CONFIGURATION, ["renderers", 0, "trial_seconds"], {"file": "times.json"}),
    (CONFIGURATION, ["renderers", 0, "command"], "r scene"),
    (CONFIGURATION, ["expected", 0, "verdict"], "pass"),
    (CONFIGURATION, ["expected", 0, "version"], "4.0"),
    (CONFIGURATION, ["expected", 0, "size"], "1/3"),
    (CONFIGURATION, ["expected", 0, "until"], "tomorrow"),
    (CONFIGURATION, ["expected", 0, "reason"], None),
    (CONFIGURATION, ["expected", 0, "measure", "psnr_srgb8"], "30"),
    (RENDER_TIMES, ["size"], "1/3"),
    (RENDER_TIMES, ["renders", 0, "cpu_seconds"], 0),
]


def changed(document, path, value):
    document = copy.deepcopy(document)
    at = document
    for step in path[:-1]:
        at = at[step]
    if value is None:
        del at[path[-1]]
    else:
        at[path[-1]] = value
    return document


OTHER_THAN_SCENES = {
    "case.json": "case",
    "configuration.json": "configuration",
    "algorithms.json": "configuration",
    "bugs.json": "configuration",
    "irradiance-cache.json": "configuration",
    "stability.json": "configuration",
    "stability-origin.json": "configuration",
    "render-times.json": "render times",
}


def main(root):
    checkers = {}
    for format in FORMATS.values():
        schema = json.loads((root / f"data/schema/{format.replace('/', '-')}.schema.json").read_text())
        jsonschema.Draft202012Validator.check_schema(schema)
        checkers[format] = jsonschema.Draft202012Validator(schema)

    def complaints(document):
        return [f"{error.json_path}: {error.message[:300]}" for error in checkers[document["format"]].iter_errors(document)]

    problems = []
    for right in (SCENE, CASE, CONFIGURATION, RENDER_TIMES):
        problems += [f"example of {right['format']} is refused: {c}" for c in complaints(right)]
    for right, path, value in WRONG:
        if not complaints(changed(right, path, value)):
            problems.append(f"the schema of {right['format']} accepts {value!r} at {path}")
    files = [root / "configuration.json", *sorted((root / "data/cases").glob("*/*/*.json")), *sorted((root / "data/bench").glob("*.json")),
             *sorted((root / "examples").glob("*/*.json"))]
    for file in files:
        document = json.loads(file.read_text())
        expected = OTHER_THAN_SCENES.get(file.name, "scene")
        if document.get("format") != FORMATS[expected]:
            problems.append(f"{file.relative_to(root)}: format is {document.get('format')!r}, not {FORMATS[expected]}")
        else:
            problems += [f"{file.relative_to(root)}: {c}" for c in complaints(document)]
    print("\n".join(problems))
    print(f"{len(files)} files, {len(WRONG)} wrong examples, {len(problems)} problems")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1])))
