#pragma once

#include "registry/case.h"
#include "results/qualification.h"

#include <filesystem>
#include <string>
#include <vector>

/// What the stored qualification of gates says about a case as it is now.
namespace orbs::judge {

/// Hash of all by which the case decides the verdict on an image of the target: its own gates, masks, pixel
/// checks and path shares, whether it allows negative values, and the bytes of the target's references. What
/// the case says in prose is not in it. A missing reference counts as empty.
std::string gate_hash(const registry::Case& one_case,
                      const std::string& target,
                      const std::filesystem::path& references);

/// The smallest errors that the gates of all targets of the case detect, in words; "" when none was tried.
/// States it when the case or a reference has changed since.
std::string smallest_error_seen(const registry::Case& one_case,
                                const std::filesystem::path& references,
                                const std::vector<results::GateRecord>& gates);

}  // namespace orbs::judge
