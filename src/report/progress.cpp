#include "report/progress.h"

#include "json/field_writer.h"
#include "json/writer.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace orbs::report {

namespace {

using results::JobState;
using results::RunView;

// An estimate: the remaining renders take as long as the finished ones did on average, and as many run at the
// same time as now. NaN until one is finished.
double seconds_left(const RunView& view) {
  double left = std::nan("");
  double sum = 0;
  int done = 0;
  int open = 0;
  int running = 0;
  for (std::size_t i = 0; i < view.run.jobs.size(); ++i) {
    if (view.states[i] == JobState::Done) {
      sum += view.run.jobs[i].cost.wall_seconds;
      ++done;
    } else {
      ++open;
      if (view.states[i] == JobState::Running) ++running;
    }
  }
  if (done > 0) left = sum / done * open / std::max(1, running);
  return left;
}

// "cycles 101", and how far it is where it is rendered in looks.
std::string text_of(const results::JobRecord& job) {
  auto text = fmt::format("{} {}", job.identity.renderer, job.identity.scene);
  if (goes_on(job)) text += fmt::format(" ({} samples so far)", job.identity.spp);
  return text;
}

}  // namespace

std::string progress_json(const RunView& view) {
  Progress progress{
      .is_live = view.is_live, .total = view.run.jobs.size(), .seconds_left = seconds_left(view)};
  for (std::size_t i = 0; i < view.run.jobs.size(); ++i) {
    if (view.states[i] == JobState::Done) ++progress.done;
    if (view.states[i] == JobState::Running) progress.running.push_back(text_of(view.run.jobs[i]));
  }
  json::Writer out;
  json::write_record(out, progress);
  return out.text();
}

}  // namespace orbs::report
