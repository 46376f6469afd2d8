#include "judge/reference.h"

#include "base/error.h"
#include "base/files.h"
#include "image/image_io.h"
#include "judge/difference.h"
#include "judge/noise.h"
#include "judge/provenance.h"
#include "results/image_hashes.h"

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

// Why the provenance record, or the file of image hashes, contradicts the image or today's scene; "" when
// neither does. What they do not state is not checked.
std::string provenance_problem(const image::Image& image,
                               const std::filesystem::path& file,
                               const std::string& scene,
                               const std::map<std::string, std::string>& scene_hashes,
                               const std::map<std::string, std::string>& image_hashes) {
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
  const auto listed = image_hashes.find(name);
  if (image_said == provenance.end() && listed == image_hashes.end()) return "";
  const auto image_now = image_hash(image);
  const std::string problem = "the reference is not the image that was accepted";
  if (image_said != provenance.end() && image_now != image_said->second)
    return differs(problem, image_now, image_said->second);
  if (listed == image_hashes.end() || image_now == listed->second) return "";
  return fmt::format(
      "{}: its hash is now {}, {} says {}; 'orbs reference --scene {} --accept \"why it has changed\"' renders "
      "it again",
      problem, image_now, (file.parent_path() / results::kImageHashesFile).string(), listed->second, name);
}

// Whoever can write into the folder of the run, such as a renderer, could change what it is judged by.
image::Image read_copy(const std::filesystem::path& original,
                       const std::filesystem::path& copy,
                       const std::string& hash) {
  const auto bytes = read_file(copy);
  if (const auto now = hash_text(content_hash(bytes)); now != hash)
    throw InputError(
        fmt::format("{}: this copy has changed since the run started: its hash is now {}, it was {}; "
                    "'orbs run --resume' copies the reference again",
                    copy.string(), now, hash));
  return image::read_exr(original.string(), bytes);
}

// Why there is no usable reference; "" when `image` has been filled.
std::string read_reference(const std::filesystem::path& file,
                           const std::string& scene,
                           const std::map<std::string, std::string>& scene_hashes,
                           const ReferenceCopies& copies,
                           const registry::ReducedSize& size,
                           std::optional<image::Image>& image) {
  std::error_code ignored;
  const auto copied = copies.copied.find(file.filename().string());
  if (copies.folder.empty() ? !std::filesystem::exists(file, ignored) : copied == copies.copied.end())
    return fmt::format("there is no reference {}; 'orbs reference' renders it", file.string());
  if (!copies.folder.empty() && !copied->second.problem.empty()) return copied->second.problem;
  std::string problem;
  try {
    image = copies.folder.empty() ? image::read_image(file)
                                  : read_copy(file, copies.folder / file.filename(), copied->second.hash);
    image::select_rgb(*image, "");
    problem = provenance_problem(
        *image, file, scene, scene_hashes,
        copies.folder.empty() ? results::read_image_hashes(file.parent_path()) : copies.image_hashes);
    if (problem.empty() && copies.folder.empty())
      image = reduced_reference(*image, registry::divisor_of_image(image->width, image->height, size));
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
                         const std::map<std::string, std::string>& scene_hashes,
                         const ReferenceCopies& copies,
                         const registry::ReducedSize& size) {
  Reference reference;
  if (const auto why = registry::no_reference_reason(one_case, target); !why.empty())
    return {{}, std::nullopt, fmt::format("'{}' has no reference: {}", target, why)};
  const auto difference = std::find_if(one_case.differences.begin(), one_case.differences.end(),
                                       [&](const auto& d) { return d.name == target; });
  const bool is_difference = difference != one_case.differences.end();
  const auto& scene = is_difference ? difference->of : target;
  reference.file = reference_file(one_case, scene, references);
  reference.problem = read_reference(reference.file, scene, scene_hashes, copies, size, reference.image);
  if (!is_difference || !reference.image) return reference;
  std::optional<image::Image> minus;
  reference.problem = read_reference(reference_file(one_case, difference->minus, references),
                                     difference->minus, scene_hashes, copies, size, minus);
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

namespace {

CopiedReference copy_reference(const std::filesystem::path& file,
                               const std::string& scene,
                               const std::map<std::string, std::string>& scene_hashes,
                               const std::map<std::string, std::string>& image_hashes,
                               const std::filesystem::path& folder,
                               const registry::ReducedSize& size) {
  CopiedReference copied;
  std::optional<image::Image> image;
  if (size.divisor != 1) {
    copied.problem = read_reference(file, scene, scene_hashes, {}, size, image);
    if (!copied.problem.empty()) return copied;
    image::write_exr(*image, folder / file.filename());
    copied.hash = hash_text(content_hash(read_file(folder / file.filename())));
    return copied;
  }
  try {
    const auto bytes = read_file(file);
    copied.hash = hash_text(content_hash(bytes));
    write_file(folder / file.filename(), bytes);
  } catch (const WriteError&) {
    throw;
  } catch (const InputError& e) {
    copied.problem = fmt::format("the reference cannot be used: {}", e.what());
    return copied;
  }
  copied.problem = read_reference(file, scene, scene_hashes,
                                  {folder, {{file.filename().string(), copied}}, image_hashes}, size, image);
  std::error_code ignored;
  if (!copied.problem.empty()) std::filesystem::remove(folder / file.filename(), ignored);
  return copied;
}

}  // namespace

ReferenceCopies copy_references(const std::vector<registry::Case>& cases,
                                const std::filesystem::path& references,
                                const std::map<std::string, std::string>& scene_hashes,
                                const std::filesystem::path& folder,
                                const registry::ReducedSize& size) {
  ReferenceCopies copies{folder, {}, {}};
  // A reduced copy has other pixels; its original is checked when it is read.
  if (size.divisor == 1) copies.image_hashes = results::read_image_hashes(references);
  make_folder(folder);
  std::error_code ignored;
  for (const auto& one_case : cases)
    for (const auto& scene : one_case.scenes) {
      const auto file = reference_file(one_case, scene.name, references);
      const auto name = file.filename().string();
      if (!copies.copied.contains(name) && std::filesystem::exists(file, ignored))
        copies.copied[name] =
            copy_reference(file, scene.name, scene_hashes, copies.image_hashes, folder, size);
    }
  for (const auto& one_case : cases)
    for (const auto& target : registry::target_names(one_case)) {
      const auto copy = folder / (target + ".exr");
      if (copies.copied.contains(copy.filename().string())) continue;
      const auto reference = load_reference(one_case, target, references, scene_hashes, copies);
      if (!reference.image) continue;
      if (reference_files(one_case, target, references).size() == 1) {
        write_file(copy, read_file(folder / reference.file.filename()));
      } else {
        image::write_exr(*reference.image, copy);
      }
    }
  return copies;
}

image::Image reduced_reference(const image::Image& reference, int divisor) {
  if (divisor == 1) return reference;
  auto reduced = image::reduced_image(reference, divisor);
  auto& attributes = reduced.attributes;
  attributes["orbs.averaged_over"] = fmt::format("{0} x {0} px", divisor);
  if (const auto hash = attributes.find("orbs.image_hash"); hash != attributes.end())
    hash->second = image_hash(reduced);
  if (const auto noise = attributes.find("orbs.noise_psnr_srgb8_db"); noise != attributes.end())
    if (const auto mse = noise_mse_srgb8(reduced, reduced))
      noise->second = fmt::format("{:.2f}", psnr_srgb8_of(*mse));
  return reduced;
}

}  // namespace orbs::judge
