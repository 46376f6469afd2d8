#pragma once

#include "image/image.h"
#include "registry/case.h"
#include "registry/image_size.h"

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace orbs::judge {

/// The reference of a target: an image file, or the difference of two.
struct Reference {
  std::filesystem::path file;         // of the scene, or of the difference's `of`
  std::optional<image::Image> image;  // nothing when it is missing
  std::string problem;                // why it is missing
};

/// A reference file as it was when it was copied.
struct CopiedReference {
  std::string hash;     // hash_text of its bytes; "" when it could not be read
  std::string problem;  // why it is no usable reference, in which case there is no copy; "" when it is one
};

/// Copies that a run makes of its references when it starts: it is judged by them, whatever becomes of the
/// originals meanwhile.
struct ReferenceCopies {
  std::filesystem::path folder;                       // "": there are no copies, the originals are read
  std::map<std::string, CopiedReference> copied;      // by file name
  std::map<std::string, std::string> image_hashes{};  // of the file beside the originals, see results
};

/// Reads the reference of a target of the case from the folder `references`, or from its copy if there are
/// copies; messages name the original. A reference is stale, and so missing, if the scene hash or its own
/// pixel hash differs from its provenance record, and a copy if its bytes are no longer those that were
/// copied. `scene_hashes` holds by scene today's hash; a scene that is not in it is not checked. An original
/// is averaged for images of that size once it is checked, see reduced_reference; copies are averaged
/// already.
Reference load_reference(const registry::Case& one_case,
                         const std::string& target,
                         const std::filesystem::path& references,
                         const std::map<std::string, std::string>& scene_hashes = {},
                         const ReferenceCopies& copies = {},
                         const registry::ReducedSize& size = {});

/// The files that the reference of a target is made from: one, or the two of a difference.
std::vector<std::filesystem::path> reference_files(const registry::Case& one_case,
                                                   const std::string& target,
                                                   const std::filesystem::path& references);

/// Copies the reference files of all targets of the cases into `folder`, except unusable ones: for images of
/// a reduced size, averages of them, see reduced_reference. Adds for each
/// target that has a reference <target>.exr: with them the folder of a run can be looked at on its own.
/// WriteError when the disk refuses.
ReferenceCopies copy_references(const std::vector<registry::Case>& cases,
                                const std::filesystem::path& references,
                                const std::map<std::string, std::string>& scene_hashes,
                                const std::filesystem::path& folder,
                                const registry::ReducedSize& size = {});

/// The reference for images of 1/divisor of the width and height, see image::reduced_image. Its provenance
/// record gets "averaged_over", and the hash of its own pixels and its own noise in place of those of the
/// full size. The hash of the scene stays: the reference is current or stale as the full one is. InputError
/// when the size cannot be divided.
image::Image reduced_reference(const image::Image& reference, int divisor);

}  // namespace orbs::judge
