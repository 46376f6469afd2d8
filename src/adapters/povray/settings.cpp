#include "adapters/povray/settings.h"

namespace orbs::adapters {

namespace {

struct Setting {
  const char* name;
  void (*set)(PovraySettings&, double);
  bool is_whole;
};

const std::vector<Setting>& settings_table() {
  static const std::vector<Setting> kTable{
      {"area_grid", [](PovraySettings& s, double x) { s.area_grid = static_cast<int>(x); }, true},
      {"area_split", [](PovraySettings& s, double x) { s.area_split = static_cast<int>(x); }, true},
      {"area_adaptive", [](PovraySettings& s, double x) { s.area_adaptive = static_cast<int>(x); }, true},
      {"aa_depth", [](PovraySettings& s, double x) { s.aa_depth = static_cast<int>(x); }, true},
      {"photons", [](PovraySettings& s, double x) { s.photons = static_cast<int>(x); }, true},
      {"dispersion_samples", [](PovraySettings& s, double x) { s.dispersion_samples = static_cast<int>(x); },
       true},
      {"radiosity_count", [](PovraySettings& s, double x) { s.radiosity.count = static_cast<int>(x); }, true},
      {"radiosity_error_bound", [](PovraySettings& s, double x) { s.radiosity.error_bound = x; }, false},
  };
  return kTable;
}

}  // namespace

std::vector<SceneSetting> povray_setting_names() {
  std::vector<SceneSetting> names;
  for (const auto& setting : settings_table()) names.push_back({setting.name, setting.is_whole});
  return names;
}

PovraySettings povray_settings(const SceneSettings& numbers) {
  PovraySettings settings;
  for (const auto& setting : settings_table())
    if (const auto number = numbers.find(setting.name); number != numbers.end())
      setting.set(settings, number->second);
  return settings;
}

}  // namespace orbs::adapters
