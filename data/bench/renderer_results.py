#!/usr/bin/env python3
"""Makes docs/reports/renderers-1-4.csv and those beside it of runs: verdicts, PSNR and CPU time of each renderer.

    python3 data/bench/renderer_results.py outputs-A/results.json [...] > docs/reports/renderers-1-4.csv
    python3 data/bench/renderer_results.py --no-times outputs-B/results.json > docs/reports/gltf-1-8.csv

All runs must be of one suite and size. A failure that is known is a failure here. Times are left out where the machine
was not idle, or is none of those that the renderer is made for."""

import argparse
import csv
import json
import sys


def worst_verdict(run, renderer, requirement):
    """Of all images of a requirement, whatever is expected of them."""
    verdicts = {target["verdict"] for target in run["targets"]
                if target["renderer"] == renderer and target["requirement"] == requirement}
    others = verdicts - {"pass", "pass with remarks", "unsupported", "inconclusive"}
    return next((verdict for verdict in [*sorted(others), "inconclusive", "unsupported"] if verdict in verdicts), "pass")


def rows_of(run, has_times):
    for renderer in run["renderers"]:
        seconds = f'{renderer["cpu_seconds"]:.0f}' if has_times else ""
        for requirement in run["requirements"]:
            cell = requirement["renderers"].get(renderer["name"])
            if cell is None:
                continue
            decibels = cell.get("lowest_psnr_db")
            yield [renderer["name"], renderer["version"], seconds, renderer["measured"],
                   requirement["code"], requirement["title"],
                   worst_verdict(run, renderer["name"], requirement["code"]), "" if decibels is None else f"{decibels:.1f}"]


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--no-times", action="store_true", help="leave out what each renderer took")
    parser.add_argument("files", nargs="+", metavar="results.json")
    arguments = parser.parse_args()
    files = arguments.files
    runs = []
    for file in files:
        with open(file, encoding="utf-8") as text:
            runs.append(json.load(text))
    for file, run in zip(files, runs):
        if (run["suite"], run["size"]) != (runs[0]["suite"], runs[0]["size"]):
            sys.exit(f"{file}: is of suite {run['suite']} at size {run['size']}; "
                     f"expected {runs[0]['suite']} at {runs[0]['size']}")
    out = csv.writer(sys.stdout, lineterminator="\n")
    out.writerow(["renderer", "version", "cpu_seconds", "measured", "requirement", "title", "verdict", "psnr_db"])
    for run in runs:
        out.writerows(rows_of(run, not arguments.no_times))


main()
