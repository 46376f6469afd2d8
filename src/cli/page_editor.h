#pragma once

#include "registry/configuration.h"
#include "server/editor.h"

namespace orbs::cli {

/// Lets the page write what `orbs run --accept-failures` would write into the user's own file of this
/// configuration.
server::Editor page_editor(const registry::Configuration& configuration);

}  // namespace orbs::cli
