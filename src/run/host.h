#pragma once

#include "results/host_record.h"

#include <filesystem>

namespace orbs::run {

/// This machine as the kernel's files below `root` describe it. Does not use the network.
results::Host this_host(const std::filesystem::path& root = "/");

/// The number of processes that wanted to run, on average over the last minute; 0 where the system does not
/// say.
double load_average();

}  // namespace orbs::run
