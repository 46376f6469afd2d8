#pragma once

#include "cli/program.h"
#include "server/editor.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace orbs::cli {

/// Folders outputs-* of the working folder that hold a run, the newest first. InputError if there is none.
std::vector<std::filesystem::path> newest_runs();

/// The same, with the folders outputs-* and cost-* that hold a cost study.
std::vector<std::filesystem::path> newest_runs_and_studies();

struct ShowSettings {
  std::string address = "127.0.0.1";
  int port = 0;       // 0: any free one
  bool open = false;  // in the browser
  std::optional<server::Editor> editor{};
};

/// Serves runs and cost studies as a page until the user interrupts.
void show_runs(const std::vector<std::filesystem::path>& runs,
               const Program& program,
               const ShowSettings& settings);

}  // namespace orbs::cli
