#!/usr/bin/python3
"""A converter: renders a scene of orbs with the path tracer of Debian's embree-tools.

    embree_pathtracer.py <scene.json> <image.exr> --program <pathtracer> --spp n --threads n

It writes what the program reads (XML, and the arrays in a file beside it), runs it, and makes an EXR of its images.
Four properties of the program, version 3.13.5, decide how; its source says them, in tutorials/pathtracer:

- It counts the sky twice on diffuse surfaces: by a shadow ray, and where the reflected ray meets nothing. A black
  sphere around everything ends the reflected rays. Shadow rays do not see spheres.
- Then the sky itself is not seen either. It comes from a second image, in which all surfaces are black.
- Its images have 8 bits. So they are rendered with a sky of several brightnesses. As the random numbers are the same in
  all of them, each says between which bounds the one value of a pixel lies; together they know it to 0.02 % on average.
- It has no seed: every render draws the same random numbers. "fixed_samples" in its entry says that to orbs, which then
  judges one image and does not take further ones for further samples. How noisy that is, the first half of its
  samples says: the square of what the second half changes is the variance.

What it does not know it refuses: it ends with status 1 and says why.
"""

import argparse
import json
import math
import pathlib
import struct
import subprocess
import sys

import numpy

CLIPPED = 250  # of 255
# From half to four times the brightness; steps of the golden ratio fill the range evenly.
BRIGHTNESSES = [2 ** (3 * (step * 0.618034 % 1) - 1) for step in range(24)]
UNLIMITED_DEPTH = 1000


def refuse(why):
    sys.exit(f"embree_pathtracer: {why}")


def only(entry, what, known):
    """Refuses keys that nobody here reads: what is skipped makes a wrong image that looks right."""
    for key in entry.keys() - known:
        refuse(f"{what} has '{key}', which is not known here")


def read_ply(file):
    """Positions, normals, corners of the triangles and the material of each, as orbs writes them."""
    header, body = file.read_bytes().split(b"end_header\n", 1)
    counts = [int(line.split()[2]) for line in header.decode().splitlines() if line.startswith("element")]
    vertex = numpy.dtype([("position", "<3f4"), ("normal", "<3f4"), ("tangent", "<3f4"), ("uv", "<2f4")])
    face = numpy.dtype([("count", "u1"), ("corners", "<3u4"), ("material", "<i4")])
    vertices = numpy.frombuffer(body, vertex, counts[0])
    faces = numpy.frombuffer(body, face, counts[1], counts[0] * vertex.itemsize)
    return vertices["position"], vertices["normal"], faces["corners"], faces["material"]


def read_meshes(scene, folder):
    """For each instance and each of its materials: name of the material, positions, normals, corners in the world."""
    files = {mesh["name"]: mesh for mesh in scene["meshes"]}
    for instance in scene["instances"]:
        only(instance, "an instance", {"name", "mesh", "matrix"})
        mesh = files[instance["mesh"]]
        only(mesh, "a mesh", {"name", "file", "materials"})
        positions, normals, corners, slots = read_ply(folder / mesh["file"])
        matrix = numpy.array(instance["matrix"]).reshape(4, 4)
        linear = matrix[:3, :3]
        positions = positions @ linear.T + matrix[:3, 3]
        normals = normals @ numpy.linalg.inv(linear)  # by the inverse transpose
        for slot, name in enumerate(mesh["materials"]):
            if (slots == slot).any():
                yield name, positions, normals, corners[slots == slot]


class SceneFile:
    """Embree's XML, and the arrays in a file beside it."""

    def __init__(self):
        self.lines, self.arrays, self.size = [], [], 0

    def array(self, tag, rows, kind):
        data = numpy.ascontiguousarray(rows, kind).tobytes()
        self.lines.append(f'<{tag} ofs="{self.size}" size="{len(rows)}"/>')
        self.arrays.append(data)
        self.size += len(data)

    def material(self, code, colour):
        numbers = " ".join(repr(float(c)) for c in colour)
        self.lines.append(f'<material><code>"{code}"</code><parameters><float3 name="reflectance">{numbers}</float3>'
                          "</parameters></material>")  # fmt: skip

    def mesh(self, code, colour, positions, normals, corners):
        self.lines.append("<TriangleMesh>")
        self.array("positions", positions, "<f4")
        self.array("normals", normals, "<f4")
        self.array("triangles", corners, "<i4")
        self.material(code, colour)
        self.lines.append("</TriangleMesh>")

    def black_sphere(self, radius):
        self.lines.append(f'<Points type="sphere"><positions>0 0 0 {radius!r}</positions>')
        self.material("Matte", (0, 0, 0))
        self.lines.append("</Points>")

    def write(self, file, sky):
        light = f"<AmbientLight><L>{' '.join(repr(float(c)) for c in sky)}</L></AmbientLight>"
        file.write_text("\n".join(['<?xml version="1.0"?>', "<scene>", *self.lines, light, "</scene>", ""]))
        file.with_suffix(".bin").write_bytes(b"".join(self.arrays))


def models_of(scene):
    """Code and colour of each material, and whether the scene is one of mirrors."""
    models = {}
    for material in scene["materials"]:
        only(material, "a material", {"name", "type", "reflectance"})
        code = {"lambert": "Matte", "mirror": "Mirror"}.get(material["type"])
        if code is None:
            refuse(f"a material of the type {material['type']} is not known here")
        models[material["name"]] = code, material["reflectance"]
    return models


def farthest(meshes, camera):
    places = [numpy.abs(positions).max() for _, positions, _, _ in meshes]
    return float(max([1.0, *places, *map(abs, camera["position"])]))


class Program:
    """Runs the path tracer on a scene file with several skies, and makes one linear image of its images."""

    def __init__(self, options, camera, folder):
        self.options, self.camera, self.folder = options, camera, folder

    def linear(self, written, sky, path_length, spp):
        """The image under a sky of this radiance."""
        darkest = 1.0
        while (self.render(written, numpy.multiply(sky, darkest), path_length, spp) >= CLIPPED).any():
            darkest /= 2
        low, high = 0.0, math.inf
        for brightness in (darkest * step for step in BRIGHTNESSES):
            steps = self.render(written, numpy.multiply(sky, brightness), path_length, spp)
            low = numpy.maximum(low, steps / brightness)
            high = numpy.minimum(high, numpy.where(steps < CLIPPED, (steps + 1) / brightness, math.inf))
        return numpy.where(low > 0, (low + high) / 2, 0) / 255.01  # which it multiplies by, before it cuts

    def render(self, written, sky, path_length, spp):
        """The image as whole numbers up to 255."""
        scene_file, image_file = self.folder / "embree.xml", self.folder / "embree.pfm"
        written.write(scene_file, sky)
        camera, options = self.camera, self.options
        command = [options.program, "-i", scene_file, "-o", image_file, "--righthanded",
                   "--size", camera["width"], camera["height"], "--fov", camera["fov_y"],
                   "--vp", *camera["position"], "--vi", *camera["look_at"], "--vu", *camera["up"],
                   "--spp", spp, "--max-path-length", path_length, "--threads", options.threads]  # fmt: skip
        subprocess.run([str(word) for word in command], check=True, stdout=subprocess.DEVNULL)
        header, body = image_file.read_bytes().split(b"-1\n", 1)
        if not header.startswith(b"PF"):
            refuse(f"{image_file.name} is no PFM file")
        rows = numpy.frombuffer(body, "<f4").reshape(camera["height"], camera["width"], 3)[::-1]  # from the bottom
        return numpy.rint(rows * 255).astype(int)


def renderer_of(scene, folder, options):
    """A function that makes the image of so many samples."""
    models, meshes = models_of(scene), list(read_meshes(scene, folder))
    used = {models[name][0] for name, *_ in meshes}
    if len(used) > 1:
        refuse("of surfaces that are diffuse and mirrors side by side, it counts the sky once and twice")
    depth = scene["integrator"]["trace_depth"]
    depth = UNLIMITED_DEPTH if depth == "unlimited" else depth
    lit, black = SceneFile(), SceneFile()
    for name, *mesh in meshes:
        lit.mesh(*models[name], *mesh)
        black.mesh("Matte", (0, 0, 0), *mesh)
    program, sky = Program(options, scene["camera"], folder), scene["environment"]
    if used == {"Mirror"}:  # nothing sends shadow rays, and what leaves the scene sees the sky
        return lambda spp: program.linear(lit, sky, depth + 1, spp)
    if not meshes:
        return lambda spp: program.linear(black, sky, 1, spp)
    lit.black_sphere(100 * farthest(meshes, scene["camera"]))
    return lambda spp: program.linear(lit, sky, depth, spp) + program.linear(black, sky, 1, spp)


def attribute(name, kind, data):
    return name.encode() + b"\0" + kind.encode() + b"\0" + struct.pack("<i", len(data)) + data


def write_exr(image, variance, file):
    """OpenEXR 2, one part, uncompressed scanlines of 32-bit floats."""
    height, width = image.shape[:2]
    names = [b"B", b"G", b"R", b"variance.B", b"variance.G", b"variance.R"]  # in their order
    channels = b"".join(n + b"\0" + struct.pack("<iB3xii", 2, 0, 1, 1) for n in names) + b"\0"
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
    line_bytes = len(names) * 4 * width
    first = len(header) + 8 * height
    offsets = struct.pack(f"<{height}Q", *(first + y * (8 + line_bytes) for y in range(height)))
    values = numpy.concatenate([image[:, :, ::-1], variance[:, :, ::-1]], axis=2)
    planes = numpy.ascontiguousarray(values.transpose(0, 2, 1), "<f4")
    lines = [struct.pack("<ii", y, line_bytes) + planes[y].tobytes() for y in range(height)]
    file.write_bytes(header + offsets + b"".join(lines))


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("scene", type=pathlib.Path)
    parser.add_argument("output", type=pathlib.Path)
    parser.add_argument("--program", required=True)
    parser.add_argument("--spp", type=int, required=True)
    parser.add_argument("--threads", type=int, required=True)
    options = parser.parse_args()
    scene = json.loads(options.scene.read_text())
    only(scene, "the scene", {"format", "name", "camera", "environment", "textures", "materials", "meshes", "instances",
                              "lights", "integrator"})  # fmt: skip
    only(scene["camera"], "the camera",
         {"position", "look_at", "up", "fov_y", "width", "height", "near", "far", "focus_distance"})  # fmt: skip
    only(scene["integrator"], "the integrator", {"type", "trace_depth"})
    if scene["integrator"].get("type", "path") != "path" or scene["lights"]:
        refuse("it has path tracing without lamps alone")
    image_of = renderer_of(scene, options.scene.parent, options)
    image, half = image_of(options.spp), image_of(max(1, options.spp // 2))
    rounding = 0.0002 * image  # what the bounds leave
    write_exr(image, (image - half) ** 2 + rounding**2, options.output)


main()
