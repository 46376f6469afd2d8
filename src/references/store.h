#pragma once

#include "image/image.h"
#include "references/render.h"

#include <filesystem>
#include <map>
#include <string>

namespace orbs::references {

/// Share of each light-path class in the mean radiance (R + G + B) of an image with layers
/// "path.<class>.R/G/B", by class.
std::map<std::string, double> path_shares(const image::Image& image);

/// R, G, B, their variances and Stokes parameters S1 to S3 alone, rounded so that they compress: 9
/// significant bits of a colour or Stokes parameter, 2 of a variance. A colour without variance (black, a
/// light that fills the pixel) is exact and stays unchanged.
image::Image shortened_image(const image::Image& image);

/// Halves, unless they cannot hold what `image` has. Below 2^-14 a half has ever fewer bits, and below 2^-25
/// none: the variances of a dim image would be 0, and it would be exact for whoever judges by it.
image::Precision precision_of(const image::Image& image);

/// Writes the image with its provenance to wanted.target; the provenance of the reference that it replaces is
/// added to the history beside it. The provenance names only the processor of the machine, as it is
/// published.
void store_reference(const RenderedReference& rendered,
                     const WantedReference& wanted,
                     const std::string& reason);

/// The same for an image that follows from a formula: without variances, as 32-bit floats, not shortened. The
/// provenance has kind "analytic", the law and its source instead of samples and seeds, and an infinite
/// noise_psnr_srgb8_db.
void store_analytic_reference(const image::Image& computed,
                              const WantedReference& wanted,
                              const std::string& reason);

/// Adds the pixel hash of every reference that the file of image hashes does not name. Returns how many these
/// are. InputError when one cannot be read.
int note_image_hashes(const std::filesystem::path& references);

}  // namespace orbs::references
