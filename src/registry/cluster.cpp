#include "registry/cluster.h"

#include "base/error.h"
#include "base/text.h"

#include <fmt/format.h>

namespace orbs::registry {

Shard parse_shard(const std::string& text) {
  constexpr long long kMost = 100'000;
  const auto parts = split(text, '/');
  const bool is_pair = parts.size() == 2;
  const long long index = is_pair ? to_integer(parts[0]).value_or(0) : 0;
  const long long count = is_pair ? to_integer(parts[1]).value_or(0) : 0;
  if (index < 1 || count < index || count > kMost)
    throw InputError(
        fmt::format("'{}' is no part of a run; write such as 3/16 for the third of sixteen", text));
  return {static_cast<int>(index), static_cast<int>(count)};
}

std::string shard_text(const Shard& shard) { return fmt::format("{}/{}", shard.index, shard.count); }

void check_slurm(json::ObjectReader& in, const SlurmSettings& settings) {
  for (std::size_t i = 0; i < settings.options.size(); ++i)
    if (!settings.options[i].starts_with("-"))
      in.object("slurm").fail_at(
          "options", i,
          fmt::format("must be an option of sbatch such as --constraint=avx2, is '{}'", settings.options[i]));
}

}  // namespace orbs::registry
