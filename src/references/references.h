#pragma once

#include "references/settings.h"
#include "registry/configuration.h"

namespace orbs::references {

/// Renders the references of the scenes that the selection chooses, as good as every case that looks at them
/// needs, and puts each into place when it is complete: those that are missing, and with a reason all of
/// them. A scene that is judged by the reference of another one gets none. Returns 0, or 1 when one is
/// noisier than its gate allows, or 130 when stopped: the next call goes on with the passes that are whole.
/// InputError before anything is rendered when none is missing and no reason is given, or a history is
/// broken; later when another call renders the same one.
int render_references(const registry::Configuration& configuration,
                      const registry::RunSettings& selection,
                      const ReferenceSettings& settings,
                      const ReferenceContext& context);

}  // namespace orbs::references
