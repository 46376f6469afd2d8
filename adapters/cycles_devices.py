"""The device that Cycles renders on; for cycles.py, inside Blender."""

import bpy

KINDS = ["CPU", "CUDA", "OPTIX", "HIP", "ONEAPI", "METAL"]


def choose_device(kind):
    """Has Cycles render on all devices of this kind, one of KINDS.

    Raises ValueError where there is none: Cycles itself would render on the CPU without a word, and the image would
    stand in a table as that of a GPU.
    """
    cycles = bpy.context.scene.cycles
    if kind == "CPU":
        cycles.device = "CPU"
        return
    preferences = bpy.context.preferences.addons["cycles"].preferences
    try:
        preferences.compute_device_type = kind
    except TypeError as error:
        raise ValueError(f"--device {kind}: this Blender is built without it") from error
    found = [device.name for device in preferences.get_devices_for_type(kind) if device.type == kind]
    if not found:
        raise ValueError(f"--device {kind}: Blender finds no such device on this machine")
    for device in preferences.devices:
        device.use = device.type == kind
    cycles.device = "GPU"
