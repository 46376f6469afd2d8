#!/usr/bin/env python3
"""Prints a hash of the pixels of every scene of the suites, to see whether two systems make the same images to the bit.

    image_hashes.py <build folder> [<pattern>...] > here.txt    on each system, then: diff here.txt there.txt

Each scene is rendered by orbs-tracer at an eighth of its width and height, and no less than 16 pixels, with 4 samples
per pixel; a pattern is a part of the path of the scene's file. Files cannot be compared in place of pixels: another zlib packs them in other bytes.
"""
import concurrent.futures
import hashlib
import itertools
import json
import os
import pathlib
import struct
import subprocess
import sys
import tempfile
import zlib

ROOT = pathlib.Path(__file__).resolve().parents[2]
SHRINK = 8
LEAST_SIDE = 16
SIDE = 1024  # of a camera that says none
SAMPLES = 4


def scene_files(patterns):
    found = set()
    for case in ROOT.glob("data/cases/*/*/case.json"):
        for scene in json.loads(case.read_text(encoding="utf-8")).get("scenes", []):
            found.add((case.parent / scene["file"]).resolve().relative_to(ROOT))
    return sorted(file for file in found if not patterns or any(pattern in str(file) for pattern in patterns))


def unpacked(data, size):
    """The lines of a chunk of an OpenEXR file: zipped differences of bytes, first those of even places (OpenEXR's ZIP)."""
    if len(data) == size:
        return data
    sums = bytes(itertools.accumulate(zlib.decompress(data), lambda a, b: (a + b - 128) & 255))
    lines = bytearray(size)
    lines[0::2] = sums[: (size + 1) // 2]
    lines[1::2] = sums[(size + 1) // 2 :]
    return bytes(lines)


def text_at(data, at):
    end = data.index(0, at)
    return data[at:end].decode(), end + 1


def read_exr(file):
    """Channels and pixels of an image of scan lines, as orbs-tracer writes it: the names with their types, and all lines."""
    data = file.read_bytes()
    attributes, at = {}, 8
    while data[at] != 0:
        name, at = text_at(data, at)
        _, at = text_at(data, at)
        (length,) = struct.unpack_from("<i", data, at)
        attributes[name] = data[at + 4 : at + 4 + length]
        at += 4 + length
    channels, i = [], 0
    while attributes["channels"][i] != 0:
        name, i = text_at(attributes["channels"], i)
        channels.append((name, struct.unpack_from("<i", attributes["channels"], i)[0]))
        i += 16
    left, top, right, bottom = struct.unpack("<4i", attributes["dataWindow"])
    line_bytes = (right - left + 1) * sum(2 if kind == 1 else 4 for _, kind in channels)
    per_chunk = {0: 1, 2: 1, 3: 16}[attributes["compression"][0]]
    count = -(-(bottom - top + 1) // per_chunk)
    lines = b""
    for offset in struct.unpack_from(f"<{count}Q", data, at + 1):
        y, size = struct.unpack_from("<2i", data, offset)
        height = min(per_chunk, bottom - y + 1)
        lines += unpacked(data[offset + 8 : offset + 8 + size], height * line_bytes)
    return channels, lines


def image_hash(build, scene, folder):
    camera = json.loads((ROOT / scene).read_text(encoding="utf-8"))["camera"]
    sides = [camera.get(side, SIDE) for side in ("width", "height")]
    size = [str(max(side // SHRINK, min(side, LEAST_SIDE))) for side in sides]
    image = folder / (str(scene).replace("/", "_") + ".exr")
    command = [build / "orbs-tracer", ROOT / scene, "-o", image, "--spp", str(SAMPLES), "--seed", "1", "--threads", "1",
               "--width", size[0], "--height", size[1], "--plugin-folder", build / "plugins"]
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True)
    if not image.exists():
        return f"none: {(done.stderr.strip().splitlines() or [f'exit status {done.returncode}'])[-1]}"
    channels, lines = read_exr(image)
    return hashlib.sha256(repr(channels).encode() + lines).hexdigest()[:16]


def main(build, patterns):
    scenes = scene_files(patterns)
    with tempfile.TemporaryDirectory() as kept, concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        folder = pathlib.Path(os.environ.get("ORBS_KEEP_IMAGES", kept))
        folder.mkdir(parents=True, exist_ok=True)
        for scene, found in zip(scenes, pool.map(lambda scene: image_hash(build, scene, folder), scenes)):
            print(found, scene, flush=True)


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    main(pathlib.Path(sys.argv[1]).resolve(), sys.argv[2:])
