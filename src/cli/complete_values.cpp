#include "cli/complete_values.h"

#include "base/error.h"
#include "cli/options.h"
#include "metrics/table.h"
#include "registry/cases.h"
#include "registry/image_size.h"
#include "studies/stability/images.h"

#include <functional>
#include <map>
#include <set>

namespace orbs::cli {

namespace {

using Names = std::vector<std::string>;

// In the order of the suites; each name once.
Names names_in_cases(const registry::Configuration& configuration,
                     const std::function<Names(const registry::Case&)>& names_of) {
  Names names;
  std::set<std::string> known;
  for (const auto& suite : configuration.suites)
    for (const auto& one_case : registry::load_cases(suite))
      for (const auto& name : names_of(one_case))
        if (known.insert(name).second) names.push_back(name);
  return names;
}

template <class Items>
Names names_of_items(const Items& items) {
  Names names;
  for (const auto& item : items) names.emplace_back(item.name);
  return names;
}

Names configured(const std::string& kind, const registry::Configuration& configuration) {
  if (kind == "suites") return names_of_items(configuration.suites);
  if (kind == "renderers") return names_of_items(configuration.renderers);
  if (kind == "scenes")
    return names_in_cases(configuration,
                          [](const auto& one_case) { return registry::target_names(one_case); });
  if (kind == "cases") return names_in_cases(configuration, [](const auto& one) { return Names{one.name}; });
  return names_in_cases(configuration, [](const auto& one) { return Names{one.requirement}; });
}

}  // namespace

std::string value_kind(const command_line::OptionText& option) {
  static const std::map<std::string, std::string> kKinds{{"suite", "suites"},
                                                         {"renderer", "renderers"},
                                                         {"scene", "scenes"},
                                                         {"case", "cases"},
                                                         {"metric", "metrics"},
                                                         {"relation", "relations"},
                                                         {"requirement", "requirements"}};
  for (const auto& name : option.long_names) {
    // Elsewhere it is a number of pixels.
    if (name == "size" && option.value == "SHARE") return "sizes";
    if (const auto kind = kKinds.find(name); kind != kKinds.end()) return kind->second;
  }
  return "";
}

const std::vector<std::string>& value_kinds() {
  static const Names kAll{"cases",        "metrics", "relations", "renderers",
                          "requirements", "scenes",  "sizes",     "suites"};
  return kAll;
}

std::vector<std::string> values_of_kind(const std::string& kind, const Program& program) {
  if (kind == "metrics") return names_of_items(metrics::kMetrics);
  if (kind == "relations") {
    Names names;
    for (const auto& relation : studies::stability_relations({})) names.emplace_back(relation.of_scenes.name);
    return names;
  }
  if (kind == "sizes") {
    Names sizes;
    for (const auto divisor : registry::kSizeDivisors) sizes.push_back(registry::size_text(divisor));
    return sizes;
  }
  try {
    return configured(kind, read_configuration("", program));
  } catch (const InputError&) {
    return {};
  }
}

}  // namespace orbs::cli
