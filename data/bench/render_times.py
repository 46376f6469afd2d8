#!/usr/bin/env python3
"""Makes render-times.json of runs: what each render took, for estimates on machines without an earlier run.

    python3 data/bench/render_times.py outputs-A/results.json [...] > data/bench/render-times.json

All runs must be of one suite and size. Of renders that occur twice the first counts."""

import json
import sys


def main(files):
    runs = []
    for file in files:
        with open(file, encoding="utf-8") as text:
            runs.append(json.load(text))
    first = runs[0]
    for file, run in zip(files, runs):
        if (run["suite"], run["size"]) != (first["suite"], first["size"]):
            sys.exit(f"{file}: is of suite {run['suite']} at size {run['size']}; "
                     f"expected {first['suite']} at {first['size']}")
    renders = {}
    for run in runs:
        for job in run["jobs"]:
            identity = job["identity"]
            if job["end"]["outcome"] == "image" and identity["spp"] > 0:
                key = (identity["renderer"], identity["scene"])
                renders.setdefault(key, (identity["spp"], job["cost"]["cpu_seconds"]))
    host = first["host"]
    rows = [json.dumps({"renderer": renderer, "scene": scene, "spp": spp, "cpu_seconds": round(cpu_seconds, 2)})
            for (renderer, scene), (spp, cpu_seconds) in renders.items()]
    print("{\n" + f'  "format": "orbs-render-times/1",\n'
          f'  "machine": {json.dumps(str(host["cores"]) + " cores of " + host["cpu"])},\n'
          f'  "suite": {json.dumps(first["suite"])},\n  "size": {json.dumps(first["size"])},\n  "renders": [\n    '
          + ",\n    ".join(rows) + "\n  ]\n}")


main(sys.argv[1:])
