#pragma once

#include <filesystem>
#include <string>

namespace orbs::tracer {

/// What a shared library lacks of what its headers say that it holds, as one whose copy broke off: the loader
/// maps such a file without a complaint, and its first access beyond the end is a bus error. "" when nothing
/// is missing, and for a file of another kind, which the loader refuses itself.
std::string missing_part(const std::filesystem::path& library);

}  // namespace orbs::tracer
