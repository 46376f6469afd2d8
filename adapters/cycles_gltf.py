"""Renders a .glb file with Cycles as Blender's own importer (io_scene_gltf2) reads it; runs inside Blender 3.4:

    blender -b --factory-startup -noaudio --python-exit-code 3 --python adapters/cycles_gltf.py -- \\
        --scene scene.glb --output out.exr --spp N --seed S --threads T

Materials, meshes and camera are the importer's, so that an image shows what a reader of glTF makes of our exporter; cycles.py
builds the same scene by itself. Of what the exporter puts into the extras of the scene it takes the size of the image and
the trace depth. Ends with status 2 and one line on stderr when the file cannot be read; the output appears only when complete.
Prints `orbs: render_seconds <s>`, the time of the render call alone.
"""

import os
import sys

import bpy
import numpy

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import cycles_render  # noqa: E402


def main():
    arguments = cycles_render.parse_arguments(cycles_render.argument_parser("cycles_gltf.py"))
    try:
        extras = read_scene(os.path.abspath(arguments.scene))
        scene = bpy.context.scene
        scene.render.resolution_x, scene.render.resolution_y = extras["width"], extras["height"]
        cycles_render.set_integrator(extras["trace_depth"], arguments)
        cycles_render.render(os.path.abspath(arguments.output))
    except (OSError, ValueError, KeyError, TypeError, RuntimeError) as error:
        print(f"cycles_gltf.py: error: {arguments.scene}: {' '.join(str(error).split())}", file=sys.stderr, flush=True)
        sys.exit(2)


def read_scene(path):
    """Returns the extras of the imported scene."""
    # The importer of Blender 3.4 uses a name that NumPy dropped in 1.24, which Debian 12 has.
    numpy.bool = bool
    bpy.ops.wm.read_factory_settings(use_empty=True)
    if bpy.ops.import_scene.gltf(filepath=path) != {"FINISHED"}:
        raise ValueError("Blender cannot import it")
    scene = bpy.context.scene
    if "orbs" not in scene:
        raise ValueError("its scene has no extras of orbs, which hold the size of the image and the trace depth")
    scene.camera = next((item for item in scene.objects if item.type == "CAMERA"), None)
    if scene.camera is None:
        raise ValueError("has no camera")
    for item in scene.objects:
        cycles_render.keep_shadows(item)
    return scene["orbs"].to_dict()


if __name__ == "__main__":
    main()
