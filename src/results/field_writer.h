#pragma once

#include "json/field_writer.h"

namespace orbs::results {

using json::FieldWriter;
using json::write_fields;
using json::write_record;

}  // namespace orbs::results
