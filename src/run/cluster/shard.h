#pragma once

#include "registry/cluster.h"
#include "run/plan/plan.h"
#include "run/run_file.h"

#include <vector>

namespace orbs::run {

/// How many shards can have something to render.
int shard_count(const Plan& plan);

/// The shard of each job, from 1 to `count`: jobs of one difference of scenes stay together, and such groups
/// go to the shards longest first, each to the shard that has least to do so far: by that rule no schedule
/// takes more than 4/3 of the least possible time (Graham 1969, Bounds on multiprocessing timing anomalies).
/// How long a render takes, the plan says. Shard 1 has most to do.
std::vector<int> shards_of_jobs(const Plan& plan, int count);

/// Leaves in the plan the jobs of one shard and the targets that are judged from them, each in one shard.
/// Targets that are not rendered belong to the first shard. InputError if no job is left.
void take_shard(const registry::Shard& shard, Plan& plan);

/// Leaves in the plan these targets alone, as far as it has them, and what is rendered for them. It is
/// another plan then, with an id of its own.
void take_targets(const std::vector<OnlyTarget>& only, Plan& plan);

}  // namespace orbs::run
