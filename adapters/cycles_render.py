"""Settings of Cycles and the render itself; for cycles.py and cycles_gltf.py, inside Blender 3.4."""

import argparse
import os
import sys
import time

import bpy

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import cycles_layers  # noqa: E402

MOST_BOUNCES = 1024  # Blender accepts no more.


def argument_parser(program):
    """Returns a parser of the options that each renderer of Cycles has."""
    parser = argparse.ArgumentParser(prog=program)
    parser.add_argument("--scene", required=True)
    parser.add_argument("--output", required=True)
    parser.add_argument("--spp", type=int, required=True)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--threads", type=int, default=1)
    return parser


def parse_arguments(parser):
    """Parses what stands behind the -- of Blender's command line."""
    return parser.parse_args(sys.argv[sys.argv.index("--") + 1 :] if "--" in sys.argv else [])


def keep_shadows(item):
    """Cycles moves the start of grazing shadow rays off smooth surfaces by default (0.1), which changes the shadows."""
    item.cycles.shadow_terminator_geometry_offset = 0.0
    item.cycles.shadow_terminator_offset = 0.0


def set_integrator(depth, arguments):
    """Has Cycles trace paths of `depth` scatterings (or "unlimited"), without anything that trades bias for noise."""
    scene = bpy.context.scene
    if depth == "unlimited":
        depth = MOST_BOUNCES + 1
    if not isinstance(depth, int) or depth < 1:
        raise ValueError(f"trace_depth must be a whole number of at least 1 or unlimited, is {depth}")
    scene.render.engine = "CYCLES"
    scene.render.threads_mode, scene.render.threads = "FIXED", arguments.threads
    cycles = scene.cycles
    settings = {
        "samples": arguments.spp, "seed": arguments.seed,
        "use_adaptive_sampling": False, "use_denoising": False, "time_limit": 0.0,  # exactly spp samples, unfiltered
        "sample_clamp_direct": 0.0, "sample_clamp_indirect": 0.0,  # 0: no clamping
        "blur_glossy": 0.0, "light_sampling_threshold": 0.0,  # both trade bias for noise when above 0
        "caustics_reflective": True, "caustics_refractive": True,
        "pixel_filter_type": "BOX", "film_exposure": 1.0, "use_fast_gi": False,
        # A path of N scatterings with light sampling at each is what Cycles calls N - 1 bounces.
        "max_bounces": depth - 1, "diffuse_bounces": depth - 1, "glossy_bounces": depth - 1,
        "transmission_bounces": depth - 1, "transparent_max_bounces": 1024, "volume_bounces": 0,
        "use_auto_tile": False,
    }  # fmt: skip
    for key, value in settings.items():
        setattr(cycles, key, value)
    cycles.min_light_bounces = min(cycles.min_light_bounces, depth)


def render(output, layers=None):
    """Renders linear radiance into `output`, which appears only when complete. `layers`: names and scale of layers of
    surfaces that it holds as well (cycles_layers.py)."""
    scene = bpy.context.scene
    image = scene.render.image_settings
    image.file_format, image.color_mode, image.color_depth, image.exr_codec = "OPEN_EXR", "RGB", "32", "ZIP"
    scene.view_settings.view_transform, scene.view_settings.look = "Raw", "None"
    scene.view_settings.exposure, scene.view_settings.gamma = 0.0, 1.0
    scene.render.resolution_percentage = 100
    scene.render.pixel_aspect_x = scene.render.pixel_aspect_y = 1.0
    scene.render.film_transparent = bool(layers) and "coverage" in layers[0]
    scene.render.use_compositing = scene.render.use_sequencer = False
    scene.render.dither_intensity = 0.0
    for name in dir(scene.render):
        if name.startswith("use_stamp"):
            setattr(scene.render, name, False)  # no dates and durations in the file: same image, same bytes
    temporary = f"{output}.{os.getpid()}.part"
    folder, stem = os.path.split(temporary)
    if layers:
        cycles_layers.add_output(*layers, folder, stem)
    start = time.perf_counter()
    bpy.ops.render.render()
    print(f"orbs: render_seconds {time.perf_counter() - start:.6f}", flush=True)
    # save_render and not write_still, which takes a # in a path for the frame number.
    if layers:
        os.replace(cycles_layers.written_file(folder, stem), temporary)
    else:
        bpy.data.images["Render Result"].save_render(temporary, scene=scene)
    if not os.path.exists(temporary):
        raise ValueError("Blender wrote no image")
    os.replace(temporary, output)
