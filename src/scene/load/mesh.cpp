#include "scene/load/mesh.h"

#include "base/nth.h"
#include "base/text.h"
#include "scene/geometry/crease_normals.h"
#include "scene/geometry/generators.h"
#include "scene/geometry/mesh_file.h"
#include "scene/geometry/obj.h"
#include "scene/geometry/ply.h"
#include "scene/geometry/subdivision/entry.h"
#include "scene/load/entry.h"
#include "scene/motion.h"
#include "scene/scene.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace orbs::scene {

namespace {

constexpr int kMostSegments = 4096;

TreeParameters load_tree(json::ObjectReader& in) {
  return {in.number("height", kLength), in.number("radius", kLength), in.integer("tiers", 1, 100),
          in.integer("points", 3, 100)};
}

WaterParameters load_water(json::ObjectReader& in) {
  return {in.number("half_width", kLength), in.number("half_length", kLength),
          in.number("depth", kLength),      in.number("amplitude", kLength),
          in.number("wavelength", kLength), in.integer("segments", 1, kMostSegments)};
}

SphereParameters load_sphere(json::ObjectReader& in) {
  return {in.number("radius", kLength), in.integer("segments", 3, kMostSegments)};
}

TorusParameters load_torus(json::ObjectReader& in) {
  return {in.number("minor_radius", kLength), in.number("major_radius", kLength),
          in.integer("ring_segments", 3, kMostSegments), in.integer("tube_segments", 3, kMostSegments)};
}

// The mesh of the entry's "generator", without name and materials. InputError at the key that is wrong.
Mesh load_generated(json::ObjectReader& in, SceneBudget& left) {
  const std::string kind =
      in.one_of("generator", {"plane", "cube", "cube_open", "sphere", "torus", "teapot", "tree", "water"});
  // A few bytes of text can ask for millions of triangles, so they are counted before they are made.
  const auto made = [&](const auto& parameters, auto make) {
    spend(in, "generator", "triangles", triangle_count(parameters), left.triangles);
    try {
      return make(parameters);
    } catch (const InputError& e) {
      in.fail("generator", e.what());
    }
  };
  if (kind == "plane") return made(PlaneParameters{in.number("half_size", kLength)}, make_plane);
  if (kind == "cube") return made(CubeParameters{in.number("half_size", kLength)}, make_cube);
  if (kind == "cube_open") return made(CubeParameters{in.number("half_size", kLength)}, make_cube_open);
  if (kind == "sphere") return made(load_sphere(in), make_sphere);
  if (kind == "torus") return made(load_torus(in), make_torus);
  if (kind == "teapot") return made(TeapotParameters{in.integer("subdivisions", 1, 128)}, make_teapot);
  if (kind == "tree") return made(load_tree(in), make_tree);
  return made(load_water(in), make_water);
}

template <typename Vector>
std::vector<Vector> vectors(json::ObjectReader& in, const std::string& key, std::size_t width) {
  const auto numbers = in.numbers(key);
  if (numbers.size() % width != 0)
    in.fail(key, fmt::format("must hold groups of {} numbers, holds {}", width, numbers.size()));
  std::vector<Vector> out(numbers.size() / width);
  for (std::size_t i = 0; i < out.size(); ++i) {
    using Real = decltype(out[i].x);
    out[i].x = static_cast<Real>(numbers[i * width]);
    out[i].y = static_cast<Real>(numbers[i * width + 1]);
    if constexpr (requires { out[i].z; }) out[i].z = static_cast<Real>(numbers[i * width + 2]);
  }
  return out;
}

MeshFile inline_mesh(json::ObjectReader& in) {
  MeshFile file;
  place_vertices(vectors<Vec3d>(in, "positions", 3), file);
  Mesh& mesh = file.mesh;
  mesh.normals = vectors<Vec3f>(in, "normals", 3);
  mesh.tangents.resize(mesh.positions.size());
  mesh.uvs.resize(mesh.positions.size());
  if (in.has("tangents")) mesh.tangents = vectors<Vec3f>(in, "tangents", 3);
  if (in.has("uvs")) mesh.uvs = vectors<Vec2f>(in, "uvs", 2);
  if (in.has("second_uvs")) mesh.second_uvs = vectors<Vec2f>(in, "second_uvs", 2);
  const auto corners = in.numbers("triangles", 0, json::kNotNegative);
  if (corners.size() % 3 != 0)
    in.fail("triangles", fmt::format("must hold groups of 3 indices, holds {}", corners.size()));
  mesh.triangles.resize(corners.size() / 3);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    if (corners[i] >= static_cast<double>(mesh.positions.size()))
      in.fail_at(
          "triangles", i,
          fmt::format("index {} is out of range: there are {} vertices", corners[i], mesh.positions.size()));
    if (corners[i] != static_cast<double>(static_cast<std::uint32_t>(corners[i])))
      in.fail_at("triangles", i, fmt::format("must be a whole number, is {}", corners[i]));
    mesh.triangles[i / 3][i % 3] = static_cast<std::uint32_t>(corners[i]);
  }
  return file;
}

std::string vertex_problem(std::size_t index, Vec3f position, Vec3f normal) {
  if (!is_finite(position) || largest_magnitude(position) > kFarthest_m)
    return fmt::format("position {} lies farther out than {} m, or is no number", index, kFarthest_m);
  if (!is_direction(normal))
    return fmt::format("normal {} must be finite and not zero: normals are used as given", index);
  return "";
}

std::string index_problem(const Mesh& mesh) {
  const std::size_t count = mesh.positions.size();
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
    for (const auto corner : mesh.triangles[i])
      if (corner >= count)
        return fmt::format("triangle {} has index {}: out of range, there are {} vertices", i, corner, count);
  return "";
}

// The start is right; see mesh_problem.
std::string end_problem(const Mesh& start, const MeshEnd& end) {
  const std::size_t count = start.positions.size();
  if (end.positions.size() != count || end.normals.size() != count)
    return fmt::format(
        "there are {} vertices at the start of the frame, {} positions and {} normals at its end", count,
        end.positions.size(), end.normals.size());
  for (std::size_t i = 0; i < count; ++i) {
    if (const auto problem = vertex_problem(i, end.positions[i], end.normals[i]); !problem.empty())
      return problem;
    if (meets_zero(cast<double>(start.normals[i]), cast<double>(end.normals[i])))
      return fmt::format(
          "normal {} is the opposite of that of the start, and there is none on the way: normals are linear in "
          "time",
          i);
  }
  return "";
}

MeshFile mesh_of_file(json::ObjectReader& in, const DataFolders& folders) {
  const auto file = existing_file(in, "file", folders);
  const auto extension = file.extension();
  const auto normals = in.has("crease_angle") ? FileNormals::MayLack : FileNormals::Required;
  if (extension != ".obj" && extension != ".ply") in.fail("file", "must end in .obj or .ply");
  return with_note("loading the mesh that " + in.place("file") + " names",
                   [&] { return extension == ".obj" ? read_obj(file, normals) : read_ply(file, normals); });
}

// Normals of a file by the angle that the scene gives: all, or those that the file lacks.
void add_normals(json::ObjectReader& in, MeshFile& file) {
  const double crease_deg = in.number("crease_angle", {0, 180});
  const bool keeps = in.one_of_or("given_normals", "replace", {"replace", "keep"}) == "keep";
  if (const auto problem = index_problem(file.mesh); !problem.empty()) in.fail("file", problem);
  const auto& normals = file.mesh.normals;
  if (keeps && std::all_of(normals.begin(), normals.end(), is_direction))
    in.fail("given_normals",
            "the file has all normals: leave the key out to replace them, or \"crease_angle\", "
            "too, to use them as given");
  compute_normals(file.mesh, crease_deg, keeps ? GivenNormals::Keep : GivenNormals::Replace);
}

void assign_runs(json::ObjectReader& in, const Names& materials, Mesh& mesh) {
  mesh.triangle_materials.clear();
  for (auto& run : in.objects("triangle_materials")) {
    const int material = materials.find(run, "material");
    const int count = run.integer("count", 1, 1 << 30);
    run.finish();
    if (mesh.triangle_materials.size() + static_cast<std::size_t>(count) > mesh.triangles.size())
      run.fail("count", fmt::format("the counts go beyond the mesh's {} triangles", mesh.triangles.size()));
    mesh.triangle_materials.insert(mesh.triangle_materials.end(), static_cast<std::size_t>(count), material);
  }
  if (mesh.triangle_materials.size() != mesh.triangles.size())
    in.fail("triangle_materials", fmt::format("the counts add up to {}, the mesh has {} triangles",
                                              mesh.triangle_materials.size(), mesh.triangles.size()));
}

// Maps the materials of the file (usemtl names, or slots of the list `materials`) to those of the scene.
void assign_file_materials(json::ObjectReader& in, const Names& materials, MeshFile& file) {
  std::vector<int> scene_material;
  if (file.names_are_slots) {
    const auto names = in.texts("materials");
    for (std::size_t i = 0; i < names.size(); ++i)
      scene_material.push_back(materials.find_at(in, "materials", i, names[i]));
  } else {
    for (std::size_t i = 0; i < file.material_names.size(); ++i) {
      const auto& name = file.material_names[i];
      scene_material.push_back(materials.lookup(name));
      if (scene_material.back() < 0)
        in.fail("file",
                fmt::format("line {} of it, usemtl: {}", file.material_lines[i], materials.unknown(name)));
    }
  }
  for (int& material : file.mesh.triangle_materials) {
    if (material < 0)
      in.fail("file",
              file.names_are_slots
                  ? "faces of it have no property 'material': give \"material\" in the scene"
                  : "a face of it stands before the first usemtl, or after one without a name: give it "
                    "a material by usemtl, or all faces by \"material\" in the scene");
    if (material >= static_cast<int>(scene_material.size()))
      in.fail(file.names_are_slots ? "materials" : "file",
              fmt::format("a triangle has material {}, which is not in the list of {}; or give \"material\"",
                          material, scene_material.size()));
    material = nth(scene_material, material);
  }
}

void assign_materials(json::ObjectReader& in, const Names& materials, MeshFile& file, bool from_file) {
  if (in.has("material")) {
    file.mesh.triangle_materials.assign(file.mesh.triangles.size(), materials.find(in, "material"));
  } else if (in.has("triangle_materials")) {
    assign_runs(in, materials, file.mesh);
  } else if (from_file) {
    assign_file_materials(in, materials, file);
  } else {
    in.fail("", "needs \"material\" or \"triangle_materials\"");
  }
}

// The vertices at the end of the frame, relative to the origin of those of the start.
MeshEnd load_end(json::ObjectReader in, const DataFolders& folders, const MeshFile& start) {
  MeshEnd end;
  std::vector<Vec3d> places;
  const bool from_file = in.has("file");
  if (from_file) {
    const MeshFile file = mesh_of_file(in, folders);
    if (file.mesh.triangles != start.mesh.triangles)
      in.fail("file",
              "must have the triangles of the start of the frame, vertex by vertex and in their order");
    for (const Vec3f p : file.mesh.positions) places.push_back(cast<double>(p) + file.origin_m);
    end.normals = file.mesh.normals;
  } else {
    places = vectors<Vec3d>(in, "positions", 3);
    end.normals = vectors<Vec3f>(in, "normals", 3);
  }
  in.finish();
  for (const Vec3d p : places) end.positions.push_back(cast<float>(p - start.origin_m));
  if (const auto problem = end_problem(start.mesh, end); !problem.empty())
    in.fail(from_file ? "file" : "", problem);
  return end;
}

// Appends to `places` where the vertices lie, and everything else to `whole`.
void append_moved(Mesh& whole, std::vector<Vec3d>& places, const MeshFile& file, const Mat4& matrix) {
  const Mesh& part = file.mesh;
  const Mat4 back = inverse(matrix).value();  // load_matrix has refused singular ones
  const auto first = static_cast<std::uint32_t>(places.size());
  const bool moves = !(matrix == Mat4{});
  const auto unit = [](Vec3d v) { return length(v) > 0 ? normalised(v) : v; };
  for (std::size_t i = 0; i < part.positions.size(); ++i) {
    const Vec3d p = cast<double>(part.positions[i]) + file.origin_m;
    const Vec3d n = cast<double>(part.normals[i]);
    const Vec3d t = cast<double>(part.tangents[i]);
    places.push_back(moves ? transform_point(matrix, p) : p);
    whole.normals.push_back(moves ? cast<float>(unit(transform_normal(back, n))) : part.normals[i]);
    whole.tangents.push_back(moves ? cast<float>(unit(transform_direction(matrix, t))) : part.tangents[i]);
    whole.uvs.push_back(part.uvs[i]);
  }
  append_second_uvs(whole, part, first, places.size());
  for (const auto& t : part.triangles) whole.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  whole.triangle_materials.insert(whole.triangle_materials.end(), part.triangle_materials.begin(),
                                  part.triangle_materials.end());
}

MeshFile load_source(json::ObjectReader& in,
                     const DataFolders& folders,
                     const Names& materials,
                     SceneBudget& left) {
  MeshFile file;
  const bool from_file = in.has("file");
  if (from_file)
    file = mesh_of_file(in, folders);
  else if (in.has("generator"))
    file.mesh = load_generated(in, left);
  else if (in.has("positions"))
    file = inline_mesh(in);
  else
    in.fail("", "needs one of: generator, file, positions, parts, subdivision");
  if (!in.has("generator")) spend(in, "", "triangles", file.mesh.triangles.size(), left.triangles);
  if (from_file && in.has("crease_angle"))
    add_normals(in, file);
  else if (in.has("given_normals"))
    in.fail("given_normals", "goes with the \"crease_angle\" of a file");
  assign_materials(in, materials, file, from_file);
  return file;
}

}  // namespace

MeshFile load_mesh(json::ObjectReader in,
                   const DataFolders& folders,
                   const Names& materials,
                   SceneBudget& left) {
  MeshFile file;
  const std::string name = in.text("name");
  if (in.has("parts")) {
    std::vector<Vec3d> places;
    for (auto& part : in.objects("parts")) {
      if (part.has("subdivision")) part.fail("subdivision", "cannot be a part: make it a separate mesh");
      const Mat4 matrix = load_matrix(part, "matrix");
      const auto loaded = load_source(part, folders, materials, left);
      append_moved(file.mesh, places, loaded, matrix);
      file.warnings.insert(file.warnings.end(), loaded.warnings.begin(), loaded.warnings.end());
      part.finish();
    }
    place_vertices(places, file);
  } else if (in.has("subdivision")) {
    file = load_subdivision(in, left);
    file.mesh.triangle_materials.assign(file.mesh.triangles.size(), materials.find(in, "material"));
  } else {
    file = load_source(in, folders, materials, left);
  }
  file.mesh.name = name;
  if (const auto problem = mesh_problem(file.mesh); !problem.empty()) in.fail("", problem);
  if (in.has("end")) {
    if (file.mesh.subdivision)
      in.fail("end", "does not go with \"subdivision\": give the mesh its triangles at both times");
    file.mesh.end = load_end(in.object("end"), folders, file);
  }
  in.finish();
  if (largest_magnitude(file.origin_m) > kFarthest_m)
    in.fail("", fmt::format("the mesh lies farther out than {} m", kFarthest_m));
  return file;
}

std::string mesh_problem(const Mesh& mesh) {
  const std::size_t count = mesh.positions.size();
  if (mesh.triangles.empty()) return "the mesh has no triangles";
  if (mesh.normals.size() != count)
    return fmt::format("there are {} positions and {} normals", count, mesh.normals.size());
  if (mesh.tangents.size() != count)
    return fmt::format("there are {} positions and {} tangents", count, mesh.tangents.size());
  if (mesh.uvs.size() != count)
    return fmt::format("there are {} positions and {} texture coordinates", count, mesh.uvs.size());
  if (!mesh.second_uvs.empty() && mesh.second_uvs.size() != count)
    return fmt::format("there are {} positions and {} second texture coordinates", count,
                       mesh.second_uvs.size());
  for (const Vec2f uv : mesh.second_uvs)
    if (!std::isfinite(uv.x + uv.y)) return "a second texture coordinate is not finite";
  for (std::size_t i = 0; i < count; ++i) {
    if (!is_finite(mesh.tangents[i])) return fmt::format("tangent {} is not finite", i);
    if (!std::isfinite(mesh.uvs[i].x + mesh.uvs[i].y))
      return fmt::format("texture coordinate {} is not finite", i);
    if (auto problem = vertex_problem(i, mesh.positions[i], mesh.normals[i]); !problem.empty())
      return problem;
  }
  return index_problem(mesh);
}

}  // namespace orbs::scene
