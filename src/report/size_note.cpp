#include "report/size_note.h"

#include <algorithm>

#include <fmt/format.h>

namespace orbs::report {

std::string size_note(const results::RunRecord& run) {
  if (run.size == "1") return "";
  std::ptrdiff_t unmeasured = 0;
  for (const auto& target : run.targets)
    unmeasured += std::count_if(target.checks.begin(), target.checks.end(),
                                [](const auto& check) { return !check.measured; });
  const auto left_out =
      unmeasured == 0 ? "" : fmt::format("; {} checks of single pixels were not measured", unmeasured);
  return fmt::format(
      "Measured at {} of the width and height: the gates judge means, tiles and noise as at full size, but edges "
      "and\ndetail that are finer than a pixel of this size are averaged and not judged{}. --size 1 judges them.\n",
      run.size, left_out);
}

}  // namespace orbs::report
