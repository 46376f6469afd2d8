#include "registry/slurm.h"

#include <fmt/format.h>

namespace orbs::registry {

void check_slurm(json::ObjectReader& in, const SlurmSettings& settings) {
  for (std::size_t i = 0; i < settings.options.size(); ++i)
    if (!settings.options[i].starts_with("-"))
      in.object("slurm").fail_at(
          "options", i,
          fmt::format("must be an option of sbatch such as --constraint=avx2, is '{}'", settings.options[i]));
}

}  // namespace orbs::registry
