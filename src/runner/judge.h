#pragma once

#include "image/image.h"
#include "metrics/compare.h"
#include "metrics/mask.h"
#include "metrics/noise_test.h"
#include "registry/cases.h"
#include "results/record.h"

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace orbs::runner {

/// The reference of an image of the case: its file, or the difference of two. `scene_hashes` holds by scene
/// what the provenance of its reference must say, if it says anything: after a change of the scene its
/// reference is none any more. Nor is one whose pixels are not those that its provenance was made out for.
struct Reference {
  std::filesystem::path file;         // of the scene, or of the difference's `of`
  std::optional<image::Image> image;  // nothing when it is missing
  std::string problem;                // why it is missing
};
Reference load_reference(const registry::Case& one_case,
                         const std::string& image,
                         const std::filesystem::path& references,
                         const std::map<std::string, std::string>& scene_hashes = {});

/// The files that the reference of an image of the case is made from: one, or the two of a difference.
std::vector<std::filesystem::path> reference_files(const registry::Case& one_case,
                                                   const std::string& image,
                                                   const std::filesystem::path& references);

/// Puts the reference of each image of the cases for which load_reference finds one into `folder` as
/// <image>.exr: files of scenes as they are, differences computed. With them the folder of a run can be
/// looked at on its own.
void copy_references(const std::vector<registry::Case>& cases,
                     const std::filesystem::path& references,
                     const std::map<std::string, std::string>& scene_hashes,
                     const std::filesystem::path& folder);

/// All masks of one image of the case.
metrics::Mask mask_of(const registry::Case& one_case, const std::string& image);

/// Every metric, or no more than the verdict rests on, which is the same either way.
enum class Measured { Everything, ForTheVerdict };

struct JudgeSettings {
  int threads = 1;
  Measured measured = Measured::Everything;
  metrics::ResultNoise result_noise = metrics::ResultNoise::AsTheImageSays;
};

/// Compares and fills verdict, reason, measures, checks, remarks and provenance of `record`, whose names are
/// already there. Nothing but the images in memory is looked at. Returns the comparison, for its maps;
/// nothing when there was nothing to compare.
std::optional<metrics::Comparison> judge(const registry::Case& one_case,
                                         const image::Image& result,
                                         const Reference& reference,
                                         const JudgeSettings& settings,
                                         results::TargetRecord& record);

/// Writes result.png and the error maps as error-<name>.exr and .png (with a colour scale) into `folder`;
/// returns the maps, their files relative to `folder`.
std::vector<results::MapRecord> write_maps(const image::Image& result,
                                           const metrics::Comparison& comparison,
                                           const std::filesystem::path& folder);

}  // namespace orbs::runner
