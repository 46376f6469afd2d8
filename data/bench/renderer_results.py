#!/usr/bin/env python3
"""Makes docs/reports/renderers-1-4.csv and those beside it of runs: verdicts, PSNR and CPU time of each renderer.

    python3 data/bench/renderer_results.py outputs-A/results.json [...] > docs/reports/renderers-1-4.csv
    python3 data/bench/renderer_results.py --no-times outputs-B/results.json > docs/reports/gltf-1-8.csv
    python3 data/bench/renderer_results.py --scenes outputs-C/results.json [...] > docs/reports/everyday-1-4.csv

All runs must be of one suite and size. A failure that is known is a failure here. Times are left out where the machine
was not idle, or is none of those that the renderer is made for. With --scenes a verdict is that of the scenes which the
renderer can be given, the last columns count them, and several runs of one renderer are one: the later one wins for its
scenes."""

import argparse
import csv
import json
import math
import sys

COUNTED = ["pass", "fail", "inconclusive", "unsupported"]


def counted_as(verdict):
    if verdict == "pass with remarks":
        return "pass"
    return verdict if verdict in COUNTED else "fail"


def worst_verdict(targets):
    """Of all images, whatever is expected of them."""
    verdicts = {target["verdict"] for target in targets}
    others = verdicts - {"pass", "pass with remarks", "unsupported", "inconclusive"}
    return next((verdict for verdict in [*sorted(others), "inconclusive", "unsupported"] if verdict in verdicts), "pass")


def psnr_of(target):
    """The image's own, in dB; nothing where it was not measured."""
    found = [math.inf if measure.get("infinite") else measure["value"] for measure in target["measures"]
             if measure["name"] == "psnr_srgb8"]
    return next(iter(found), None)


def decibels_text(decibels):
    return "" if decibels is None else f"{decibels:.1f}"


def rows_of(run, has_times):
    for renderer in run["renderers"]:
        seconds = f'{renderer["cpu_seconds"]:.0f}' if has_times else ""
        for requirement in run["requirements"]:
            cell = requirement["renderers"].get(renderer["name"])
            if cell is None:
                continue
            targets = [target for target in run["targets"]
                       if (target["renderer"], target["requirement"]) == (renderer["name"], requirement["code"])]
            yield [renderer["name"], renderer["version"], seconds, renderer["measured"],
                   requirement["code"], requirement["title"],
                   worst_verdict(targets), decibels_text(cell.get("lowest_psnr_db"))]


def rows_with_scenes(runs):
    titles, versions, targets = {}, {}, {}
    for run in runs:
        titles |= {requirement["code"]: requirement["title"] for requirement in run["requirements"]}
        for renderer in run["renderers"]:
            versions[renderer["name"]] = versions.get(renderer["name"]) or renderer["version"]
        for target in run["targets"]:
            if target["verdict"] != "skipped":
                targets[target["renderer"], target["requirement"], target["target"]] = target
    for renderer, version in versions.items():
        for code, title in titles.items():
            all_targets = [target for key, target in targets.items() if key[:2] == (renderer, code)]
            given = [target for target in all_targets if target["verdict"] != "unsupported"]
            verdict = worst_verdict(given) if given else "unsupported"
            found = [psnr for target in given if (psnr := psnr_of(target)) is not None]
            counts = [sum(counted_as(target["verdict"]) == word for target in all_targets) for word in COUNTED]
            yield [renderer, version, "", "", code, title, verdict, decibels_text(min(found, default=None)), *counts]


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--no-times", action="store_true", help="leave out what each renderer took")
    parser.add_argument("--scenes", action="store_true",
                        help="count scenes, leave out times, and let a later run of a renderer win for its scenes")
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
    header = ["renderer", "version", "cpu_seconds", "measured", "requirement", "title", "verdict", "psnr_db"]
    if arguments.scenes:
        out.writerow(header + COUNTED)
        out.writerows(rows_with_scenes(runs))
        return
    out.writerow(header)
    for run in runs:
        out.writerows(rows_of(run, not arguments.no_times))


main()
