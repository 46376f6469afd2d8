#pragma once

#include "json/object_reader.h"

#include <string>

namespace orbs::registry {

/// The text under `key` as a name of a renderer, suite or image. Names become folders of the output and
/// words of lists and tables, so they hold nothing that means something there. InputError else.
std::string plain_name(json::ObjectReader& in, const std::string& key);

}  // namespace orbs::registry
