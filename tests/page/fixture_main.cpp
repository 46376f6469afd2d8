// Makes the runs that the browser tests look at:
//   orbs-page-fixture small|before|many|huge <folder>   a finished run
//   orbs-page-fixture cost <folder>                      a cost study
//   orbs-page-fixture cost-later <folder>                the same study a day later
//   orbs-page-fixture stability <folder>                 a study of stability
//   orbs-page-fixture looks <folder>                     a run whose renders are made in looks
//   orbs-page-fixture live-looks <folder>                a live run: each line on stdin is a look at its
//   first render orbs-page-fixture live <folder>                      a live run: each line on stdin
//   completes a
//                                                        render, the end of stdin the run
#include "base/error.h"
#include "page/fixture_cost.h"
#include "page/fixture_looks.h"
#include "page/fixture_runs.h"
#include "page/fixture_stability.h"

#include <cstdio>
#include <string_view>

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  const std::string_view what = argv[1];
  const std::filesystem::path folder = argv[2];
  std::filesystem::create_directories(folder);
  using namespace orbs::page_tests;
  try {
    if (what == "small") write_small_run(folder);
    if (what == "before") write_earlier_run(folder);
    if (what == "many") write_run_of_many_cells(folder);
    if (what == "huge") write_run_of_huge_images(folder);
    if (what == "cost") write_cost_study(folder);
    if (what == "cost-later") write_later_cost_study(folder);
    if (what == "stability") write_stability_study(folder);
    if (what == "looks") write_run_of_looks(folder);
    if (what == "live-looks") play_live_looks(folder);
    if (what == "live") play_live_run(folder);
  } catch (const orbs::InputError& e) {
    std::fputs(e.what(), stderr);
    return 2;
  }
  return 0;
}
