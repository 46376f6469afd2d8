#pragma once

#include "adapters/exporter.h"

#include <set>

namespace orbs::adapters {

/// All exporters. To add one: its folder, and its line in this table.
const std::vector<Exporter>& exporters();

/// The exporter of that format; nullptr when there is none.
const Exporter* find_exporter(const std::string& format);

/// The words that "scene_format" of configuration.json may hold: those of the exporters, and "native".
std::set<std::string> scene_formats();

}  // namespace orbs::adapters
