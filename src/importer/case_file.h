#pragma once

#include "importer/report.h"
#include "scene/scene.h"

#include <filesystem>
#include <string>

namespace orbs::importer {

/// The text of the case.json of an imported scene, "scene.json" beside it. What is not as in the file stands
/// in its "tests", so that who sees the case later knows.
std::string case_text(const scene::Scene& scene,
                      const std::filesystem::path& file,
                      const std::string& requirement,
                      const Report& report);

/// The requirement that an imported scene is listed under, unless the user says another: the highest of those
/// for everyday use that it calls for.
std::string requirement_of(const scene::Scene& scene);

/// A name for a case from that of a file: what stands for something in folders and lists is "_".
std::string case_name(const std::filesystem::path& file);

}  // namespace orbs::importer
