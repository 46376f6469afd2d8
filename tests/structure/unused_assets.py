#!/usr/bin/env python3
"""What a scene holds but does not show costs its path loop nothing.

    unused_assets.py <orbs-tracer> <root of the sources>

Counts the instructions of rendering, without those of loading, with callgrind: no clock, so the machine's load does not
matter. The box of M1 with materials, textures, spectra and metals that no surface has must take as many as without them;
the same box with the spectrum on its ball must not, which shows that the count would tell.
"""
import copy
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile

MOST_RATIO = 1.001
# What the page shows; ORBS_WRITE_DOCUMENTATION=1 writes it.
SHOWN = "web/src/effects/unused_costs.json"

FILM = {"index": 1.5, "height_nm": 550}
GLOW = {"peak_per_nm": 0.01375, "absorbed_nm": 370, "absorbed_reach_nm": 40, "emitted_nm": 650, "emitted_reach_nm": 50}


def with_unused_assets(scene, common):
    """The scene with something of every kind that only other scenes call for."""
    out = copy.deepcopy(scene)
    out["textures"] = [{"name": "chess", "file": str(common / "textures/chess_white.png")}]
    out["spectra"] = [
        {"name": "D50", "illuminant": "D50"},
        {"name": "yellow", "file": str(common / "spectra/yellow_paper.csv"), "column": "reflectance"},
    ]
    out["materials"] += [
        {"name": "unused chess", "type": "lambert", "reflectance": [0.7, 0.7, 0.7], "texture": "chess"},
        {"name": "unused paper", "type": "lambert", "reflectance": {"spectrum": "yellow"}},
        {"name": "unused glass", "type": "glass", "ior": 1.5},
        {"name": "unused gloss", "type": "ggx", "colour": [0.5, 0.5, 0.5], "alpha": 0.1},
        {"name": "unused copper", "type": "conductor", "index": {"file": str(common / "spectra/metals/copper.csv")},
         "alpha": 0.2, "distribution": "ggx", "masking": "separable"},
        {"name": "unused film", "type": "conductor", "index": {"n": 1.9, "k": 1.5}, "film": FILM},
        {"name": "unused filter", "type": "polariser", "axis": [1, 0, 0]},
        {"name": "unused glow", "type": "fluorescent", "reflectance": {"spectrum": "yellow"}, "reradiation": GLOW},
    ]
    return out


def with_ball_of(scene, material):
    out = copy.deepcopy(scene)
    for mesh in out["meshes"]:
        if mesh["name"] == "ball":
            mesh["material"] = material
    return out


def instructions(tracer, scene, folder, name):
    file = folder / f"{name}.json"
    file.write_text(json.dumps(scene), encoding="utf-8")
    counts = folder / f"{name}.callgrind"
    command = ["valgrind", "--tool=callgrind", f"--callgrind-out-file={counts}", "--toggle-collect=orbs::tracer::render(*",
               tracer, str(file), "-o", str(folder / f"{name}.exr"),
               "--spp", "8", "--width", "32", "--height", "32", "--threads", "1"]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        sys.exit(f"{' '.join(command)} failed:\n{done.stdout}{done.stderr}")
    found = re.search(r"^summary: (\d+)", counts.read_text(encoding="utf-8"), re.MULTILINE)
    if not found or int(found.group(1)) == 0:
        sys.exit(f"{name}: callgrind counted nothing; has orbs::tracer::render another name?")
    return int(found.group(1))


def main(tracer, root):
    root = pathlib.Path(root)
    plain = json.loads((root / "data/cases/orbs/m1_lambert/101.json").read_text(encoding="utf-8"))
    loaded = with_unused_assets(plain, root / "data/common")
    with tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(scratch)
        without = instructions(tracer, plain, folder, "without")
        unused = instructions(tracer, loaded, folder, "unused")
        used = instructions(tracer, with_ball_of(loaded, "unused paper"), folder, "used")
    print(f"instructions of rendering: {without} without, unused {unused / without:.6f}, used {used / without:.4f} of that")
    problems = []
    if unused > MOST_RATIO * without:
        problems.append(f"assets that no surface has cost more than {MOST_RATIO - 1:.1%}")
    if used <= MOST_RATIO * without:
        problems.append("a spectrum in use costs nothing either, so the count does not tell")
    problems += check_shown(root / SHOWN, {"scene": "m1_lambert/101", "samples": 32 * 32 * 8, "without": without,
                                           "unused_ratio": round(unused / without, 6), "used_ratio": round(used / without, 4)})
    print("\n".join(problems))
    return 1 if problems else 0


def check_shown(file, counted):
    """The page's numbers are these: to the tolerance of the test, since compilers differ in single instructions."""
    if os.environ.get("ORBS_WRITE_DOCUMENTATION") == "1":
        file.write_text(json.dumps(counted, indent=2) + "\n", encoding="utf-8")
    shown = json.loads(file.read_text(encoding="utf-8"))
    fits = all(shown[key] == counted[key] for key in ("scene", "samples"))
    fits = fits and abs(shown["unused_ratio"] - counted["unused_ratio"]) <= MOST_RATIO - 1
    fits = fits and shown["used_ratio"] > MOST_RATIO
    return [] if fits else [f"{SHOWN} shows {shown}, counted were {counted}: ORBS_WRITE_DOCUMENTATION=1 writes it"]


if __name__ == "__main__":
    sys.exit(main(sys.argv[1], sys.argv[2]))
