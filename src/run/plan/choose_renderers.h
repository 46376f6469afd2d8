#pragma once

#include "run/plan/plan.h"

#include <filesystem>
#include <optional>
#include <string>

namespace orbs::run {

/// The renderer's program with its placeholders filled: a path or a name.
std::string program_name(const registry::Renderer& renderer,
                         const std::filesystem::path& root,
                         const std::filesystem::path& build);

/// The renderer's executable on this machine; nothing when it is not installed.
std::optional<std::filesystem::path> installed_executable(const registry::Renderer& renderer,
                                                          const std::filesystem::path& root,
                                                          const std::filesystem::path& build);

/// Fills plan.renderers and plan.left_out from plan.settings.renderers. InputError for a renderer that is
/// named in full and not installed; one that only a pattern matches is left out instead.
void choose_renderers(const registry::Configuration& configuration, Plan& plan);

/// Whether it is orbs's own path tracer.
bool is_built_in(const Plan& plan, const ChosenRenderer& renderer);

/// InputError for a renderer on this machine whose command starts a program that is not there.
void refuse_missing_programs(const Plan& plan);

}  // namespace orbs::run
