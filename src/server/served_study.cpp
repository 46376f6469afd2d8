#include "server/served_study.h"

#include "results/cost_study.h"
#include "results/stability_study.h"

namespace orbs::server {

ServedStudy::ServedStudy(const std::filesystem::path& folder)
    : named_(std::filesystem::weakly_canonical(folder)),
      is_stability_(results::holds_stability_study(named_)),
      started_(is_stability_ ? results::read_stability_folder(named_).started
                             : results::read_cost_study(named_).started),
      opened_(named_) {}

}  // namespace orbs::server
