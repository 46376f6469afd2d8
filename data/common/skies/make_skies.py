#!/usr/bin/env python3
"""Writes the latitude-longitude images of this folder: python3 make_skies.py. Standard library only; same bytes
on every run.

u = 1/2 + atan2(x, -z) / (2 pi), v = 1/2 + asin(y) / pi: the middle of an image lies towards -z, its right quarter
towards +x, its top towards +y. Each texel has the radiance of the direction of its centre.
"""
import math
import struct
import zlib
from pathlib import Path

FOLDER = Path(__file__).resolve().parent


def packed_line(line: bytes) -> bytes:
    """A line as OpenEXR's ZIPS compression stores it: even bytes, then odd ones, as differences, deflated."""
    split = line[0::2] + line[1::2]
    differences = split[:1] + bytes((b - a + 128) % 256 for a, b in zip(split, split[1:]))
    packed = zlib.compress(differences, 9)
    return packed if len(packed) < len(line) else line


def write_exr(name: str, width: int, height: int, radiance) -> None:
    """radiance(column, row) from the top left: three numbers, stored as 32 bit floats."""
    def attribute(key: str, kind: str, value: bytes) -> bytes:
        return f"{key}\0{kind}\0".encode() + struct.pack("<i", len(value)) + value

    channels = b"".join(c + b"\0" + struct.pack("<iB3xii", 2, 0, 1, 1) for c in (b"B", b"G", b"R")) + b"\0"
    window = struct.pack("<iiii", 0, 0, width - 1, height - 1)
    header = struct.pack("<ii", 20000630, 2) + b"".join([
        attribute("channels", "chlist", channels), attribute("compression", "compression", b"\x02"),
        attribute("dataWindow", "box2i", window), attribute("displayWindow", "box2i", window),
        attribute("lineOrder", "lineOrder", b"\0"), attribute("pixelAspectRatio", "float", struct.pack("<f", 1)),
        attribute("screenWindowCenter", "v2f", struct.pack("<ff", 0, 0)),
        attribute("screenWindowWidth", "float", struct.pack("<f", 1))]) + b"\0"
    offset = len(header) + 8 * height
    offsets, blocks = [], []
    for row in range(height):
        pixels = [radiance(column, row) for column in range(width)]
        line = b"".join(struct.pack(f"<{width}f", *(p[c] for p in pixels)) for c in (2, 1, 0))
        block = packed_line(line)
        offsets.append(offset)
        blocks.append(struct.pack("<ii", row, len(block)) + block)
        offset += 8 + len(block)
    (FOLDER / name).write_bytes(header + struct.pack(f"<{height}Q", *offsets) + b"".join(blocks))


def direction(column: int, row: int, width: int, height: int):
    longitude = ((column + 0.5) / width - 0.5) * 2 * math.pi
    latitude = (0.5 - (row + 0.5) / height) * math.pi
    return (math.cos(latitude) * math.sin(longitude), math.sin(latitude),
            -math.cos(latitude) * math.cos(longitude))


def smooth(low: float, high: float, x: float) -> float:
    t = min(max((x - low) / (high - low), 0), 1)
    return t * t * (3 - 2 * t)


def mix(a, b, t: float):
    return tuple(x + (y - x) * t for x, y in zip(a, b))


def linear(d):
    """Red grows along x, green along y, blue along z."""
    return (1 + 0.8 * d[0], 1 + 0.8 * d[1], 1 + 0.8 * d[2])


def lights_towards(d):
    """A studio: a dim grey room with a warm lamp, a cool window and a green wall in three unlike directions."""
    colour = mix((0.10, 0.09, 0.08), (0.35, 0.38, 0.42), smooth(-0.6, 0.8, d[1]))
    def patch(axis, inner_deg, outer_deg, value, base):
        size = math.sqrt(sum(a * a for a in axis))
        cosine = sum(a * b for a, b in zip(axis, d)) / size
        return mix(base, value, smooth(math.cos(math.radians(outer_deg)), math.cos(math.radians(inner_deg)), cosine))
    colour = patch((-0.8, -0.1, -0.6), 24, 30, (0.1, 0.8, 0.2), colour)
    colour = patch((0.9, 0.35, -0.3), 14, 18, (1.5, 3, 6), colour)
    return patch((-0.3, 0.7, 0.65), 12, 15, (20, 15, 8.5), colour)


def main() -> None:
    for name, width, height, of in (("linear.exr", 256, 128, linear), ("studio.exr", 256, 128, lights_towards)):
        write_exr(name, width, height, lambda c, r, w=width, h=height, f=of: f(direction(c, r, w, h)))
    write_exr("sun.exr", 1024, 512, lambda column, row: (1, 1, 1) if (column, row) == (640, 128) else (0, 0, 0))


if __name__ == "__main__":
    main()
