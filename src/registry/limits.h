#pragma once

#include "json/object_reader.h"
#include "supervisor/limits.h"

namespace orbs::registry {

/// Takes what the object names over into `limits`; the rest stays as it is.
void read_limits(json::ObjectReader in, supervisor::Limits& limits);

}  // namespace orbs::registry
