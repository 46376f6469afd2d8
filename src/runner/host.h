#pragma once

#include "results/host_record.h"

#include <filesystem>

namespace orbs::runner {

/// This machine, as the files of the kernel say it that lie below `root`. Asks nothing of the network.
results::Host this_host(const std::filesystem::path& root = "/");

/// Processes that wanted to run, on average over the last minute; 0 where the system does not say.
double load_average();

}  // namespace orbs::runner
