#pragma once

#include "command_line/command.h"

#include <string>

namespace orbs::command_line {

/// The manual page, in troff, of a program with its commands or, without any, its options. `summary`: what
/// stands behind its name in lists of manual pages.
std::string manual_page(const Command& program,
                        const std::string& name,
                        const std::string& summary,
                        const std::string& version);

}  // namespace orbs::command_line
