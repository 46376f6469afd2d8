#pragma once

#include "json/fields.h"

/// The members of every record of a run are listed in a fields() beside its struct, see json/fields.h: a
/// member that is added there is stored, read and shown on the page.
namespace orbs::results {

using json::Named;
using json::RecordOf;

}  // namespace orbs::results
