"""Geometry of orbs-scene/1 as Blender meshes, for adapters/cycles.py: binary PLY files and light shapes.

Attributes are used as given. What has to be prepared for Cycles:
- front and back are decided by the winding: triangles that wind against their vertex normals are turned round;
- vertex normals become custom split normals (Blender stores them as two 16-bit angles; the error is reported by the
  tests); triangles whose vertex normals are all the face normal are marked flat, which keeps them exact;
- triangles thinner than float rounding, as at the poles of a sphere, have no usable normal and are left out.
"""

import math
import struct
from array import array
from dataclasses import dataclass, field

import bpy

# Height below this share of the longest edge: the corners coincide to float rounding, no ray can see the triangle.
DEGENERATE_HEIGHT = 1e-7
# |vertex normal - face normal| up to here is rounding of a flat triangle.
FLAT_NORMAL = 1e-6

VERTEX_PROPERTIES = [f"property float {name}" for name in "x y z nx ny nz tx ty tz u v".split()]
SECOND_UVS = ["property float u2", "property float v2"]  # of the meshes that have them
FACE_PROPERTIES = ["property list uchar uint vertex_indices", "property int material"]


@dataclass
class Triangles:
    positions: array  # flat xyz
    normals: array
    uvs: array
    second_uvs: array = None
    corners: list = field(default_factory=list)  # (a, b, c)
    materials: list = field(default_factory=list)
    smooth: list = field(default_factory=list)


def read_ply(path):
    with open(path, "rb") as file:
        data = file.read()
    end = data.find(b"end_header\n")
    lines = data[:end].decode("ascii", "replace").split("\n")
    words = [line.split() for line in lines if line.startswith("element")]
    properties = [line for line in lines if line.startswith("property")]
    if end < 0 or lines[:2] != ["ply", "format binary_little_endian 1.0"] or [w[1] for w in words] != ["vertex", "face"] \
            or properties not in (VERTEX_PROPERTIES + FACE_PROPERTIES, VERTEX_PROPERTIES + SECOND_UVS + FACE_PROPERTIES):  # fmt: skip
        raise ValueError(f"{path}: not a PLY file as lowering writes it (binary, position, normal, tangent, uv; material)")
    n_vertices, n_faces = int(words[0][2]), int(words[1][2])
    start = end + len("end_header\n")
    width = len(properties) - len(FACE_PROPERTIES)
    vertex_bytes, face = width * 4 * n_vertices, struct.Struct("<B3Ii")
    if len(data) != start + vertex_bytes + n_faces * face.size:
        raise ValueError(f"{path}: the file's length does not fit its header")
    columns = array("f")
    columns.frombytes(data[start : start + vertex_bytes])
    parts = [interleaved(columns, width, *place) for place in ((0, 3), (3, 3), (9, 2))]
    mesh = Triangles(*parts, interleaved(columns, width, 11, 2) if width > 11 else None)
    for count, a, b, c, material in face.iter_unpack(data[start + vertex_bytes :]):
        if count != 3 or max(a, b, c) >= n_vertices:
            raise ValueError(f"{path}: faces must be triangles of existing vertices")
        add_triangle(mesh, a, b, c, material)
    return mesh


def interleaved(columns, row, first, width):
    """Returns `width` neighbouring columns of the vertex table, whose rows are `row` long, as one flat array."""
    out = array("f", bytes(4 * width * (len(columns) // row)))
    for offset in range(width):
        out[offset::width] = columns[first + offset :: row]
    return out


def add_triangle(mesh, a, b, c, material):
    p, n = mesh.positions, mesh.normals
    ux, uy, uz = (p[3 * b + i] - p[3 * a + i] for i in range(3))
    vx, vy, vz = (p[3 * c + i] - p[3 * a + i] for i in range(3))
    x, y, z = uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx
    longest2 = max(ux * ux + uy * uy + uz * uz, vx * vx + vy * vy + vz * vz,
                   (ux - vx) ** 2 + (uy - vy) ** 2 + (uz - vz) ** 2)  # fmt: skip
    double_area = math.sqrt(x * x + y * y + z * z)
    if double_area <= DEGENERATE_HEIGHT * longest2:
        return
    agreement = sum(x * n[3 * i] + y * n[3 * i + 1] + z * n[3 * i + 2] for i in (a, b, c))
    if agreement < 0:
        a, b, c, x, y, z = a, c, b, -x, -y, -z
    x, y, z = x / double_area, y / double_area, z / double_area
    mesh.smooth.append(any(
        abs(n[3 * i] - x) + abs(n[3 * i + 1] - y) + abs(n[3 * i + 2] - z) > FLAT_NORMAL for i in (a, b, c)))  # fmt: skip
    mesh.corners.append((a, b, c))
    mesh.materials.append(material)


def make_mesh(name, triangles, materials):
    """Makes a Blender mesh; triangles.materials holds indices into `materials`."""
    corners = array("i", (i for corner in triangles.corners for i in corner))
    count = len(triangles.corners)
    mesh = bpy.data.meshes.new(name)
    mesh.vertices.add(len(triangles.positions) // 3)
    mesh.vertices.foreach_set("co", triangles.positions)
    mesh.loops.add(3 * count)
    mesh.loops.foreach_set("vertex_index", corners)
    mesh.polygons.add(count)
    mesh.polygons.foreach_set("loop_start", array("i", range(0, 3 * count, 3)))
    mesh.polygons.foreach_set("loop_total", array("i", [3]) * count)
    mesh.polygons.foreach_set("material_index", array("i", triangles.materials))
    mesh.polygons.foreach_set("use_smooth", array("b", triangles.smooth))
    for layer_name, uvs in (("uv", triangles.uvs), ("uv1", triangles.second_uvs)):
        if uvs is not None:
            layer = mesh.uv_layers.new(name=layer_name)
            layer.data.foreach_set("uv", array("f", (uvs[2 * i + k] for i in corners for k in (0, 1))))
    for material in materials:
        mesh.materials.append(material)
    mesh.update(calc_edges=True)
    if any(triangles.smooth):
        set_normals(mesh, triangles.normals)
    return mesh


def set_normals(mesh, normals):
    if bpy.app.version < (4, 1):  # which ignores custom normals otherwise; 4.1 has dropped the property
        mesh.use_auto_smooth = True
        mesh.auto_smooth_angle = math.pi
    mesh.normals_split_custom_set_from_vertices(list(zip(normals[0::3], normals[1::3], normals[2::3])))


# --- light shapes in their local frame; the front is where they emit ---------------------------------------------------


def flat_light(outline):
    """Returns a triangle fan of points (x, z) in the plane y = 0; it emits towards -Y."""
    positions = array("f", (value for x, z in outline for value in (x, 0.0, z)))
    normals = array("f", (0.0, -1.0, 0.0)) * len(outline)
    mesh = Triangles(positions, normals, array("f", bytes(8 * len(outline))))
    return mesh


def rect_light(half_width, half_length):
    w, l = half_width, half_length
    mesh = flat_light([(-w, -l), (w, -l), (w, l), (-w, l)])
    add_triangle(mesh, 0, 1, 2, 0)
    add_triangle(mesh, 0, 2, 3, 0)
    return mesh


def disk_light(radius, sides=256):
    """Returns a polygon of the disk's area, so that its power is right; its edge is within 1e-4 radii of the circle."""
    r = radius * math.sqrt(2 * math.pi / (sides * math.sin(2 * math.pi / sides)))
    angles = [2 * math.pi * k / sides for k in range(sides)]
    mesh = flat_light([(0.0, 0.0)] + [(r * math.cos(a), r * math.sin(a)) for a in angles])
    for k in range(sides):
        add_triangle(mesh, 0, 1 + k, 1 + (k + 1) % sides, 0)
    return mesh


def sphere_light(radius, levels=5):
    """Returns a subdivided icosahedron of the sphere's surface area. A convex body's mean shadow is a quarter of its surface
    (Cauchy), so the solid angle is kept on average; with 20 * 4^5 triangles it varies by less than 1e-4."""
    points, faces = icosahedron()
    for _ in range(levels):
        points, faces = subdivided(points, faces)
    surface = sum(triangle_area(*(points[i] for i in face)) for face in faces)
    r = radius * math.sqrt(4 * math.pi / surface)
    mesh = Triangles(array("f", (r * x for p in points for x in p)), array("f", (x for p in points for x in p)),
                     array("f", bytes(8 * len(points))))  # fmt: skip
    for face in faces:
        add_triangle(mesh, *face, 0)
    mesh.smooth = [False] * len(mesh.corners)
    return mesh


def icosahedron():
    g = (1 + math.sqrt(5)) / 2
    signs = ((1, 1), (1, -1), (-1, 1), (-1, -1))
    points = [p for s, t in signs for p in ((0, s, t * g), (s, t * g, 0), (t * g, 0, s))]
    near = 2.0 + 1e-9  # the edge length
    faces = [(a, b, c) for a in range(12) for b in range(a) for c in range(b)
             if all(math.dist(points[i], points[j]) <= near for i, j in ((a, b), (b, c), (c, a)))]  # fmt: skip
    return [normalised(p) for p in points], faces


def subdivided(points, faces):
    points, middles, out = list(points), {}, []

    def middle(a, b):
        key = (min(a, b), max(a, b))
        if key not in middles:
            middles[key] = len(points)
            points.append(normalised([x + y for x, y in zip(points[a], points[b])]))
        return middles[key]

    for a, b, c in faces:
        ab, bc, ca = middle(a, b), middle(b, c), middle(c, a)
        out += [(a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca)]
    return points, out


def normalised(v):
    length = math.sqrt(sum(x * x for x in v))
    return [x / length for x in v]


def cross_product(a, b, c):
    """Returns (b - a) x (c - a), twice the area along the normal."""
    u, v = [q - p for p, q in zip(a, b)], [q - p for p, q in zip(a, c)]
    return [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]


def triangle_area(a, b, c):
    return 0.5 * math.hypot(*cross_product(a, b, c))


def transformed(matrix, x, y, z):
    return [matrix[4 * r] * x + matrix[4 * r + 1] * y + matrix[4 * r + 2] * z + matrix[4 * r + 3] for r in range(3)]


def bounds(triangles, matrix):
    """Returns the lowest and the highest corner of the box around the transformed vertices."""
    p = triangles.positions
    points = [transformed(matrix, *point) for point in zip(p[0::3], p[1::3], p[2::3])]
    return [min(column) for column in zip(*points)], [max(column) for column in zip(*points)]


def bounds_of_box(box, matrix):
    """Returns the lowest and the highest corner of the box around a transformed box."""
    points = [transformed(matrix, x[0], y[1], z[2]) for x in box for y in box for z in box]
    return [min(column) for column in zip(*points)], [max(column) for column in zip(*points)]


def is_closed(triangles):
    """Tests the vector area, which is zero for a closed surface and not for a sheet of water."""
    p, vector, total = triangles.positions, [0.0, 0.0, 0.0], 0.0
    for corner in triangles.corners:
        cross = cross_product(*(p[3 * i : 3 * i + 3] for i in corner))
        vector = [s + x for s, x in zip(vector, cross)]
        total += math.hypot(*cross)
    return math.hypot(*vector) <= 1e-4 * total


def largest_triangle_area(triangles, matrix, slots=None):
    """Returns the largest triangle's area after the affine matrix (16 numbers); `slots`: only these material slots."""
    p, largest = triangles.positions, 0.0
    for corner, slot in zip(triangles.corners, triangles.materials):
        if slots is None or slot in slots:
            largest = max(largest, triangle_area(*(transformed(matrix, *p[3 * i : 3 * i + 3]) for i in corner)))
    return largest
