#include "adapters/hydra/remap_lists.h"

#include <map>

#include <fmt/format.h>

namespace orbs::adapters::hydra {

namespace {

using List = std::map<int, int>;  // sorted, as HydraCore3's search is binary

// HydraCore3 searches beyond the end of a list, in those that follow, for a material greater than all in it.
// A last pair of the greatest material with itself, unless the list has one, ends the search in time.
List closed_list(const scene::Instance& instance, int last_material) {
  List list;
  for (const auto& [from, to] : instance.remap) list.emplace(from, to);  // the first of equal ones counts
  list.emplace(last_material, last_material);
  return list;
}

// The size counts numbers, two for each pair.
std::string list_node(const List& list, int position) {
  std::string pairs;
  for (const auto& [from, to] : list) pairs += fmt::format("{}{} {}", pairs.empty() ? "" : " ", from, to);
  return fmt::format("<remap_list id=\"{}\" size=\"{}\" val=\"{}\"/>\n", position, 2 * list.size(), pairs);
}

}  // namespace

RemapLists remap_lists(const scene::Scene& scene, int last_material) {
  RemapLists lists;
  std::map<List, int> positions;
  std::string nodes;
  for (const scene::Instance& instance : scene.instances) {
    if (instance.remap.empty()) {
      lists.of_instances.push_back(-1);
      continue;
    }
    const List list = closed_list(instance, last_material);
    const auto [found, is_new] = positions.try_emplace(list, static_cast<int>(positions.size()));
    if (is_new) nodes += list_node(list, found->second);
    lists.of_instances.push_back(found->second);
  }
  if (!nodes.empty()) lists.text = "<remap_lists>\n" + nodes + "</remap_lists>\n";
  return lists;
}

}  // namespace orbs::adapters::hydra
