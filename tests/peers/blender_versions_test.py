#!/usr/bin/env python3
"""What the adapter of Cycles asks of Blender, version by version: a made-up bpy has what that version has, and no more.

    blender_versions_test.py <repository>
"""
import sys
import types
import unittest

sys.path.insert(0, sys.argv.pop(1) + "/adapters")
bpy = types.ModuleType("bpy")
bpy.app = types.SimpleNamespace(version=(3, 4, 1))
sys.modules["bpy"] = bpy
import cycles_materials  # noqa: E402
import cycles_meshes  # noqa: E402


class Mesh:
    """Of Blender 4.1: a property that is gone cannot be set."""

    __slots__ = ["normals"]

    def normals_split_custom_set_from_vertices(self, normals):
        self.normals = normals


class OldMesh(Mesh):
    __slots__ = ["use_auto_smooth", "auto_smooth_angle"]


class BlenderVersions(unittest.TestCase):
    def test_distributions_are_those_that_there_are(self):
        for version, sharp in (((3, 4, 1), "SHARP"), ((3, 6, 0), "SHARP"), ((4, 0, 0), "GGX"), ((4, 3, 2), "GGX")):
            bpy.app.version = version
            self.assertEqual(cycles_materials.distribution_of(0), sharp)
            self.assertEqual(cycles_materials.distribution_of(0.25), "GGX")

    def test_normals_are_set_in_each_version(self):
        for version, mesh in (((3, 4, 1), OldMesh()), ((4, 0, 2), OldMesh()), ((4, 1, 0), Mesh()), ((5, 0, 0), Mesh())):
            bpy.app.version = version
            cycles_meshes.set_normals(mesh, [0, 0, 1, 0, 1, 0])
            self.assertEqual(mesh.normals, [(0, 0, 1), (0, 1, 0)])
            if version < (4, 1):
                self.assertTrue(mesh.use_auto_smooth)


unittest.main()
