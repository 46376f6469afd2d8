#include "metrics/table.h"

#include "base/error.h"
#include "base/text.h"

#include <set>
#include <string>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace orbs::metrics {

const MetricInfo& find_metric(std::string_view name) {
  std::set<std::string> names;
  for (const MetricInfo& metric : kMetrics) {
    if (metric.name == name) return metric;
    names.emplace(metric.name);
  }
  throw InputError(fmt::format("there is no metric '{}'{}; there are {}", name,
                               closest(std::string(name), names), fmt::join(names, ", ")));
}

}  // namespace orbs::metrics
