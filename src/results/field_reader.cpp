#include "results/field_reader.h"

namespace orbs::results {

void check_format(json::ObjectReader& in, const std::string& expected) {
  if (const auto format = in.text("format"); format != expected)
    in.fail("format",
            fmt::format("'{}' is not '{}'; was it written by another version of orbs?", format, expected));
}

}  // namespace orbs::results
