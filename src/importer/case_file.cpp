#include "importer/case_file.h"

#include "json/writer.h"

#include <algorithm>
#include <cctype>

#include <fmt/format.h>

namespace orbs::importer {

std::string case_text(const scene::Scene& scene,
                      const std::filesystem::path& file,
                      const std::string& requirement,
                      const Report& report) {
  std::string tests = fmt::format("A scene of one's own, imported from {}.", file.filename().string());
  for (const auto& sentence : report.choices()) tests += " " + sentence;
  const auto remarks = report.remarks();
  for (std::size_t i = 0; i < remarks.size(); ++i)
    tests += fmt::format("{} {}: {}{}", i == 0 ? " Not as in the file:" : "", remarks[i].what,
                         remarks[i].instead, i + 1 < remarks.size() ? ";" : ".");
  json::Writer out;
  out.begin_object().member("format", "orbs-case/2").member("requirement", requirement);
  out.member("title", scene.name).member("tests", tests);
  out.member("typical_mistake", "Not known yet: say here what the trouble is.");
  out.key("scenes").begin_array().begin_object();
  out.member("name", scene.name).member("file", "scene.json").member("spp", 64);
  out.end_object().end_array().end_object();
  return out.text();
}

std::string requirement_of(const scene::Scene& scene) {
  const bool is_everyday = std::any_of(
      scene.materials.begin(), scene.materials.end(),
      [](const auto& material) { return std::holds_alternative<scene::MetallicRoughness>(material.model); });
  return is_everyday ? "B7" : "G4";
}

std::string case_name(const std::filesystem::path& file) {
  std::string name = file.stem().string();
  for (char& letter : name)
    if (std::isalnum(static_cast<unsigned char>(letter)) == 0 && letter != '-') letter = '_';
  return name.empty() ? "scene" : name;
}

}  // namespace orbs::importer
