#pragma once

#include "base/process_limits.h"
#include "json/object_reader.h"

namespace orbs::registry {

/// Takes what the object names over into `limits`; the rest stays as it is.
void read_limits(json::ObjectReader in, ProcessLimits& limits);

}  // namespace orbs::registry
