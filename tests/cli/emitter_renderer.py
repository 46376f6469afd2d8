#!/usr/bin/python3
"""A tiny renderer in another language: paints the emission that the camera sees, and nothing that is lit by it.

    emitter_renderer.py <scene.json> --output <image.exr> [--spp n --seed n --threads n]

Reads orbs-scene/1 as the harness writes it for renderers: JSON, and a binary PLY for each mesh. One ray through the
centre of each pixel; the image is exact where no edge crosses a pixel. Python's standard library alone.
"""

import json
import math
import pathlib
import struct
import sys
import time


def subtract(a, b):
    return [x - y for x, y in zip(a, b)]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def normalised(a):
    length = math.sqrt(dot(a, a))
    return [x / length for x in a]


def read_ply(file):
    """Positions, and triangles as (a, b, c, slot of the mesh's materials)."""
    data = file.read_bytes()
    header, body = data.split(b"end_header\n", 1)
    counts = [int(line.split()[2]) for line in header.decode().splitlines() if line.startswith("element")]
    vertex = struct.Struct("<11f")  # position, normal, tangent, uv
    positions = [vertex.unpack_from(body, i * vertex.size)[:3] for i in range(counts[0])]
    face = struct.Struct("<B3Ii")
    faces = [face.unpack_from(body, counts[0] * vertex.size + i * face.size)[1:] for i in range(counts[1])]
    return positions, faces


def triangles_of(scene, folder):
    """(corner, edge, edge, radiance) in the world; what does not emit is black."""
    radiance = {m["name"]: m.get("radiance", [0, 0, 0]) for m in scene["materials"]}
    meshes = {m["name"]: m for m in scene["meshes"]}
    found = []
    for instance in scene["instances"]:
        mesh = meshes[instance["mesh"]]
        m = instance["matrix"]  # row by row
        positions, faces = read_ply(folder / mesh["file"])
        world = [[dot(m[4 * r : 4 * r + 3], p) + m[4 * r + 3] for r in range(3)] for p in positions]
        for a, b, c, slot in faces:
            edges = subtract(world[b], world[a]), subtract(world[c], world[a])
            found.append((world[a], *edges, radiance[mesh["materials"][slot]]))
    return found


def distance_to(triangle, origin, direction):
    """Moeller and Trumbore 1997: along the ray, in lengths of its direction; None when it misses."""
    corner, u_edge, v_edge, _ = triangle
    p = cross(direction, v_edge)
    determinant = dot(u_edge, p)
    if determinant == 0:
        return None
    t = subtract(origin, corner)
    q = cross(t, u_edge)
    u, v = dot(t, p) / determinant, dot(direction, q) / determinant
    distance = dot(v_edge, q) / determinant
    return distance if u >= 0 and v >= 0 and u + v <= 1 and distance > 0 else None


def render(scene, folder):
    camera, triangles = scene["camera"], triangles_of(scene, folder)
    width, height = camera["width"], camera["height"]
    forward = normalised(subtract(camera["look_at"], camera["position"]))
    right = normalised(cross(forward, camera["up"]))
    up = cross(right, forward)
    half_height = math.tan(math.radians(camera["fov_y"]) / 2)
    rows = []
    for y in range(height):
        row = []
        for x in range(width):
            across = (2 * (x + 0.5) / width - 1) * half_height * width / height
            along = (1 - 2 * (y + 0.5) / height) * half_height
            direction = [f + across * r + along * u for f, r, u in zip(forward, right, up)]
            seen = [(d, t[3]) for t in triangles if (d := distance_to(t, camera["position"], direction)) is not None]
            row.append(min(seen, key=lambda hit: hit[0])[1] if seen else scene["environment"])
        rows.append(row)
    return rows


def attribute(name, kind, data):
    return name.encode() + b"\0" + kind.encode() + b"\0" + struct.pack("<i", len(data)) + data


def write_exr(rows, file):
    """OpenEXR 2, one part, uncompressed scanlines of 32-bit floats."""
    width, height = len(rows[0]), len(rows)
    channels = b"".join(n + b"\0" + struct.pack("<iB3xii", 2, 0, 1, 1) for n in (b"B", b"G", b"R")) + b"\0"
    box = struct.pack("<4i", 0, 0, width - 1, height - 1)
    header = struct.pack("<ii", 20000630, 2) + b"".join([
        attribute("channels", "chlist", channels),
        attribute("compression", "compression", b"\0"),
        attribute("dataWindow", "box2i", box),
        attribute("displayWindow", "box2i", box),
        attribute("lineOrder", "lineOrder", b"\0"),
        attribute("pixelAspectRatio", "float", struct.pack("<f", 1)),
        attribute("screenWindowCenter", "v2f", struct.pack("<2f", 0, 0)),
        attribute("screenWindowWidth", "float", struct.pack("<f", 1)),
    ]) + b"\0"  # fmt: skip
    line_bytes = 3 * 4 * width
    first = len(header) + 8 * height
    offsets = struct.pack(f"<{height}Q", *(first + y * (8 + line_bytes) for y in range(height)))
    lines = [struct.pack(f"<ii{3 * width}f", y, line_bytes, *(pixel[c] for c in (2, 1, 0) for pixel in row))
             for y, row in enumerate(rows)]  # fmt: skip
    file.write_bytes(header + offsets + b"".join(lines))


def main(arguments):
    if arguments == ["--version"]:
        print("emitter renderer 1.0")
        return
    scene_file = pathlib.Path(arguments[0])
    output = pathlib.Path(arguments[arguments.index("--output") + 1])
    began = time.perf_counter()
    rows = render(json.loads(scene_file.read_text()), scene_file.parent)
    (output.parent / "times.json").write_text(json.dumps({"render": {"milliseconds": 1000 * (time.perf_counter() - began)}}))
    write_exr(rows, output)


main(sys.argv[1:])
