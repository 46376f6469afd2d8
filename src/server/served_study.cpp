#include "server/served_study.h"

#include "results/cost_study.h"

namespace orbs::server {

ServedStudy::ServedStudy(const std::filesystem::path& folder)
    : named_(std::filesystem::weakly_canonical(folder)),
      started_(results::read_cost_study(named_).started),
      opened_(named_) {}

}  // namespace orbs::server
