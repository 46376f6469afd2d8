#include "image/contents.h"

#include "base/error.h"

#include <fmt/format.h>

namespace orbs::image {

void check_size(const StatedSize& size, std::uintmax_t file_bytes) {
  const auto& [stored, whole, channels] = size;
  const auto stated = fmt::format("{} x {} px with {} channels", stored.width, stored.height, channels);
  if (stored.width < 1 || stored.height < 1 || channels < 1)
    throw InputError(fmt::format("the header says {}, which is no image", stated));
  const double values = static_cast<double>(stored.width) * stored.height * channels;
  if (values > kMostValues)
    throw InputError(fmt::format("the header says {}; at most {} values are read", stated,
                                 static_cast<long long>(kMostValues)));
  if (values > kMostValuesPerByte * static_cast<double>(file_bytes))
    throw InputError(
        fmt::format("the header says {}, which is more than {} bytes can hold", stated, file_bytes));
  if (stored.x != whole.x || stored.y != whole.y || stored.width != whole.width ||
      stored.height != whole.height)
    throw InputError(fmt::format(
        "the stored pixels ({} x {} at {}, {}) are not the whole image ({} x {} at {}, {}); "
        "write it without a crop or overscan window",
        stored.width, stored.height, stored.x, stored.y, whole.width, whole.height, whole.x, whole.y));
}

}  // namespace orbs::image
