#!/usr/bin/env python3
"""Writes the images of this folder: python3 make_textures.py. Standard library only; same bytes on every run.

All images but the checkers repeat without a seam. Colours are sRGB values in [0, 1], as a PNG stores them.
"""
import math
import struct
import zlib
from pathlib import Path

FOLDER = Path(__file__).resolve().parent


def png_chunk(kind: bytes, data: bytes) -> bytes:
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))


def write_png(name: str, rows: list, grey: bool = False) -> None:
    """rows from the top; each pixel a tuple of 3 numbers, or one number when grey."""
    lines = []
    previous = None
    for row in rows:
        values = row if grey else [v for pixel in row for v in pixel]
        line = bytes(min(255, max(0, math.floor(v * 255 + 0.5))) for v in values)
        step = 1 if grey else 3
        # PNG filter 1 (difference to the left neighbour) for the first row, 2 (to the upper one) for the others.
        if previous is None:
            coded = bytes((v - (line[i - step] if i >= step else 0)) % 256 for i, v in enumerate(line))
            lines.append(b"\x01" + coded)
        else:
            lines.append(b"\x02" + bytes((v - p) % 256 for v, p in zip(line, previous)))
        previous = line
    header = struct.pack(">IIBBBBB", len(rows[0]), len(rows), 8, 0 if grey else 2, 0, 0, 0)
    body = zlib.compress(b"".join(lines), 9)
    signature = b"\x89PNG\r\n\x1a\n"
    (FOLDER / name).write_bytes(
        signature + png_chunk(b"IHDR", header) + png_chunk(b"IDAT", body) + png_chunk(b"IEND", b""))


def random_unit(*key: int) -> float:
    """[0, 1), a function of the key alone: multiply and xor-shift on 64 bits."""
    state = 0x9E3779B97F4A7C15
    for k in key:
        state = ((state ^ (k & 0xFFFFFFFF)) * 0xBF58476D1CE4E5B9) % 2**64
        state ^= state >> 31
    return (state >> 11) / 2**53


def mix(a, b, t: float):
    return tuple(x + (y - x) * t for x, y in zip(a, b))


def smooth(t: float) -> float:
    return t * t * (3 - 2 * t)


def noise(u: float, v: float, cells_u: int, cells_v: int, seed: int) -> float:
    """Value noise in [0, 1) over the unit square, which it tiles."""
    x, y = u * cells_u, v * cells_v
    i, j = math.floor(x), math.floor(y)
    fx, fy = smooth(x - i), smooth(y - j)
    def corner(a, b):
        return random_unit((i + a) % cells_u, (j + b) % cells_v, seed)
    low = corner(0, 0) + (corner(1, 0) - corner(0, 0)) * fx
    high = corner(0, 1) + (corner(1, 1) - corner(0, 1)) * fx
    return low + (high - low) * fy


def layered_noise(u, v, cells_u, cells_v, seed, octaves) -> float:
    total = weights = 0.0
    for k in range(octaves):
        total += noise(u, v, cells_u << k, cells_v << k, seed + k) / 2**k
        weights += 1 / 2**k
    return total / weights


def image(width: int, height: int, shade) -> list:
    """shade(u, v) at pixel centres; v = 0 is the bottom, as the scenes count."""
    return [[shade((x + 0.5) / width, 1 - (y + 0.5) / height) for x in range(width)] for y in range(height)]


def checker(colour):
    """2 x 2 fields; bottom-left and top-right are coloured, the others black."""
    return lambda u, v: colour if (u < 0.5) == (v < 0.5) else (0, 0, 0)


def stone(u, v):
    """texture1: mottled grey-brown stone with dark veins."""
    base = layered_noise(u, v, 4, 4, 11, 5)
    vein = abs(2 * layered_noise(u, v, 3, 3, 31, 4) - 1)
    colour = mix((0.36, 0.31, 0.27), (0.86, 0.82, 0.74), smooth(base))
    return mix((0.12, 0.10, 0.10), colour, min(1.0, 0.25 + vein * 9))


def carved_wood(u, v):
    """relief_wood: four boards with grain along u and a carved groove between them."""
    board = math.floor(v * 4)
    inside = v * 4 - board
    grain = layered_noise(u, v, 3, 48, 50 + board, 3)
    rings = 0.5 + 0.5 * math.sin(2 * math.pi * (6 * inside + 3 * noise(u, v, 2, 8, 70)))
    colour = mix((0.33, 0.19, 0.09), (0.74, 0.52, 0.30), 0.6 * grain + 0.4 * rings)
    colour = mix(colour, (0.62, 0.36, 0.18), 0.35 * random_unit(board, 90))
    edge = min(inside, 1 - inside) / 0.07
    return mix((0.10, 0.05, 0.03), colour, smooth(min(1.0, edge)))


def bricks(u, v):
    """163: red bricks in running bond with light mortar."""
    course = math.floor(v * 8)
    x = u * 4 + 0.5 * (course % 2)
    brick = math.floor(x) % 4
    to_edge = min(min(x % 1, 1 - x % 1) * 2, min(v * 8 % 1, 1 - v * 8 % 1))
    rough = layered_noise(u, v, 16, 16, 120, 3)
    clay = mix((0.48, 0.17, 0.11), (0.78, 0.40, 0.28), 0.5 * random_unit(course, brick, 140) + 0.5 * rough)
    mortar = mix((0.62, 0.60, 0.56), (0.82, 0.80, 0.76), rough)
    return mix(mortar, clay, smooth(min(1.0, max(0.0, (to_edge - 0.06) / 0.06))))


def floor_tiles(u, v):
    """diff: 8 x 8 ceramic tiles of slightly different warm greys, thin dark joints."""
    i, j = math.floor(u * 8), math.floor(v * 8)
    to_edge = min(u * 8 % 1, 1 - u * 8 % 1, v * 8 % 1, 1 - v * 8 % 1)
    shade = 0.7 * random_unit(i, j, 200) + 0.3 * layered_noise(u, v, 32, 32, 210, 2)
    tile = mix((0.55, 0.47, 0.38), (0.90, 0.85, 0.76), shade)
    return mix((0.22, 0.20, 0.18), tile, smooth(min(1.0, to_edge / 0.05)))


def soft_blobs(u, v):
    """blur_pattern: grey, bright and dark blobs without any edge."""
    return smooth(smooth(min(1.0, max(0.0, 1.5 * layered_noise(u, v, 6, 6, 300, 2) - 0.25))))


def waves(u, v):
    """height_waves: four waves along u."""
    return 0.5 + 0.5 * math.sin(8 * math.pi * u) * math.sin(math.pi * v) ** 2


def main() -> None:
    write_png("chess_white.png", image(64, 64, checker((1, 1, 1))))
    write_png("chess_red.png", image(64, 64, checker((1, 0, 0))))
    write_png("texture1.png", image(256, 256, stone))
    write_png("relief_wood.png", image(256, 256, carved_wood))
    write_png("163.png", image(256, 256, bricks))
    write_png("diff.png", image(256, 256, floor_tiles))
    write_png("blur_pattern.png", image(352, 320, soft_blobs), grey=True)
    # What textures do beyond their edges and between their texels; rows from the top.
    four = [[(40, 70, 220), (240, 220, 80)], [(230, 60, 40), (50, 200, 60)]]
    write_png("four_colours.png", [[tuple(v / 255 for v in colour) for colour in row] for row in four])
    # A normal that leans to +u and +v.
    write_png("tilted_normal.png", [[tuple(v / 255 for v in (166, 153, 246))]])
    # Heights of a surface: an even slope that goes up 6 steps a texel along u and 4 along v, ridges along u whose flanks
    # are even where they are interpolated, and waves around a ball that end at its poles.
    ramp = [[(6 * column + 4 * row) / 255 for column in range(16)] for row in reversed(range(16))]
    write_png("height_ramp.png", ramp, grey=True)
    write_png("height_ridges.png", [[0, 1]] * 2, grey=True)
    write_png("height_waves.png", image(64, 64, waves), grey=True)
    # Shares of rays that meet a surface.
    mask = [[255, 0, 128, 64], [0, 255, 64, 0], [128, 255, 0, 255], [255, 64, 255, 0]]
    write_png("mask.png", [[v / 255 for v in row] for row in mask], grey=True)
    # Numbers and not colours: the roughness or the weight of stripes two texels wide.
    write_png("grey_steps.png", [[(v / 255,) * 3 for v in (0, 0, 51, 51, 102, 102, 204, 204)]])


if __name__ == "__main__":
    main()
