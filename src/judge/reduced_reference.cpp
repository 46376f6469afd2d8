#include "judge/reduced_reference.h"

#include "image/image.h"
#include "judge/noise.h"
#include "judge/provenance.h"

#include <fmt/format.h>

namespace orbs::judge {

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
