#pragma once

#include "results/run_folder.h"

#include <cstddef>
#include <string>
#include <vector>

namespace orbs::report {

/// The progress of a run that goes on, as an event of the server.
struct Progress {
  bool is_live = false;
  std::vector<std::string> running = {};  // "cycles 101 (64 samples so far)"
  std::size_t done = 0;
  std::size_t total = 0;
  double seconds_left = 0;  // an estimate; NaN if unknown
};

template <class Visitor, json::RecordOf<Progress> Record>
void fields(Visitor& visit, Record& progress) {
  visit("live", progress.is_live);
  visit("running", progress.running);
  visit("done", progress.done);
  visit("total", progress.total);
  visit.nullable("seconds_left", progress.seconds_left);
}

std::string progress_json(const results::RunView& view);

}  // namespace orbs::report
