#include "judge/reference.h"

#include "base/error.h"
#include "base/files.h"
#include "image/image_io.h"
#include "judge/difference.h"
#include "judge/provenance.h"

#include <algorithm>

#include <fmt/format.h>

namespace orbs::judge {

namespace {

// The file of a scene of the case.
std::filesystem::path reference_file(const registry::Case& one_case,
                                     const std::string& name,
                                     const std::filesystem::path& references) {
  const auto scene = std::find_if(one_case.scenes.begin(), one_case.scenes.end(),
                                  [&](const auto& s) { return s.name == name; });
  return references / ((scene == one_case.scenes.end() ? name : registry::reference_name(*scene)) + ".exr");
}

// Why the provenance record contradicts the image or today's scene; "" when it does not. What the record does
// not state is not checked.
std::string provenance_problem(const image::Image& image,
                               const std::filesystem::path& file,
                               const std::string& scene,
                               const std::map<std::string, std::string>& scene_hashes) {
  const auto provenance = provenance_of(image);
  const auto name = file.stem().string();
  const auto differs = [&](const std::string& what, const std::string& now, const std::string& said) {
    return fmt::format(
        "{}: its hash is now {}, the provenance in {} says {}; 'orbs reference --scene {} --accept \"why "
        "it has changed\"' renders it again",
        what, now, file.string(), said, name);
  };
  const auto scene_said = provenance.find("scene_hash");
  const auto scene_now = scene_hashes.find(scene);
  if (scene_said != provenance.end() && scene_now != scene_hashes.end() &&
      scene_said->second != scene_now->second)
    return differs(fmt::format("scene '{}' has changed since its reference was rendered", name),
                   scene_now->second, scene_said->second);
  const auto image_said = provenance.find("image_hash");
  if (image_said == provenance.end()) return "";
  const auto image_now = image_hash(image);
  return image_now == image_said->second
             ? ""
             : differs("the reference is not the image that was accepted", image_now, image_said->second);
}

// Why there is no usable reference; "" when `image` has been filled.
std::string read_reference(const std::filesystem::path& file,
                           const std::string& scene,
                           const std::map<std::string, std::string>& scene_hashes,
                           std::optional<image::Image>& image) {
  std::error_code ignored;
  if (!std::filesystem::exists(file, ignored))
    return fmt::format("there is no reference {}; 'orbs reference' renders it", file.string());
  std::string problem;
  try {
    image = image::read_image(file);
    image::select_rgb(*image, "");
    problem = provenance_problem(*image, file, scene, scene_hashes);
  } catch (const InputError& e) {
    problem = fmt::format("the reference cannot be used: {}", e.what());
  }
  if (!problem.empty()) image.reset();
  return problem;
}

}  // namespace

std::vector<std::filesystem::path> reference_files(const registry::Case& one_case,
                                                   const std::string& target,
                                                   const std::filesystem::path& references) {
  for (const auto& difference : one_case.differences)
    if (difference.name == target)
      return {reference_file(one_case, difference.of, references),
              reference_file(one_case, difference.minus, references)};
  return {reference_file(one_case, target, references)};
}

Reference load_reference(const registry::Case& one_case,
                         const std::string& target,
                         const std::filesystem::path& references,
                         const std::map<std::string, std::string>& scene_hashes) {
  Reference reference;
  const auto difference = std::find_if(one_case.differences.begin(), one_case.differences.end(),
                                       [&](const auto& d) { return d.name == target; });
  const bool is_difference = difference != one_case.differences.end();
  const auto& scene = is_difference ? difference->of : target;
  reference.file = reference_file(one_case, scene, references);
  reference.problem = read_reference(reference.file, scene, scene_hashes, reference.image);
  if (!is_difference || !reference.image) return reference;
  std::optional<image::Image> minus;
  reference.problem = read_reference(reference_file(one_case, difference->minus, references),
                                     difference->minus, scene_hashes, minus);
  if (minus && (minus->width != reference.image->width || minus->height != reference.image->height))
    reference.problem =
        fmt::format("the references of '{}' and '{}' differ in size", difference->of, difference->minus);
  if (reference.problem.empty()) {
    reference.image = difference_of(*reference.image, *minus);
  } else {
    reference.image.reset();
  }
  return reference;
}

void copy_references(const std::vector<registry::Case>& cases,
                     const std::filesystem::path& references,
                     const std::map<std::string, std::string>& scene_hashes,
                     const std::filesystem::path& folder) {
  std::error_code ignored;
  std::filesystem::create_directories(folder, ignored);
  for (const auto& one_case : cases)
    for (const auto& name : registry::target_names(one_case)) {
      const auto reference = load_reference(one_case, name, references, scene_hashes);
      if (!reference.image) continue;
      const auto copy = folder / (name + ".exr");
      if (reference_files(one_case, name, references).size() == 1) {
        write_file(copy, read_file(reference.file));
      } else {
        image::write_exr(*reference.image, copy);
      }
    }
}

}  // namespace orbs::judge
