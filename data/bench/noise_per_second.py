#!/usr/bin/env python3
"""Noise times the root of CPU time, which no number of samples changes: a table in Markdown of a run.

    orbs run --suite gi --size 1/4 -r orbs,cycles -s secondary,... --fixed-samples -o outputs
    python3 data/bench/noise_per_second.py outputs data/references/gi

Noise is the standard deviation of the whole image by its seeds, in percent of the mean of the reference, and the time is that
of all its renders with their starts. oiiotool must be installed."""

import csv
import math
import sys

from cache_in_sphere import mean_of


def main(run, references):
    with open(f"{run}/results.csv", encoding="utf-8") as file:
        rows = [row for row in csv.DictReader(file) if row["noise_squared"]]
    renderers = list(dict.fromkeys(row["renderer"] for row in rows))
    print("| % √s | " + " | ".join(renderers) + " |\n" + "|---" * (len(renderers) + 1) + "|")
    for target in dict.fromkeys(row["target"] for row in rows):
        mean = mean_of(f"{references}/{target}.exr")
        cells = {row["renderer"]: 100 / mean * math.sqrt(float(row["noise_squared"]) * float(row["cpu_seconds"]))
                 for row in rows if row["target"] == target}
        print(f"| {target} | " + " | ".join(f"{cells[name]:.1f}" if name in cells else "–" for name in renderers) + " |")


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(*sys.argv[1:])
