#include "registry/configuration.h"

#include "base/files.h"
#include "base/text.h"
#include "json/document.h"
#include "json/field_reader.h"
#include "registry/plain_name.h"

#include <algorithm>
#include <set>

#include <fmt/format.h>

namespace orbs::registry {

namespace {

using json::ObjectReader;

Suite suite_of(ObjectReader& in, const SuiteEntry& entry, const std::filesystem::path& root) {
  Suite suite{plain_name(in, "name"), resolve_path(root, entry.cases), resolve_path(root, entry.references)};
  suite.data = {suite.cases, root / "data/common"};
  // A configuration may name the cases of another place, whose common data lies as in this repository.
  if (const auto cases = suite.cases.parent_path(); cases.filename() == "cases")
    suite.data.push_back(cases.parent_path() / "common");
  for (const auto& folder : entry.data) suite.data.push_back(resolve_path(root, folder));
  return suite;
}

// A file over another may name a renderer or suite to change a key of it: with a slip in the name, it is a
// new one that lacks all others.
void refuse_unknown_part(std::vector<ObjectReader> entries,
                         const char* what,
                         const std::vector<std::string>& keys) {
  std::set<std::string> whole;
  for (auto& entry : entries)
    if (entry.has(keys.front())) whole.insert(entry.text_or("name", ""));
  for (auto& entry : entries)
    if (entry.has("name") &&
        std::none_of(keys.begin(), keys.end(), [&](const auto& key) { return entry.has(key); }))
      entry.fail("name", fmt::format("there is no {0} '{1}' to change{2}, and a new one needs '{3}'", what,
                                     entry.text("name"), closest(entry.text("name"), whole), keys.front()));
}

// `names`: of the renderers.
void add_renderers(ObjectReader& in,
                   std::vector<Renderer> added,
                   std::vector<Renderer>& renderers,
                   std::set<std::string>& names) {
  for (std::size_t i = 0; i < added.size(); ++i) {
    if (!names.insert(added[i].name).second) {
      const auto problem = fmt::format("'{}' is the name of an earlier renderer", added[i].name);
      if (added[i].variant_of.empty()) in.fail("name", problem);
      in.objects("variants")[i].fail("name", problem);
    }
    renderers.push_back(std::move(added[i]));
  }
}

}  // namespace

Configuration load_configuration(const ConfigurationFiles& files, const std::optional<EditedFile>& edited) {
  const auto layered = read_layers(files, edited);
  ObjectReader in(layered.document);
  if (files.layers.size() > 1) {
    refuse_unknown_part(in.objects_or_none("suites"), "suite", {"cases", "references"});
    refuse_unknown_part(in.objects_or_none("renderers"), "renderer", {"command", "executable"});
  }
  auto read = json::read_settings<ConfigurationFile>(in);
  Configuration configuration;
  configuration.files = files;
  configuration.file = std::filesystem::absolute(files.layers.back()).lexically_normal();
  configuration.own_file = configuration.file;
  configuration.below = {layered.files.begin(), layered.files.end() - 1};
  configuration.root = layered.root;
  configuration.defaults = read.defaults;
  auto suites = in.objects("suites");
  for (std::size_t i = 0; i < suites.size(); ++i)
    configuration.suites.push_back(suite_of(suites[i], read.suites[i], configuration.root));
  ProcessLimits limits;
  apply(read.limits, limits);
  auto entries = in.objects("renderers");
  std::set<std::string> renderer_names;
  for (std::size_t i = 0; i < entries.size(); ++i)
    add_renderers(entries[i], renderers_of(entries[i], std::move(read.renderers[i]), limits),
                  configuration.renderers, renderer_names);
  std::vector<std::string> suite_names;
  for (const auto& suite : configuration.suites) suite_names.push_back(suite.name);
  check_expected(in, {renderer_names.begin(), renderer_names.end()}, suite_names, read.expected);
  configuration.expected = std::move(read.expected);
  check_slurm(in, read.slurm);
  configuration.slurm = read.slurm;
  return configuration;
}

Configuration load_configuration(const std::filesystem::path& file) {
  return load_configuration(ConfigurationFiles{{file}, {}});
}

Configuration parse_configuration(const std::filesystem::path& file, const std::string& text) {
  return load_configuration({{file}, {}}, EditedFile{file, text});
}

const Suite& find_suite(const Configuration& configuration, const std::string& name) {
  std::set<std::string> names;
  for (const auto& suite : configuration.suites) {
    if (suite.name == name) return suite;
    names.insert(suite.name);
  }
  throw InputError(
      fmt::format("{}: has no suite '{}'{}", configuration.file.string(), name, closest(name, names)));
}

std::optional<std::filesystem::path> nearest_configuration(std::filesystem::path from) {
  for (;;) {
    std::error_code ignored;
    if (std::filesystem::is_regular_file(from / "configuration.json", ignored))
      return from / "configuration.json";
    if (!from.has_relative_path()) return std::nullopt;
    from = from.parent_path();
  }
}

}  // namespace orbs::registry
