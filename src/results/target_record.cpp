#include "results/target_record.h"

namespace orbs::results {

std::string reason_text(const TargetRecord& target) {
  if (target.expected.empty() || target.reason.empty()) return target.expected + target.reason;
  return target.expected + "; " + target.reason;
}

}  // namespace orbs::results
