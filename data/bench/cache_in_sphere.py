#!/usr/bin/env python3
"""How far the irradiance cache is off in an integrating sphere, where every point of the wall is equally bright.

    python3 data/bench/cache_in_sphere.py build/release/orbs-tracer > docs/reports/irradiance-cache-sphere.csv

The scene is that of the case a1_integrating_sphere with other reflectances, seen away from its lamp; oiiotool must be
installed. After L = rho <Le> / (1 - 0.9 rho) with <Le> = 1 (Sumpner 1892), as the lamp covers a tenth of the ball. Of
each choice: the mean over seeds in percent of L, its standard error, and the root mean square of single images."""

import json
import math
import pathlib
import re
import statistics
import subprocess
import sys
import tempfile

CASE = pathlib.Path(__file__).parent.parent / "cases/known/a1_integrating_sphere/integrating-sphere.json"
REFLECTANCES = [0.3, 0.5, 0.8, 0.9, 0.95]
SEEDS = range(1, 9)
CHOICES = {
    "path tracing": ["--integrator", "path", "--spp", "1024"],
    "the cache": ["--integrator", "irradiance_cache", "--spp", "64"],
    "coarse": ["--integrator", "irradiance_cache", "--spp", "64", "--cache-error", "0.5", "--cache-rays", "64"],
    "fine": ["--integrator", "irradiance_cache", "--spp", "64", "--cache-error", "0.05", "--cache-rays", "4096"],
}


def scene_with(reflectance):
    scene = json.loads(CASE.read_text(encoding="utf-8"))
    scene["camera"].update({"look_at": [0.2, -1, -0.3], "width": 32, "height": 32})
    scene["materials"][0]["reflectance"] = [reflectance] * 3
    return scene


def mean_of(image):
    """Of the first channel of an image file."""
    text = subprocess.run(["oiiotool", "--stats", image], check=True, capture_output=True, text=True).stdout
    return float(re.search(r"Stats Avg: (\S+)", text).group(1))


def main(tracer):
    print("reflectance,choice,mean_percent,standard_error_percent,rms_percent")
    with tempfile.TemporaryDirectory() as folder:
        scene, image = f"{folder}/scene.json", f"{folder}/image.exr"
        for reflectance in REFLECTANCES:
            pathlib.Path(scene).write_text(json.dumps(scene_with(reflectance)), encoding="utf-8")
            right = reflectance / (1 - 0.9 * reflectance)
            for choice, options in CHOICES.items():
                off = []
                for seed in SEEDS:
                    subprocess.run([tracer, scene, "-o", image, "--seed", str(seed), *options], check=True,
                                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
                    off.append(100 * (mean_of(image) / right - 1))
                error = statistics.stdev(off) / math.sqrt(len(off))
                rms = math.sqrt(statistics.mean(x * x for x in off))
                print(f"{reflectance},{choice},{statistics.mean(off):.3f},{error:.3f},{rms:.3f}", flush=True)


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    main(sys.argv[1])
