#pragma once

#include "scene/load/load_scene.h"

namespace orbs::tests {

/// A block, a mirror and a glowing panel on a ground, with two lamps: every relation has something to change.
/// All numbers but the angles are sums of few powers of two.
inline scene::Scene block_on_ground() {
  return scene::load_scene_text("test.json", R"({"format": "orbs-scene/1", "name": "block",
    "camera": {"position": [0.5, 1.5, 3], "look_at": [0, 0.25, 0], "fov_y": 40, "width": 32, "height": 32},
    "materials": [{"name": "ground", "type": "lambert", "reflectance": [0.75, 0.5, 0.25]},
                  {"name": "white", "type": "lambert", "reflectance": [0.75, 0.75, 0.75]},
                  {"name": "mirror", "type": "mirror", "reflectance": [0.875, 0.875, 0.75]},
                  {"name": "glow", "type": "emission", "radiance": [2, 1, 0.5]}],
    "meshes": [{"name": "ground", "generator": "plane", "half_size": 4, "material": "ground"},
               {"name": "block", "generator": "cube", "half_size": 0.25, "material": "white"},
               {"name": "panel", "generator": "plane", "half_size": 0.25, "material": "glow"}],
    "instances": [{"mesh": "ground"},
                  {"mesh": "block", "matrix": [{"translate": [0, 0.25, 0]}, {"rotate_y": 30}]},
                  {"mesh": "block", "matrix": [{"translate": [-0.75, 0.5, 0]}], "remap": ["white", "mirror"]},
                  {"mesh": "panel", "matrix": [{"translate": [0.75, 0.5, 0]}, {"rotate_z": 80}]}],
    "shapes": [{"type": "sphere", "centre": [0.25, 0.25, 0.75], "radius": 0.125, "material": "white"}],
    "lights": [{"type": "rect", "half_width": 0.5, "half_length": 0.25, "radiance": [8, 8, 4],
                "matrix": [{"translate": [0.5, 2, 0.25]}]},
               {"type": "sphere", "radius": 0.125, "radiance": [4, 8, 16],
                "matrix": [{"translate": [-1, 1, 1]}]}],
    "integrator": {"trace_depth": 3}})",
                                ORBS_SOURCE_DIR);
}

/// What everyday scenes have beside that: a shifted lens, a sky by an image, lights without an area, a metal
/// that is brushed across, a sheet that lets rays pass, a normal map, and a mix of two colours.
inline scene::Scene terrace() {
  return scene::load_scene_text("test.json", R"({"format": "orbs-scene/1", "name": "terrace",
    "camera": {"position": [0.5, 1.5, 3], "look_at": [0, 0.25, 0], "fov_y": 40, "width": 32, "height": 32,
               "shift": [0.125, -0.0625]},
    "environment": {"radiance": [0.5, 0.5, 0.5], "map": "sky", "matrix": [{"rotate_y": 20}]},
    "textures": [{"name": "sky", "file": "data/common/skies/linear.exr"},
                 {"name": "tilted", "file": "data/common/textures/tilted_normal.png", "encoding": "linear"}],
    "materials": [{"name": "ground", "type": "lambert", "reflectance": [0.75, 0.5, 0.25]},
                  {"name": "tilted", "type": "lambert", "reflectance": [0.5, 0.5, 0.75],
                   "normal_map": {"texture": "tilted"}},
                  {"name": "brushed", "type": "anisotropic_ggx", "colour": [0.75, 0.5, 0.5], "alpha_x": 0.25,
                   "alpha_y": 0.75, "rotation": 30},
                  {"name": "veil", "type": "lambert", "reflectance": [0.25, 0.75, 0.25], "opacity": 0.5},
                  {"name": "mix", "type": "ggx_lambert", "colour": [0.25, 0.5, 0.25], "alpha": 0.5,
                   "diffuse": [0.25, 0.375, 0.5], "mix": "sum"}],
    "meshes": [{"name": "ground", "generator": "plane", "half_size": 4, "material": "ground"},
               {"name": "block", "generator": "cube", "half_size": 0.25, "material": "brushed"},
               {"name": "sheet", "generator": "plane", "half_size": 0.5, "material": "veil"}],
    "instances": [{"mesh": "ground"},
                  {"mesh": "block", "matrix": [{"translate": [0, 0.25, 0]}, {"rotate_y": 30}]},
                  {"mesh": "block", "matrix": [{"translate": [-0.75, 0.5, 0]}], "remap": ["brushed", "tilted"]},
                  {"mesh": "block", "matrix": [{"translate": [0.5, 0.25, 0.75]}], "remap": ["brushed", "mix"]},
                  {"mesh": "sheet", "matrix": [{"translate": [0.25, 0.5, 0.25]}, {"rotate_z": 80}]}],
    "lights": [{"type": "point", "intensity": [2, 1, 1], "matrix": [{"translate": [-1, 1.5, 1]}]},
               {"type": "spot", "intensity": [4, 4, 2], "inner": 20, "outer": 40,
                "matrix": [{"translate": [0.5, 2, 0.25]}, {"rotate_x": 10}]},
               {"type": "directional", "irradiance": [0.25, 0.5, 0.5], "matrix": [{"rotate_z": -30}]}],
    "integrator": {"trace_depth": 3}})",
                                ORBS_SOURCE_DIR);
}

/// A ground alone below a point of light that no image shows.
inline scene::Scene lamp_above_ground() {
  return scene::load_scene_text("test.json", R"({"format": "orbs-scene/1", "name": "lamp above ground",
    "camera": {"position": [0, 2, 0], "look_at": [0, 0, 0], "up": [0, 0, -1], "fov_y": 40, "width": 32,
               "height": 32},
    "materials": [{"name": "ground", "type": "lambert", "reflectance": [0.75, 0.5, 0.25]}],
    "meshes": [{"name": "ground", "generator": "plane", "half_size": 4, "material": "ground"}],
    "instances": [{"mesh": "ground"}],
    "lights": [{"type": "point", "intensity": [2, 1, 1], "matrix": [{"translate": [0.5, 2.5, 0]}]}],
    "integrator": {"trace_depth": 2}})",
                                ORBS_SOURCE_DIR);
}

}  // namespace orbs::tests
