#pragma once

#include "json/field_reader.h"

namespace orbs::results {

using json::check_format;
using json::FieldReader;

}  // namespace orbs::results
