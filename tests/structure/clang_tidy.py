#!/usr/bin/env python3
"""clang-tidy over every source of src/ and examples/ and every snippet, each only when it, a header that it includes or
a rule changed.

    clang_tidy.py <repository> <build folder>

Nearly all of its time goes into the headers of the standard library, so sources that the build compiles as one
(cmake/unity.cmake) are checked as one: a source that includes them all takes hardly longer than one of them (13 sources
of studies/cost: 7 s, not 87 s). When such a source has a finding, its halves are checked, down to single files: what is
reported is always of a file by itself. A clean file leaves an empty file named after the hash of everything that could change the
answer, in <build>/clang-tidy/clean/. Headers are checked through the sources that include them (HeaderFilterRegex).
"""
import concurrent.futures
import hashlib
import json
import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys

INCLUDE = re.compile(rb'^\s*#\s*include\s+"([^"]+)"', re.MULTILINE)
# clang cannot read the precompiled headers of g++.
PRECOMPILED = re.compile(r'-Winvalid-pch -include (?:"[^"]*"|\S+) ')
# The commands are for g++: clang does not know each of its flags.
GCC_ONLY = [f"--extra-arg=-Wno-{name}" for name in
            ("ignored-optimization-argument", "unused-command-line-argument", "unknown-warning-option")]


def configured(root, folder):
    """Compile commands of a build in which sources are compiled as one, whatever the preset of the build at hand."""
    subprocess.run(["cmake", "-S", str(root), "-B", str(folder), "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release",
                    "-DCMAKE_EXPORT_COMPILE_COMMANDS=ON", "-DORBS_UNITY=ON"], check=True, stdout=subprocess.DEVNULL)
    entries = json.loads((folder / "compile_commands.json").read_text())
    return [{**entry, "command": PRECOMPILED.sub("", entry["command"])} for entry in entries]


def by_source(commands):
    """An entry for each source, with the file that the build compiles it by as its group."""
    for entry in commands:
        file = pathlib.Path(entry["file"])
        together = file.parent.name == "Unity"
        for source in [name.decode() for name in INCLUDE.findall(file.read_bytes())] if together else [entry["file"]]:
            yield {**entry, "file": source, "group": entry["file"]}


def own_headers(file, src, known):
    """`file` and all headers of ours that it includes, directly or not. Those of data/snippets are ours too."""
    todo, found = [file], set()
    while todo:
        at = todo.pop()
        if at in found or not at.is_file():
            continue
        found.add(at)
        if at not in known:
            names = [name.decode() for name in INCLUDE.findall(at.read_bytes())]
            known[at] = [folder / name for name in names for folder in (src, src.parent / "data", at.parent)]
        todo += known[at]
    return sorted(found)


def fingerprint(entry, src, rules, known):
    digest = hashlib.sha256(rules + flags(entry).encode())
    for file in own_headers(pathlib.Path(entry["file"]), src, known):
        digest.update(os.path.relpath(file, src.parent).encode() + b"\0" + file.read_bytes() + b"\0")
    return digest.hexdigest()


def flags(entry):
    """Of the command, without what is a file's own."""
    return entry["command"].split(" -o ")[0]


def batches(entries):
    """Entries that are compiled as one; the largest first."""
    found = {}
    for entry in entries:
        found.setdefault(entry["group"], []).append(entry)
    return sorted(found.values(), key=len, reverse=True)


def check(tool, folder, batch):
    """The findings of the batch, file by file; marks what has none as clean."""
    name = hashlib.sha256("".join(entry["mark"] for entry in batch).encode()).hexdigest()
    work = folder / name
    work.mkdir(exist_ok=True)
    source = batch[0]["file"]
    if len(batch) > 1:
        source = str(work / "all.cpp")
        includes = [f'#include "{entry["file"]}"  // NOLINT(bugprone-suspicious-include)\n' for entry in batch]
        pathlib.Path(source).write_text("".join(includes))
    entry = {"directory": batch[0]["directory"], "file": source, "command": f"{flags(batch[0])} -c {shlex.quote(source)}"}
    (work / "compile_commands.json").write_text(json.dumps([entry]))
    done = subprocess.run([tool, "--quiet", *GCC_ONLY, "-p", str(work), source], capture_output=True, text=True)
    shutil.rmtree(work)
    if done.returncode == 0:
        for entry in batch:
            (folder / "clean" / entry["mark"]).touch()
        return []
    if len(batch) == 1:
        return [done.stdout + done.stderr]
    half = len(batch) // 2
    return check(tool, folder, batch[:half]) + check(tool, folder, batch[half:])


def main(root, build):
    tool = shutil.which("clang-tidy-14") or shutil.which("clang-tidy")
    # Each version finds other things. To ctest, 77 says that the test is skipped.
    if not tool or b"version 14." not in subprocess.check_output([tool, "--version"]):
        print("clang-tidy 14 is not installed, so the sources were not checked with it.")
        return 77
    # clang-tidy reads the rules that lie above the file: those of the repository, for the build folder is inside it.
    src, folder = root / "src", build / "clang-tidy"
    (folder / "clean").mkdir(parents=True, exist_ok=True)
    rules = (root / ".clang-tidy").read_bytes() + subprocess.check_output([tool, "--version"])
    # A snippet's own source, written by tests/CMakeLists.txt, is the only one that sees all of them.
    # What a test compiles again is checked once.
    entries = {e["file"]: e for e in by_source(configured(root, folder / "commands"))
               if e["file"].startswith((f"{src}/", f"{root}/examples/")) or e["file"].endswith("_alone.cpp")}.values()
    known = {}
    for entry in entries:
        entry["mark"] = fingerprint(entry, src, rules, known)
    todo = [entry for entry in entries if not (folder / "clean" / entry["mark"]).exists()]
    with concurrent.futures.ThreadPoolExecutor(max_workers=2) as pool:
        reports = []
        for found in pool.map(lambda batch: check(tool, folder, batch), batches(todo)):
            reports += found
            for report in found:  # at once: the rest can take minutes
                print(report, flush=True)
    print(f"{len(entries)} sources, {len(todo)} of them new or changed, {len(reports)} with findings")
    return 1 if reports or not entries else 0


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])))
