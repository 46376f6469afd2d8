#pragma once

#include "references/render.h"
#include "registry/configuration.h"

namespace orbs::references {

/// Renders the references of the scenes that the selection chooses, to the noise that every case which judges
/// them needs, and puts each into place when it is complete: the missing ones, and with a reason all of them.
/// A scene that is judged by the reference of another one gets none. Returns 0, or 1 when a reference is
/// noisier than its gate allows, or 130 when stopped: the next call resumes from the last complete pass.
/// InputError before anything is rendered when none is missing and no reason is given, or a history cannot be
/// read; later when another call renders the same reference.
int render_references(const registry::Configuration& configuration,
                      const registry::RunSettings& selection,
                      const ReferenceSettings& settings,
                      const ReferenceContext& context);

}  // namespace orbs::references
