"""Lights without an area for adapters/cycles.py. Cycles divides the watts of a point by 4 pi sr, and its spots have a factor
cos(theta) beside their cone; the same cone without it is a point whose strength is a function of the direction. On lamps
the output Normal of the node Geometry is the direction of the light that leaves."""

import math

import bpy
import cycles_materials
from mathutils import Vector


def add_light(light, name, matrix, scale, ies):
    """`matrix`: to the world in `scale`; `ies` = (Grid, to_local 3x3 rows, centre or None) or None."""
    kind = light["type"]
    data = bpy.data.lights.new(name, "SUN" if kind == "directional" else "POINT")
    emission = light["irradiance" if kind == "directional" else "intensity"]
    strength = max(emission)
    data.color = [channel / strength if strength > 0 else 0 for channel in emission]
    item = bpy.data.objects.new(name, data)
    bpy.context.scene.collection.objects.link(item)
    item.location = matrix.to_translation()
    axis = (matrix.to_3x3() @ Vector((0, -1, 0))).normalized()
    if kind == "directional":
        data.angle, data.energy = 0.0, strength
        item.rotation_mode = "QUATERNION"
        item.rotation_quaternion = axis.to_track_quat("-Z", "Y")
        return
    # A radius would make it a disk that is turned towards the receiver. Watts at another scale of the world.
    data.shadow_soft_size, data.energy = 0.0, 4 * math.pi * strength * scale**2
    if kind == "spot":
        shape(data, lambda shader, direction: cone_share(shader, direction, axis, light))
    elif ies:
        shape(data, lambda shader, direction: cycles_materials.profile_share(shader, name, *ies[:2], direction))


def shape(data, share):
    """Multiplies the light's strength by share(shader, emitted direction)."""
    data.use_nodes = True
    shader = cycles_materials.Nodes(data.node_tree)
    direction = shader.node("ShaderNodeNewGeometry").outputs["Normal"]
    data.node_tree.links.new(share(shader, direction), data.node_tree.nodes["Emission"].inputs["Strength"])


def cone_share(shader, direction, axis, light):
    inner, outer = (math.cos(math.radians(light[key])) for key in ("inner", "outer"))
    cosine = shader.vector("DOT_PRODUCT", direction, axis)
    if inner <= outer:
        return shader.math("GREATER_THAN", cosine, outer)
    t = shader.math("DIVIDE", shader.math("SUBTRACT", cosine, outer), inner - outer)
    t = shader.math("MINIMUM", shader.math("MAXIMUM", t, 0.0), 1.0)
    return shader.math("MULTIPLY", shader.math("MULTIPLY", t, t), shader.math("MULTIPLY_ADD", t, -2.0, 3.0))
