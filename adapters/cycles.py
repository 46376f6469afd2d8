"""Renders a lowered orbs-scene/1 file with Cycles; runs inside Blender 3.4:

    blender -b --factory-startup -noaudio --python-exit-code 3 --python adapters/cycles.py -- \\
        --scene lowered.json --output out.exr --spp N --seed S --threads T [--scale auto|number] [--device CPU|CUDA|...]

Ends with status 2 and one line on stderr when the scene holds anything unknown; the output appears only when complete.
Prints `orbs: render_seconds <s>`, the time of the render call alone.

--scale: the whole world is scaled, which no radiance depends on, except that Cycles 3.4 chooses between area and
solid-angle sampling of an emitting triangle by comparing its longest edge with its distance divided by the *doubled area*
(kernel/light/light.h: dot(N, v) / dot(N, N)), which is not a length. Large triangles are therefore sampled by solid angle
even from afar, and that solid angle is a sum of three fast_acosf with 4.5e-5 rad error each: a light of 0.01 sr is then
about 1 % too dark. `auto` shrinks the world until the largest emitting triangle has a doubled area of 0.1: from farther
than 0.1 edges it is then sampled by area, which is exact. The scale stays above 0.01 (Cycles' ray offsets are absolute
near the origin): lights that would need less are so large that 1e-4 sr do not matter. A world whose objects are
kilometres or fractions of a millimetre in size is first brought to about a metre, by a power of two, which rounds nothing.
"""

import json
import math
import os
import sys
from array import array

import bpy
from mathutils import Matrix, Vector

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import cycles_devices  # noqa: E402
import cycles_environment  # noqa: E402
import cycles_ies  # noqa: E402
import cycles_layers  # noqa: E402
import cycles_lights  # noqa: E402
import cycles_materials  # noqa: E402
import cycles_meshes  # noqa: E402
import cycles_render  # noqa: E402

IDENTITY = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]
LARGEST_DOUBLED_EMITTER_AREA = 0.1
SMALLEST_SCALE = 0.01
FRAME = 1  # the one that is rendered
LIGHT_SHAPES = {
    "rect": (("half_width", "half_length"), cycles_meshes.rect_light),
    "disk": (("radius",), cycles_meshes.disk_light),
    "sphere": (("radius",), cycles_meshes.sphere_light),
}


# What a light without an area emits, and its numbers.
POINT_LIGHTS = {"point": ("intensity", ()), "spot": ("intensity", ("inner", "outer")), "directional": ("irradiance", ())}


class SceneError(ValueError):
    """The scene holds something that this adapter does not know."""


def main():
    arguments = parse_arguments()
    try:
        with open(arguments.scene, encoding="utf-8") as file:
            scene = json.load(file)
        cycles_devices.choose_device(arguments.device)
        scale = build(scene, os.path.dirname(os.path.abspath(arguments.scene)), arguments.scale)
        integrator = checked(scene.get("integrator", {}), "integrator", [], ["trace_depth"])
        cycles_render.set_integrator(integrator.get("trace_depth", 5), arguments)
        cycles_render.render(os.path.abspath(arguments.output), cycles_layers.prepared_layers(scene, scale))
    except (OSError, ValueError, KeyError, TypeError, RuntimeError) as error:
        print(f"cycles.py: error: {arguments.scene}: {' '.join(str(error).split())}", file=sys.stderr, flush=True)
        sys.exit(2)


def parse_arguments():
    parser = cycles_render.argument_parser("cycles.py")
    parser.add_argument("--scale", default="auto")
    parser.add_argument("--device", choices=cycles_devices.KINDS, default="CPU")
    return cycles_render.parse_arguments(parser)


def checked(entry, place, required, optional=()):
    """Returns the entry; refuses missing and unknown keys, so that no setting is silently ignored."""
    if not isinstance(entry, dict):
        raise SceneError(f"{place} must be an object")
    for key in required:
        if key not in entry:
            raise SceneError(f"{place} lacks '{key}'")
    for key in entry:
        if key not in required and key not in optional:
            raise SceneError(f"{place} has the unknown key '{key}'")
    return entry


def named(table, name, place):
    if name not in table:
        raise SceneError(f"{place} names '{name}', which does not exist")
    return table[name]


# --- the scene ----------------------------------------------------------------------------------------------------------


def build(scene, folder, scale_option):
    checked(scene, "scene", ["format", "name", "camera"],
            ["environment", "textures", "materials", "meshes", "instances", "lights", "integrator",
             "outputs"])  # fmt: skip  # Of "outputs" the layers of surfaces are written; others are ignored.
    if scene["format"] != "orbs-scene/1":
        raise SceneError(f"format must be orbs-scene/1, is {scene['format']}")
    bpy.ops.wm.read_factory_settings(use_empty=True)
    descriptions = {m["name"]: checked_material(m) for m in scene.get("materials", [])}
    meshes = {m["name"]: read_mesh(m, folder) for m in scene.get("meshes", [])}
    instances = [checked_instance(i, meshes, descriptions) for i in scene.get("instances", [])]
    shutter = checked_shutter(scene["camera"])
    ends = {m["name"]: read_end(m, meshes[m["name"]][0], folder) for m in scene.get("meshes", []) if "end" in m}
    moved = [moved_positions(i, meshes, ends) for i in scene.get("instances", [])] if shutter else [None] * len(instances)
    lights, points = [], []
    for index, entry in enumerate(scene.get("lights", [])):
        if entry.get("type") in POINT_LIGHTS:
            points.append(checked_point_light(entry, index))
        else:
            lights.append(checked_light(entry, index))
    boxes = boxes_in_place(meshes, instances, lights)
    scale = chosen_scale(scale_option, descriptions, meshes, instances, lights, boxes)
    print(f"orbs: scale {scale:.9g}", flush=True)
    scales_radiance = may_start_in_glass(scene["camera"], descriptions, meshes, instances, lights)
    textures = {t["name"]: load_texture(t) for t in scene.get("textures", [])}
    around = cycles_materials.Surroundings(textures, scales_radiance, descriptions, scale)
    materials = {name: make_material(m, around) for name, m in descriptions.items()}
    add_camera(scene["camera"], scale, farthest_distance(scene["camera"]["position"], boxes))
    cycles_environment.add_environment(checked_environment(scene.get("environment", [0, 0, 0])), textures)
    add_instances(meshes, instances, materials, scale, moved, shutter)
    for index, light in enumerate(lights):
        add_light(light, f"light {index}", folder, scale)
    for index, (light, matrix) in enumerate(points):
        ies = load_ies(light["ies"], matrix, folder, scale) if "ies" in light else None
        cycles_lights.add_light(light, f"point light {index}", world_matrix(matrix, scale), scale, ies)
    # Cycles' roulette would act on the factor 1 / ior^2 that a path carries in glass, which only adds noise.
    bpy.context.scene.cycles.min_light_bounces = 1024 if scales_radiance else 0
    return scale


def checked_material(material):
    place = f"material '{material.get('name')}'"
    if material.get("type") not in cycles_materials.MATERIAL_TYPES:
        raise SceneError(f"{place}: Cycles has no {material.get('type')}")
    required, optional, _ = cycles_materials.MATERIAL_TYPES[material["type"]]
    material = dict(checked(material, place, {"name", "type"} | required, optional | cycles_materials.DETAIL_KEYS))
    for key in ("texture", "opacity_texture"):
        if key in material:
            material[key] = checked_use(material[key], f"{place}: {key}")
    for key, number in (("normal_map", "strength"), ("bump_map", "height")):
        if key in material:
            given = checked(material[key], f"{place}: {key}", ["texture"], [number])
            material[key] = {**given, "texture": checked_use(given["texture"], f"{place}: {key}")}
    return material


def checked_use(given, place):
    use = {"name": given} if isinstance(given, str) else given
    checked(use, place, ["name"], ["matrix", "uv_set"])
    return {"matrix": IDENTITY, "uv_set": 0, **use}


def checked_environment(environment):
    if isinstance(environment, list):
        return {"radiance": environment}
    return checked(environment, "environment", ["radiance"], ["map", "matrix", "visible_to_camera"])


def load_texture(texture):
    place = f"texture '{texture.get('name')}'"
    checked(texture, place, ["name", "file"], ["wrap_u", "wrap_v", "filter", "encoding"])
    wraps = texture.get("wrap_u", "repeat"), texture.get("wrap_v", "repeat")
    if not set(wraps) <= {"repeat", "clamp", "mirror"}:
        raise SceneError(f"{place}: wrap must be repeat, clamp or mirror")
    image = cycles_materials.load_texture(texture["file"], texture.get("encoding", "srgb"))
    return cycles_materials.Texture(image, wraps, texture.get("filter", "linear"))


def make_material(description, around):
    if "texture" in description:
        named(around.textures, description["texture"]["name"], f"material '{description['name']}'")
    return cycles_materials.make_material(description, around)


def read_triangles(entry, place, folder):
    if not entry["file"].endswith(".ply"):
        raise SceneError(f"{place}: only lowered meshes (binary PLY) can be read, found {entry['file']}")
    return cycles_meshes.read_ply(os.path.join(folder, entry["file"]))


def read_end(mesh, start, folder):
    """Returns where the vertices are at the end of the frame. The normals of flat triangles follow from them; those of
    smooth ones are carried along by Blender, which has none of its own for the end."""
    place = f"mesh '{mesh['name']}': end"
    end = read_triangles(checked(mesh["end"], place, ["file"]), place, folder)
    if len(end.positions) != len(start.positions):
        raise SceneError(f"{place} has another number of vertices than the start")
    if any(start.smooth):
        raise SceneError(f"{place}: smooth normals at two times cannot be handed to Blender")
    return end.positions


def checked_shutter(camera):
    """Returns the times at which the shutter opens and closes, in frames; None where the scene is at rest."""
    shutter = camera.get("shutter")
    if shutter is None:
        return None
    if len(shutter) != 2 or not 0 <= shutter[0] < shutter[1] <= 1:
        raise SceneError(f"camera: shutter must be two ascending times in [0, 1], is {shutter}")
    return shutter


def moved_positions(instance, meshes, ends):
    """Returns the vertices at the end of the frame, in the space of the instance at its start; None for one at rest.
    Matrices are linear in time, so each vertex moves on a straight line, as a shape key moves it."""
    end_matrix, mesh = instance.get("end_matrix"), instance["mesh"]
    if end_matrix is None:
        return ends.get(mesh)
    if mesh in ends:
        raise SceneError(f"instance '{instance.get('name')}' moves, and its mesh changes its shape: both at once are not "
                         "linear in time, as shape keys are")  # fmt: skip
    place = f"instance '{instance.get('name')}'"
    to_end = world_matrix(checked_matrix(instance, place), 1.0).inverted() @ world_matrix(
        checked_matrix({"matrix": end_matrix}, place), 1.0)
    p = meshes[mesh][0].positions
    return array("f", (x for i in range(0, len(p), 3) for x in to_end @ Vector(p[i : i + 3])))


def read_mesh(mesh, folder):
    place = f"mesh '{mesh.get('name')}'"
    checked(mesh, place, ["name", "file", "materials"], ["end"])
    triangles = read_triangles(mesh, place, folder)
    if any(not 0 <= slot < len(mesh["materials"]) for slot in triangles.materials):
        raise SceneError(f"{place}: a face names a material outside the mesh's list")
    return triangles, mesh["materials"]


def checked_instance(instance, meshes, materials):
    """Returns name, mesh name, matrix, and the material name of each slot after the remap list."""
    place = f"instance '{instance.get('name')}'"
    checked(instance, place, ["mesh"], ["name", "matrix", "end_matrix", "remap"])
    remap = instance.get("remap", [])
    if len(remap) % 2:
        raise SceneError(f"{place}: remap must hold pairs")
    replacement = {}
    for old, new in zip(remap[0::2], remap[1::2]):
        replacement.setdefault(old, new)  # The first pair counts, and results are not remapped again.
    slots = [replacement.get(name, name) for name in named(meshes, instance["mesh"], place)[1]]
    for name in slots:
        named(materials, name, place)
    return instance.get("name", instance["mesh"]), instance["mesh"], checked_matrix(instance, place), slots


def checked_matrix(entry, place):
    matrix = entry.get("matrix", IDENTITY)
    if len(matrix) != 16 or not all(isinstance(x, (int, float)) and math.isfinite(x) for x in matrix):
        raise SceneError(f"{place}: matrix must be 16 finite numbers (a lowered scene)")
    return matrix


def checked_light(light, index):
    place = f"light '{light.get('name', index)}'"
    if light.get("type") not in LIGHT_SHAPES:
        raise SceneError(f"{place} has the unknown type '{light.get('type')}'")
    sizes, make_shape = LIGHT_SHAPES[light["type"]]
    checked(light, place, ["type", "radiance", *sizes], ["name", "matrix", "ies"])
    if "ies" in light:
        checked(light["ies"], f"{place}: ies", ["file"], ["matrix", "point_area"])
        checked_matrix(light["ies"], f"{place}: ies")
    return light, make_shape(*(light[size] for size in sizes)), checked_matrix(light, place)


def checked_point_light(light, index):
    place = f"light '{light.get('name', index)}'"
    emission, numbers = POINT_LIGHTS[light["type"]]
    checked(light, place, ["type", emission, *numbers], ["name", "matrix"] + (["ies"] if light["type"] == "point" else []))
    if "ies" in light:
        checked(light["ies"], f"{place}: ies", ["file"], ["matrix", "point_area"])
        checked_matrix(light["ies"], f"{place}: ies")
    return light, checked_matrix(light, place)


def chosen_scale(option, descriptions, meshes, instances, lights, boxes):
    if option != "auto":
        scale = float(option)
        if not (math.isfinite(scale) and scale > 0):
            raise SceneError(f"--scale must be auto or above 0, is {option}")
        return scale
    metre = usual_size(boxes)
    largest = max((cycles_meshes.largest_triangle_area(shape, matrix) for _, shape, matrix in lights), default=0.0)
    for _, mesh, matrix, slots in instances:
        emitting = {i for i, name in enumerate(slots) if descriptions[name]["type"] == "emission"}
        if emitting:
            largest = max(largest, cycles_meshes.largest_triangle_area(meshes[mesh][0], matrix, emitting))
    largest /= metre * metre
    if largest == 0:
        return 1.0 / metre
    return min(1.0, max(SMALLEST_SCALE, math.sqrt(LARGEST_DOUBLED_EMITTER_AREA / (2 * largest)))) / metre


def usual_size(boxes):
    """Returns the power of two next below the size of the object in the middle of all objects by size, so that neither a
    vast ground nor a small lamp decides; 1 where that is from 1/256 m to 256 m, where Cycles needs no help."""
    sizes = sorted(math.dist(*cycles_meshes.bounds_of_box(box, matrix)) for box, matrix in boxes)
    middle = sizes[(len(sizes) - 1) // 2] if sizes else 1.0
    return 1.0 if middle == 0 or 2**-8 <= middle <= 2**8 else 2.0 ** math.floor(math.log2(middle))


def may_start_in_glass(camera, descriptions, meshes, instances, lights):
    """Whether the camera or an emitter may lie within glass. Only then do the factors ior^2 and 1 / ior^2 along a path not
    cancel. Errs on the side of yes: by bounding boxes, and always for glass that is an open sheet."""
    boxes, glass = [(camera["position"], camera["position"])], []
    boxes += [cycles_meshes.bounds(shape, matrix) for _, shape, matrix in lights]
    for _, mesh, matrix, slots in instances:
        types = {descriptions[slots[slot]]["type"] for slot in set(meshes[mesh][0].materials)}
        if "emission" in types:
            boxes.append(cycles_meshes.bounds(meshes[mesh][0], matrix))
        if types & {"glass", "rough_glass"}:
            if not cycles_meshes.is_closed(meshes[mesh][0]):
                return True
            glass.append(cycles_meshes.bounds(meshes[mesh][0], matrix))
    return any(all(a[0][k] <= b[1][k] and b[0][k] <= a[1][k] for k in range(3)) for a in boxes for b in glass)


def world_matrix(numbers, scale):
    rows = [numbers[4 * r : 4 * r + 4] for r in range(4)]
    return Matrix.Scale(scale, 4) @ Matrix(rows)


def farthest_distance(position, boxes):
    """An upper bound of the distance in metres from the camera to what is drawn; 0 if nothing is."""
    corners = [Matrix((matrix[0:4], matrix[4:8], matrix[8:12], matrix[12:16])) @ Vector((x[0], y[1], z[2]))
               for (low, high), matrix in boxes for x in (low, high) for y in (low, high) for z in (low, high)]  # fmt: skip
    return max(((corner - Vector(position)).length for corner in corners), default=0.0)


def boxes_in_place(meshes, instances, lights):
    """Returns the box of each instance and light in its own space, and its matrix."""
    boxes = {mesh: cycles_meshes.bounds(meshes[mesh][0], IDENTITY) for mesh in {mesh for _, mesh, _, _ in instances}}
    placed = [(boxes[mesh], matrix) for _, mesh, matrix, _ in instances]
    return placed + [(cycles_meshes.bounds(shape, IDENTITY), matrix) for _, shape, matrix in lights]


def clip_distances(scale, farthest):
    """near and far do not clip in orbs-scene/1, but Blender's cameras must. What they keep grows and shrinks with the scene,
    down to 1e-6, the least that Blender stores."""
    start, end = 1e-4 * scale, 1e6
    if farthest > 0:
        start, end = min(start, 1e-4 * scale * farthest), max(end, 2 * scale * farthest)
    return max(start, 1e-6), end


def add_camera(camera, scale, farthest):
    checked(camera, "camera", ["position", "look_at"],
            ["up", "fov_y", "width", "height", "near", "far", "focus_distance", "shutter", "end",
             "projection", "view_height", "shift", "aperture_radius"])  # fmt: skip
    position = Vector(camera["position"])
    back = (position - Vector(camera["look_at"])).normalized()  # Blender cameras look along local -Z, up is +Y
    right = Vector(camera.get("up", (0, 1, 0))).cross(back).normalized()
    if back.length == 0 or right.length == 0:
        raise SceneError("camera: position, look_at and up give no direction")
    data = bpy.data.cameras.new("camera")
    data.sensor_fit = "VERTICAL"
    set_projection(data, camera, scale)
    data.clip_start, data.clip_end = clip_distances(scale, farthest)
    item = add_object("camera", data)
    axes = Matrix((right, back.cross(right), back)).transposed().to_4x4()
    item.matrix_world = Matrix.Translation(scale * position) @ axes
    scene = bpy.context.scene
    scene.camera = item
    if "end" in camera:
        slide_camera(item, scale * camera_way(camera), checked_shutter(camera))
    scene.render.resolution_x, scene.render.resolution_y = camera.get("width", 1024), camera.get("height", 1024)


def set_projection(data, camera, scale):
    """Widths and heights are Blender's with sensor_fit VERTICAL: its shifts are in heights of the image."""
    kind = camera.get("projection", "perspective")
    if kind == "orthographic":
        data.type, data.ortho_scale = "ORTHO", scale * camera["view_height"]
    elif kind == "latitude_longitude":
        data.type, data.cycles.panorama_type = "PANO", "EQUIRECTANGULAR"
        data.cycles.longitude_min, data.cycles.longitude_max = -math.pi, math.pi
        data.cycles.latitude_min, data.cycles.latitude_max = -math.pi / 2, math.pi / 2
    elif kind == "perspective":
        data.angle_y = math.radians(camera.get("fov_y", 90.0))
        shift = camera.get("shift", (0, 0))
        data.shift_x, data.shift_y = shift[0] * camera.get("width", 1024) / camera.get("height", 1024), shift[1]
        add_lens(data, camera, scale)
    else:
        raise SceneError(f"camera: unknown projection '{kind}'")


def add_lens(data, camera, scale):
    radius = camera.get("aperture_radius", 0)
    if radius == 0:
        return
    data.dof.use_dof, data.dof.aperture_blades = True, 0
    data.dof.focus_distance = scale * camera["focus_distance"]
    # The f-number is the focal length, in millimetres, over the diameter; Blender takes a thousandth of the lens for metres.
    data.dof.aperture_fstop = data.lens * 1e-3 / (2 * scale * radius)


def camera_way(camera):
    """Returns how far the camera moves in a frame. Blender would turn it by an angle, which is not linear in time."""
    end = checked(camera["end"], "camera: end", ["position", "look_at", "up"])
    way, target_way, up_way = (Vector(end[key]) - Vector(camera[key]) for key in ("position", "look_at", "up"))
    if (way - target_way).length > 1e-6 * (1 + way.length) or up_way.length > 1e-6:
        raise SceneError("camera: it turns as it moves, and Blender turns by angles, not linearly in time")
    return way


def slide_camera(item, way, shutter):
    start = item.location.copy()
    for frame, time in zip((FRAME, FRAME + 1), shutter):
        item.location = start + time * way
        item.keyframe_insert("location", frame=frame)
    open_shutter(item.animation_data.action)


def open_shutter(action):
    """Moves by the action evenly between its two keys: Blender's shutter is open for one of its frames, from FRAME on."""
    for curve in action.fcurves:
        for point in curve.keyframe_points:
            point.interpolation = "LINEAR"
    render = bpy.context.scene.render
    render.use_motion_blur, render.motion_blur_shutter = True, 1.0
    bpy.context.scene.cycles.motion_blur_position = "START"
    bpy.context.scene.frame_set(FRAME)


def add_instances(meshes, instances, materials, scale, moved, shutter):
    data = {}
    for (name, mesh, matrix, slots), end_positions in zip(instances, moved):
        triangles, own_slots = meshes[mesh]
        shared = data.get(mesh) if end_positions is None else None
        if shared is None:
            shared = cycles_meshes.make_mesh(mesh, triangles, [materials.get(slot) for slot in own_slots])
        if end_positions is None:
            data[mesh] = shared
        item = add_object(name, shared, world_matrix(matrix, scale))
        if end_positions is not None:
            add_motion(item, end_positions, shutter)
        for slot, own, replaced in zip(item.material_slots, own_slots, slots):
            if own != replaced:
                slot.link = "OBJECT"
                slot.material = materials[replaced]


def add_motion(item, end_positions, shutter):
    """Moves the vertices on straight lines: by a shape key, whose value is the time in our frame."""
    item.shape_key_add(name="start")
    key = item.shape_key_add(name="end")
    key.data.foreach_set("co", end_positions)
    for frame, value in zip((FRAME, FRAME + 1), shutter):
        key.value = value
        key.keyframe_insert("value", frame=frame)
    open_shutter(key.id_data.animation_data.action)


def add_light(light_shape_matrix, name, folder, scale):
    light, shape, matrix = light_shape_matrix
    ies = load_ies(light["ies"], matrix, folder, scale) if "ies" in light else None
    material = cycles_materials.make_light_material(name, light["radiance"], ies)
    add_object(name, cycles_meshes.make_mesh(name, shape, [material]), world_matrix(matrix, scale))


def load_ies(use, light_matrix, folder, scale):
    path = os.path.join(folder, use["file"])
    try:
        grid = cycles_ies.regular_grid(cycles_ies.read_ies(path))
    except cycles_ies.IesError as error:
        raise SceneError(f"{path}: not a usable LM-63 file: {error}") from None
    frame = world_matrix(light_matrix, scale) @ world_matrix(use.get("matrix", IDENTITY), 1.0)
    rows = frame.to_3x3().normalized().transposed()  # unit axes: a scale must not change directions
    centre = tuple(frame.to_translation()) if use.get("point_area", False) else None
    return grid, [tuple(row) for row in rows], centre


def add_object(name, data, matrix=None):
    item = bpy.data.objects.new(name, data)
    bpy.context.scene.collection.objects.link(item)
    if matrix is not None:
        # An object's own transform is location, rotation and scale, which cannot hold a shear; the matrix between a
        # parent and its child is taken as it is.
        item.parent = world_frame()
        item.matrix_parent_inverse = matrix
    cycles_render.keep_shadows(item)
    return item


def world_frame():
    """Returns the empty at the origin that is the parent of every placed object."""
    name = "orbs world frame"
    return bpy.data.objects.get(name) or add_object(name, None)


if __name__ == "__main__":
    main()
