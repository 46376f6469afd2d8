#pragma once

#include "registry/configuration.h"
#include "results/record.h"

#include <cstddef>
#include <string>

namespace orbs::run {

/// Writes an entry under "expected" in the file of `configuration` for each failure of the run that counts,
/// with `reason`, and leaves every other byte as it is. The new text is read as any configuration before it
/// takes the place of the old one. Then compares `run` with the new entries and writes its results.json anew.
/// Returns the number of entries. InputError when the file cannot take them: it is untouched then.
std::size_t accept_failures(const registry::Configuration& configuration,
                            const std::string& reason,
                            results::RunRecord& run);

}  // namespace orbs::run
