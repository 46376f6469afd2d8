#include "importer/nodes.h"

#include "importer/accessors.h"
#include "importer/meshes.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <set>

namespace orbs::importer {

namespace {

// glTF stores columns.
Mat4 transposed(const double* numbers) {
  Mat4 matrix;
  for (std::size_t row = 0; row < 4; ++row)
    for (std::size_t column = 0; column < 4; ++column) matrix(row, column) = numbers[4 * column + row];
  return matrix;
}

Mat4 rotation_of(const Source& source, const std::vector<double>& q, const std::string& where) {
  const double size = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
  if (!(size > 0) || !std::isfinite(size))
    refuse(source, where + " is turned by a quaternion without a length; expected one of length 1");
  const double x = q[0] / size;
  const double y = q[1] / size;
  const double z = q[2] / size;
  const double w = q[3] / size;
  return {{1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y), 0, 2 * (x * y + w * z),
           1 - 2 * (x * x + z * z), 2 * (y * z - w * x), 0, 2 * (x * z - w * y), 2 * (y * z + w * x),
           1 - 2 * (x * x + y * y), 0, 0, 0, 0, 1}};
}

Mat4 own_matrix(const Source& source, const tinygltf::Node& node, const std::string& where) {
  if (node.matrix.size() == 16) return transposed(node.matrix.data());
  Mat4 matrix;
  if (const auto& t = node.translation; t.size() == 3) matrix = translation({t[0], t[1], t[2]});
  if (node.rotation.size() == 4) matrix = matrix * rotation_of(source, node.rotation, where);
  if (const auto& s = node.scale; s.size() == 3) matrix = matrix * scaling({s[0], s[1], s[2]});
  return matrix;
}

const std::vector<int>& root_nodes(const Source& source, Report& report, std::vector<int>& otherwise) {
  const auto& model = source.model;
  if (model.scenes.empty()) {
    std::vector<bool> is_child(model.nodes.size());
    for (const auto& node : model.nodes)
      for (const int child : node.children)
        if (child >= 0 && static_cast<std::size_t>(child) < is_child.size())
          is_child[static_cast<std::size_t>(child)] = true;
    for (std::size_t i = 0; i < model.nodes.size(); ++i)
      if (!is_child[i]) otherwise.push_back(static_cast<int>(i));
    return otherwise;
  }
  const int chosen = std::max(0, model.defaultScene);
  for (std::size_t i = 0; i < model.scenes.size(); ++i)
    if (static_cast<int>(i) != chosen)
      report.not_understood("further scenes", "the default one alone",
                            place("scene", model.scenes[i].name, i));
  return item(source, model.scenes, chosen, "scene", "the file").nodes;
}

std::string node_place(const Source& source, int index) {
  return place("node", item(source, source.model.nodes, index, "node", "a scene or node").name,
               static_cast<std::size_t>(index));
}

void name_extensions(Report& report, const tinygltf::Node& node, const std::string& where) {
  for (const auto& [name, value] : node.extensions)
    if (name != "KHR_lights_punctual") report.not_understood(name, "as if it were not there", where);
}

// Where each bone takes what is bound to it, in the world: the place of the skinned node has no effect
// (3.7.3.3).
std::vector<Mat4> joint_matrices(const Source& source,
                                 int index,
                                 const std::map<int, Mat4>& places,
                                 const std::string& where) {
  const auto& skin = item(source, source.model.skins, index, "skin", where);
  const auto name = place("skin", skin.name, static_cast<std::size_t>(index));
  Numbers bound;
  if (skin.inverseBindMatrices >= 0) {
    bound = read_numbers(source, skin.inverseBindMatrices, 16, "the matrices of " + name);
    if (bound.count < skin.joints.size())
      refuse(source, fmt::format("{} has {} joints and {} matrices", name, skin.joints.size(), bound.count));
  }
  std::vector<Mat4> joints;
  for (std::size_t i = 0; i < skin.joints.size(); ++i) {
    const auto found = places.find(skin.joints[i]);
    if (found == places.end())
      refuse(source,
             fmt::format("{} names node {} as a joint, which is not in the scene", name, skin.joints[i]));
    joints.push_back(bound.count > 0 ? found->second * transposed(bound.element(i)) : found->second);
  }
  if (joints.empty()) refuse(source, name + " has no joints");
  return joints;
}

std::vector<double> morph_weights(const Source& source,
                                  const tinygltf::Node& node,
                                  const std::string& where) {
  const auto& weights = node.weights.empty()
                            ? item(source, source.model.meshes, node.mesh, "mesh", where).weights
                            : node.weights;
  const bool rests = std::all_of(weights.begin(), weights.end(), [](double weight) { return weight == 0; });
  return rests ? std::vector<double>{} : weights;
}

}  // namespace

std::vector<PlacedNode> placed_nodes(const Source& source, Report& report) {
  std::vector<int> otherwise;
  const auto& roots = root_nodes(source, report, otherwise);
  std::vector<PlacedNode> open;
  std::transform(roots.rbegin(), roots.rend(), std::back_inserter(open), [](int root) {
    return PlacedNode{root, {}};
  });
  std::vector<PlacedNode> placed;
  std::set<int> seen;
  while (!open.empty()) {
    const PlacedNode next = open.back();
    open.pop_back();
    const auto where = node_place(source, next.node);
    if (!seen.insert(next.node).second)
      refuse(source, where +
                         " is reached twice: the nodes of glTF are trees, in which each has one parent and "
                         "none is its own ancestor; the program that wrote the file is wrong");
    const auto& node = source.model.nodes[static_cast<std::size_t>(next.node)];
    const Mat4 matrix = next.matrix * own_matrix(source, node, where);
    name_extensions(report, node, where);
    placed.push_back({next.node, matrix});
    const std::vector<int> last_first(node.children.rbegin(), node.children.rend());
    for (const int child : last_first) open.push_back({child, matrix});
  }
  return placed;
}

void add_instances(Import& import, const std::vector<PlacedNode>& nodes) {
  const auto& source = import.source;
  std::map<int, Mat4> places;
  for (const PlacedNode& placed : nodes) places[placed.node] = placed.matrix;
  Meshes meshes(import);
  for (const PlacedNode& placed : nodes) {
    const auto& node = source.model.nodes[static_cast<std::size_t>(placed.node)];
    if (node.mesh < 0) continue;
    const auto where = node_place(source, placed.node);
    Pose pose;
    pose.weights = morph_weights(source, node, where);
    if (node.skin >= 0) pose.joints = joint_matrices(source, node.skin, places, where);
    const Mat4 matrix = node.skin >= 0 ? Mat4{} : placed.matrix;
    if (!is_affine(matrix) || !inverse(matrix)) {
      import.report.not_understood("nodes that are flattened by a scale of 0, or placed by no finite matrix",
                                   "nothing", where);
      continue;
    }
    const auto mesh = meshes.add(node.mesh, pose);
    if (!mesh) continue;
    const auto& name =
        node.name.empty() ? import.scene.meshes[static_cast<std::size_t>(*mesh)].name : node.name;
    import.scene.instances.push_back({name, *mesh, matrix, {}});
  }
}

}  // namespace orbs::importer
