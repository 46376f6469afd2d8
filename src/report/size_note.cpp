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
      unmeasured == 0
          ? ""
          : fmt::format("Not measured: {}, smaller than such a pixel. ",
                        unmeasured == 1 ? "1 pixel check" : fmt::format("{} pixel checks", unmeasured));
  return fmt::format(
      "Measured at {} of the width and height: means, tiles and noise are judged as at full size. Edges and detail\n"
      "finer than a pixel of this size are averaged out and not judged.\n"
      "{}--size 1 judges everything.\n",
      run.size, left_out);
}

}  // namespace orbs::report
