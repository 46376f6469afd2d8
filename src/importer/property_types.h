#pragma once

#include "json/document.h"

namespace orbs::importer {

/// Refuses, with its place, a property that the importer reads and whose value is of another type or length
/// than glTF 2.0 says: the library takes such a value, and all that follows in its object, as if it were not
/// there. InputError.
void check_property_types(const json::Document& document);

}  // namespace orbs::importer
