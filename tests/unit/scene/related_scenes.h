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

}  // namespace orbs::tests
