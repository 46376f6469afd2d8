#pragma once

#include "scene/scene.h"

/// Meshes that emit. ORB.S's shine from both sides; Mitsuba's emitters shine where the normals of the
/// triangles point in world space.

namespace orbs::adapters::mitsuba {

/// Whether no surface scatters light, as in an id pass: then only the camera sees what is emitted.
bool only_camera_sees_light(const scene::Scene& scene);

/// The mesh with each triangle wound so that the side that counts emits: the outer side of a closed mesh, or,
/// where only the camera sees light, the side that the camera sees. `place` is its matrix.
scene::Mesh emitting_mesh(const scene::Scene& scene, scene::Mesh mesh, const Mat4& place);

/// The mesh in world space, each triangle with three separate vertices whose u grows along `axis` projected
/// into the triangle: Mitsuba's polariser transmits along the direction of u and absorbs along that of v.
scene::Mesh polariser_mesh(Vec3d axis, const scene::Mesh& mesh, const Mat4& place);

}  // namespace orbs::adapters::mitsuba
