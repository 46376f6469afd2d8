#include "registry/slurm.h"

#include <fmt/format.h>

namespace orbs::registry {

SlurmSettings load_slurm(json::ObjectReader in) {
  SlurmSettings settings;
  const auto read = [&](const char* key, std::string& value) {
    if (in.has(key)) value = in.system_text(key);
  };
  read("partition", settings.partition);
  read("account", settings.account);
  read("time", settings.time);
  if (in.has("options")) settings.options = in.system_texts("options");
  for (std::size_t i = 0; i < settings.options.size(); ++i)
    if (!settings.options[i].starts_with("-"))
      in.fail_at(
          "options", i,
          fmt::format("must be an option of sbatch such as --constraint=avx2, is '{}'", settings.options[i]));
  in.finish();
  return settings;
}

}  // namespace orbs::registry
