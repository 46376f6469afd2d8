#pragma once

#include "faults/channels.h"
#include "faults/filters.h"
#include "faults/geometry.h"
#include "faults/shading.h"
#include "faults/values.h"
#include "image/image.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

/// The one catalogue of faulty images: what an image would have been had its renderer made one of the usual
/// mistakes. The mutation tests of the gates, the study of their sensitivity and that of the diagnosis take
/// their rows from it, and the diagnosis tries its kinds upon the reference.
namespace orbs::faults {

/// A kind is a struct of its numbers with apply(image), which changes a linear image with R, G and B and,
/// where it has them, their variances; and with text() where the diagnosis knows it: "shifted by (2, 1) px".
using Fault = std::variant<Factor,
                           Offset,
                           Curve,
                           Clamp,
                           Contrast,
                           Power,
                           Steps,
                           Constant,
                           InvalidPixel,
                           ChannelOrder,
                           ColourMatrix,
                           Alpha,
                           LightPaths,
                           EmittersOnly,
                           NoMisWeight,
                           OtherImage,
                           Shift,
                           Turn,
                           Magnification,
                           Rotation,
                           Crop,
                           Blur,
                           Median,
                           Resolution,
                           Gradient,
                           Vignette,
                           Pattern,
                           Patch,
                           Brightness,
                           Leak>;

/// Which studies put the fault upon their images.
enum class Use {
  Mutation,     // faults that every gate must reject
  Sensitivity,  // faults near the size at which noise begins to hide them
  Diagnosis,    // typical faults, and some that the diagnosis must not name
};

/// AllChannels: a renderer with this fault states the noise of the faulty image. Colours: R, G and B alone
/// have it, as by an error in shading or in the film, and all other channels stay as they are.
enum class Reach { AllChannels, Colours };

struct Row {
  std::string name;
  Fault fault;
  std::vector<Use> uses;
  std::string diagnosis = {};  // how the right diagnosis begins; "" when there is none
  Reach reach = Reach::AllChannels;
};

image::Image applied(const Row& row, const image::Image& image);

/// Whether both are of one kind, whatever their numbers: the two of a kind look alike, or differ in a number
/// alone.
bool is_same_kind(const Fault& a, const Fault& b);

/// All rows. What depends on the image's brightness is decided by `reference`, which is without noise as far
/// as there is one and must outlive the rows. `included` are the pixels that are not masked, all when empty.
std::vector<Row> catalogue(const image::Image& reference, const std::vector<std::uint8_t>& included = {});

/// The rows of one use, in the order of the catalogue.
std::vector<Row> rows_of(Use use,
                         const image::Image& reference,
                         const std::vector<std::uint8_t>& included = {});

}  // namespace orbs::faults
