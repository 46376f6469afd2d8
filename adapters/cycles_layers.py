"""Layers of the surface that the camera sees (AOVs) by Cycles' passes; for cycles.py, inside Blender 3.4.

Blender's compositor writes them into one file beside the colour, whose channels are named after the slots: "Image.R",
"depth.V" (a number), "normal.X". The entry of the renderer in configuration.json says which is which of ours.

Lengths are in the units of the scaled world, so they are divided by its scale. Cycles' depth and numbers are those of one
sample of the pixel; the other passes are means over its samples, where a sample that hits nothing counts as 0. The coverage
is the alpha of the colour, which is below 1 only where the environment is not drawn."""

import glob
import os

import bpy

# The pass that each layer needs, and its name among the outputs of the compositor's render layers.
PASSES = {
    "depth": ("use_pass_z", "Depth"),
    "position": ("use_pass_position", "Position"),
    "normal": ("use_pass_normal", "Normal"),
    "albedo": ("use_pass_diffuse_color", "DiffCol"),
    "uv": ("use_pass_uv", "UV"),
    "instance": ("use_pass_object_index", "IndexOB"),
    "object": ("use_pass_object_index", "IndexOB"),
    "material": ("use_pass_material_index", "IndexMA"),
}
COLOUR = "Image"


def prepared_layers(scene, scale):
    """Has Cycles make the passes of the layers that the scene asks for; returns their names and the scale of the world, or
    None. It has one number an object."""
    wanted = scene.get("outputs", {}).get("layers", [])
    if not wanted:
        return None
    if "coverage" in wanted and scene.get("environment", [0, 0, 0]) != [0, 0, 0]:
        raise ValueError("outputs: Cycles tells the coverage only before a black environment")
    for name in wanted:
        if name in PASSES:
            setattr(bpy.context.view_layer, PASSES[name][0], True)
    number_things(wanted, [mesh["name"] for mesh in scene.get("meshes", [])])
    return wanted, scale


def number_things(wanted, meshes):
    """Numbers objects, in the order in which they were added, or their meshes, and materials, from 1."""
    numbers = {name: index + 1 for index, name in enumerate(meshes)}
    drawn = [item for item in bpy.data.objects if item.type == "MESH"]
    for index, item in enumerate(drawn):
        by_mesh = "object" in wanted and "instance" not in wanted
        item.pass_index = numbers.get(item.data.name, len(numbers) + index + 1) if by_mesh else index + 1
    for index, material in enumerate(bpy.data.materials):
        material.pass_index = index + 1


def add_output(wanted, scale, folder, stem):
    """Adds the compositor's output file, which rendering then writes as <folder>/<stem><frame>.exr."""
    scene = bpy.context.scene
    scene.use_nodes = True
    scene.render.use_compositing = True
    tree = scene.node_tree
    tree.nodes.clear()
    passes = tree.nodes.new("CompositorNodeRLayers")
    tree.links.new(passes.outputs["Image"], tree.nodes.new("CompositorNodeComposite").inputs["Image"])
    file = tree.nodes.new("CompositorNodeOutputFile")
    file.base_path = os.path.join(folder, stem)
    file.format.file_format, file.format.color_depth, file.format.exr_codec = "OPEN_EXR_MULTILAYER", "32", "ZIP"
    file.layer_slots.clear()
    tree.links.new(passes.outputs["Image"], file.layer_slots.new(COLOUR) and file.inputs[COLOUR])
    for name in wanted:
        if name not in PASSES or (name == "object" and "instance" in wanted):
            continue
        output = passes.outputs[PASSES[name][1]]
        file.layer_slots.new(name)
        tree.links.new(in_metres(tree, name, output, scale), file.inputs[name])


def in_metres(tree, name, output, scale):
    if name == "depth":
        return scaled(tree, output, 1 / scale)
    if name != "position":
        return output
    parts = tree.nodes.new("CompositorNodeSeparateXYZ")
    whole = tree.nodes.new("CompositorNodeCombineXYZ")
    tree.links.new(output, parts.inputs[0])
    for axis in range(3):
        tree.links.new(scaled(tree, parts.outputs[axis], 1 / scale), whole.inputs[axis])
    return whole.outputs[0]


def scaled(tree, output, factor):
    node = tree.nodes.new("CompositorNodeMath")
    node.operation = "MULTIPLY"
    tree.links.new(output, node.inputs[0])
    node.inputs[1].default_value = factor
    return node.outputs[0]


def written_file(folder, stem):
    files = glob.glob(os.path.join(glob.escape(folder), glob.escape(stem) + "*.exr"))
    if len(files) != 1:
        raise ValueError(f"Blender's compositor wrote {len(files)} files")
    return files[0]
