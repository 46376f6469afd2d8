#pragma once

#include "scene/geometry/generators/box.h"
#include "scene/geometry/generators/round.h"
#include "scene/geometry/generators/teapot.h"
#include "scene/geometry/generators/tree.h"
#include "scene/geometry/generators/water.h"

/// Meshes that a scene file asks for by name. Lengths are metres and positive, which the scene reader checks;
/// y is up. Each function returns vertices with unit normals and texture coordinates, tangents of zero, no
/// name and no triangle_materials. Triangle order is part of the contract, since scenes assign materials by
/// it. `triangle_count` says how many triangles a generator will make of parameters that lie within the
/// bounds of a scene file; of a cube, the closed one.
