#include "report/embedded_images.h"

#include "base/error.h"
#include "base/files_inside.h"
#include "json/writer.h"
#include "report/gzip.h"
#include "report/page_template.h"

#include <set>

#include <fmt/format.h>

namespace orbs::report {

std::string file_of(const std::filesystem::path& folder, const std::string& name) {
  const auto file = open_inside(folder, name);
  if (!file) throw InputError(fmt::format("{}: there is no such file in {}", name, folder.string()));
  return file->read(0, static_cast<std::size_t>(file->size()));
}

EmbeddedImages embed_images(const std::vector<std::string>& files,
                            const std::string& type,
                            const std::function<std::string(const std::string&)>& content,
                            std::size_t most_bytes) {
  EmbeddedImages embedded;
  std::set<std::string> seen;
  std::size_t used = 0;
  json::Writer names;
  names.begin_object();
  for (const auto& file : files) {
    if (file.empty() || !seen.insert(file).second) continue;
    try {
      const auto bytes = base64(content(file));
      if (used + bytes.size() > most_bytes) {
        embedded.left_out.push_back(file);
        continue;
      }
      used += bytes.size();
      const auto id = fmt::format("image-{}", embedded.count++);
      names.member(file, id);
      embedded.elements += data_element(id, type + ";base64", bytes);
    } catch (const InputError& e) {
      embedded.left_out.emplace_back(e.what());
    }
  }
  embedded.elements +=
      data_element("orbs-images", "application/json", script_text(names.end_object().text()));
  return embedded;
}

}  // namespace orbs::report
