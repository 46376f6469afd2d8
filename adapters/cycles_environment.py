"""The environment for adapters/cycles.py. Blender's node for environments has another orientation and mixes the row at a
pole with the row at the other; an image looked up by our own formula, between the outermost centres of rows, has neither."""

import math

import bpy
import cycles_materials
from mathutils import Matrix

IDENTITY = [1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0]


def add_environment(environment, textures):
    """`environment`: radiance, and perhaps the name of a map with its matrix. """
    world = bpy.data.worlds.new("environment")
    bpy.context.scene.world = world
    world.use_nodes = True
    world.cycles_visibility.camera = environment.get("visible_to_camera", True)
    background = world.node_tree.nodes["Background"]
    background.inputs["Color"].default_value = (*environment["radiance"], 1.0)
    background.inputs["Strength"].default_value = 1.0
    if "map" not in environment:
        world.cycles.sampling_method = "NONE"  # BSDF sampling is best for a constant.
        return
    image = textures[environment["map"]].image
    shader = cycles_materials.Nodes(world.node_tree)
    colour = looked_up(shader, image, environment.get("matrix", IDENTITY))
    shader.connect(shader.vector("MULTIPLY", colour, environment["radiance"]), background.inputs["Color"])
    # Cycles samples by an image that it draws of the environment, point by point and about another axis: a sun of one
    # texel must hold several of these points.
    world.cycles.sampling_method = "MANUAL"
    world.cycles.sample_map_resolution = min(8 * max(image.size[0], 256), 8192)


def looked_up(shader, image, matrix):
    rows = Matrix([matrix[4 * r : 4 * r + 4] for r in range(4)]).to_3x3().inverted()
    direction = shader.node("ShaderNodeTexCoord").outputs["Generated"]
    x, y, z = (shader.vector("DOT_PRODUCT", direction, tuple(row)) for row in rows)
    turns = shader.math("DIVIDE", shader.math("ARCTAN2", x, shader.math("MULTIPLY", z, -1.0)), 2 * math.pi)
    v = shader.math("MULTIPLY_ADD", shader.math("ARCSINE", y), 1 / math.pi, 0.5)
    edge = 0.5 / image.size[1]
    v = shader.math("MINIMUM", shader.math("MAXIMUM", v, edge), 1 - edge)
    u = shader.math("ADD", turns, 0.5)
    vector = shader.node("ShaderNodeCombineXYZ", {"X": u, "Y": v}).outputs["Vector"]
    return cycles_materials.image_lookup(shader, image, vector, "REPEAT")
