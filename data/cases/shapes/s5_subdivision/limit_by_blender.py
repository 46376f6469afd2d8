"""Writes each subdivision surface of a scene as a PLY file of limit points by OpenSubdiv, the library within Blender:

    blender -b --factory-startup -noaudio --python-exit-code 3 --python limit_by_blender.py -- scene.json folder level [mesh ...]

Without names: all meshes that have one. The files of s5_subdivision were made by Blender 3.4.1 at level 4, screw.ply of
s6_displacement at level 6 and the others there at level 5. A displaced surface is moved by its formula along normals that are sums
of those of faces, weighted by their angles, of a surface two levels finer. Nothing of orbs takes part.
"""

import json
import math
import os
import re
import struct
import sys

import bmesh
import bpy

FUNCTIONS = {name: getattr(math, name) for name in ("sin", "cos", "exp", "log", "sqrt", "pow", "pi")}
FUNCTIONS |= {"abs": abs, "min": min, "max": max}


def crease_of(sharpness):
    """Blender stores sqrt(sharpness / 10), and takes 10 for infinite."""
    return 1.0 if sharpness is None else math.sqrt(sharpness / 10)


def cage_of(subdivision):
    mesh = bmesh.new()
    edge_creases, vertex_creases = mesh.edges.layers.crease.verify(), mesh.verts.layers.crease.verify()
    points = subdivision["points"]
    vertices = [mesh.verts.new(points[i : i + 3]) for i in range(0, len(points), 3)]
    corners = iter(subdivision["faces"])
    for size in subdivision.get("face_sizes") or [4] * (len(subdivision["faces"]) // 4):
        mesh.faces.new([vertices[next(corners)] for _ in range(size)])
    mesh.verts.index_update()
    for crease in subdivision.get("creases", []):
        for a, b in zip(crease["points"], crease["points"][1:]):
            mesh.edges.get((vertices[a], vertices[b]))[edge_creases] = crease_of(crease.get("sharpness"))
    for corner in subdivision.get("corners", []):
        for point in corner["points"]:
            vertices[point][vertex_creases] = crease_of(corner.get("sharpness"))
    return mesh


def limit_of(subdivision, level):
    """Points and faces of the limit surface."""
    data = bpy.data.meshes.new("cage")
    cage_of(subdivision).to_mesh(data)
    item = bpy.data.objects.new("cage", data)
    bpy.context.scene.collection.objects.link(item)
    modifier = item.modifiers.new("surface", "SUBSURF")
    modifier.levels = modifier.render_levels = level
    modifier.use_limit_surface, modifier.use_creases, modifier.quality = True, True, 10
    modifier.boundary_smooth = "ALL"
    surface = item.evaluated_get(bpy.context.evaluated_depsgraph_get()).to_mesh()
    points = [tuple(v.co) for v in surface.vertices]
    return points, [tuple(p.vertices) for p in surface.polygons]


def minus(a, b):
    return a[0] - b[0], a[1] - b[1], a[2] - b[2]


def unit(a):
    size = math.sqrt(sum(x * x for x in a))
    return tuple(x / size for x in a)


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]


def normals_of(points, faces):
    sums = [(0.0, 0.0, 0.0)] * len(points)
    for face in faces:
        for i, corner in enumerate(face):
            before = unit(minus(points[face[i - 1]], points[corner]))
            after = unit(minus(points[face[(i + 1) % len(face)]], points[corner]))
            angle = math.acos(max(-1.0, min(1.0, dot(before, after))))
            sums[corner] = tuple(s + angle * n for s, n in zip(sums[corner], unit(cross(after, before))))
    return [unit(s) for s in sums]


def displaced(points, subdivision, level):
    formula = compile(re.sub(r"\^", "**", subdivision["displacement"]["expression"]), "formula", "eval")
    fine, faces = limit_of(subdivision, level + 2)
    normal_at = {tuple(round(x, 5) for x in p): n for p, n in zip(fine, normals_of(fine, faces))}
    moved = []
    for p in points:
        near = (tuple(round(x + d, 5) for x, d in zip(p, (dx, dy, dz)))
                for dx in (0, 1e-5, -1e-5) for dy in (0, 1e-5, -1e-5) for dz in (0, 1e-5, -1e-5))  # fmt: skip
        normal = next(normal_at[key] for key in near if key in normal_at)
        height = eval(formula, {"__builtins__": {}}, FUNCTIONS | dict(zip("xyz", p)))
        moved.append(tuple(x + height * n for x, n in zip(p, normal)))
    return moved


def write_ply(path, points, faces):
    with open(path, "wb") as file:
        file.write(f"""ply
format binary_little_endian 1.0
element vertex {len(points)}
property float x
property float y
property float z
element face {len(faces)}
property list uchar ushort vertex_indices
end_header
""".encode())
        for p in points:
            file.write(struct.pack("<3f", *p))
        for face in faces:
            file.write(struct.pack(f"<B{len(face)}H", len(face), *face))


def main():
    scene_file, folder, level, *chosen = sys.argv[sys.argv.index("--") + 1 :]
    with open(scene_file, encoding="utf-8") as file:
        scene = json.load(file)
    for mesh in scene["meshes"]:
        if "subdivision" in mesh and (not chosen or mesh["name"] in chosen):
            points, faces = limit_of(mesh["subdivision"], int(level))
            if "displacement" in mesh["subdivision"]:
                points = displaced(points, mesh["subdivision"], int(level))
            write_ply(os.path.join(folder, mesh["name"] + ".ply"), points, faces)


if __name__ == "__main__":
    main()
