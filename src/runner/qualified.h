#pragma once

#include "registry/cases.h"
#include "results/qualification.h"

#include <filesystem>
#include <string>
#include <vector>

/// What qualified gates say about a case as it is now.
namespace orbs::runner {

/// Hash of all that an image of the case is judged by: the case's file and the image's references. A
/// missing reference counts as empty.
std::string gate_hash(const registry::Case& one_case,
                      const std::string& target,
                      const std::filesystem::path& references);

/// The smallest errors that the gates of all images of the case see, in words; "" when none was tried.
/// Says so when the case or a reference has changed since.
std::string smallest_error_seen(const registry::Case& one_case,
                                const std::filesystem::path& references,
                                const std::vector<results::GateRecord>& gates);

}  // namespace orbs::runner
