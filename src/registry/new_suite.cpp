#include "registry/new_suite.h"

#include "base/files.h"
#include "base/text.h"
#include "json/document.h"
#include "json/locate.h"
#include "json/object_reader.h"
#include "json/writer.h"

namespace orbs::registry {

NewSuite suite_in(const std::filesystem::path& folder, const std::string& name) {
  const auto root = std::filesystem::absolute(folder).lexically_normal();
  const std::string cases = "cases/" + name;
  const std::string references = "references/" + name;
  NewSuite added{{name, root / cases, root / references}, root / "configuration.json", {}};
  std::error_code ignored;
  const bool is_new = !std::filesystem::exists(added.file, ignored);
  added.text = own_text(added.file);
  const auto document = json::parse(added.file.string(), added.text);
  json::ObjectReader in(document);
  for (auto& entry : in.objects_or_none("suites"))
    if (entry.text("name") == name) {
      added.suite.cases = resolve_path(root, entry.text("cases"));
      added.suite.references = resolve_path(root, entry.text("references"));
      return added;
    }
  if (is_new) {
    json::Writer defaults;
    defaults.begin_object().member("suite", name).end_object();
    added.text = json::with_member(added.text, "defaults", trim(defaults.text()));
  }
  json::Writer entry;
  entry.begin_object()
      .member("name", name)
      .member("cases", cases)
      .member("references", references)
      .end_object();
  if (!in.has("suites")) added.text = json::with_member(added.text, "suites", "[]");
  added.text = json::with_element(added.text, "/suites", trim(entry.text()));
  return added;
}

}  // namespace orbs::registry
