#!/usr/bin/env python3
"""clang-tidy over every source of src/ and every snippet, two at a time, each only when it, a header that it includes or
a rule changed.

    clang_tidy.py <repository> <build folder with compile_commands.json>

A clean file leaves an empty file named after the hash of everything that could change the answer, in
<build>/clang-tidy-clean/. Headers are checked through the sources that include them (HeaderFilterRegex).
"""
import concurrent.futures
import hashlib
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys

INCLUDE = re.compile(rb'^\s*#\s*include\s+"([^"]+)"', re.MULTILINE)


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
    digest = hashlib.sha256(rules + entry["command"].encode())
    for file in own_headers(pathlib.Path(entry["file"]), src, known):
        digest.update(os.path.relpath(file, src.parent).encode() + b"\0" + file.read_bytes() + b"\0")
    return digest.hexdigest()


def check(tool, build, clean, entry, mark):
    if (clean / mark).exists():
        return None
    # The commands are for g++: clang does not know each of its optimisation flags.
    gcc_only = ["--extra-arg=-Wno-ignored-optimization-argument", "--extra-arg=-Wno-unused-command-line-argument"]
    command = [tool, "--quiet", *gcc_only, "-p", str(build), entry["file"]]
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode == 0:
        (clean / mark).touch()
        return None
    return done.stdout + done.stderr


def main(root, build):
    tool = shutil.which("clang-tidy-14") or shutil.which("clang-tidy")
    if not tool:
        sys.exit("clang-tidy is missing: ./bootstrap test installs it (Debian package clang-tidy).")
    src, clean = root / "src", build / "clang-tidy-clean"
    clean.mkdir(exist_ok=True)
    rules = (root / ".clang-tidy").read_bytes() + subprocess.check_output([tool, "--version"])
    commands = json.loads((build / "compile_commands.json").read_text())
    # A snippet's own source, written by tests/CMakeLists.txt, is the only one that sees all of them.
    entries = [e for e in commands if e["file"].startswith(f"{src}/") or e["file"].endswith("_alone.cpp")]
    known = {}
    marks = [fingerprint(entry, src, rules, known) for entry in entries]
    # Long files first: the last one to start should be a short one.
    order = sorted(range(len(entries)), key=lambda i: -os.path.getsize(entries[i]["file"]))
    todo = sum(not (clean / mark).exists() for mark in marks)
    with concurrent.futures.ThreadPoolExecutor(max_workers=2) as pool:
        reports = [r for r in pool.map(lambda i: check(tool, build, clean, entries[i], marks[i]), order) if r]
    print("\n".join(reports))
    print(f"{len(entries)} sources, {todo} of them new or changed, {len(reports)} with findings")
    return 1 if reports or not entries else 0


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])))
