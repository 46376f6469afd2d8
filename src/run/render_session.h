#pragma once

#include "results/record.h"
#include "run/execute.h"
#include "run/host.h"
#include "run/plan/plan.h"
#include "run/program_hash.h"
#include "run/render_context.h"

#include <cstddef>
#include <filesystem>
#include <mutex>
#include <string>
#include <vector>

/// What the threads of one run share while it renders, and the steps that a job takes: render, judge, put in
/// place. Jobs with fixed samples take each once (render_jobs.cpp), those in looks for each look
/// (render_looks.cpp).
namespace orbs::run {

struct RenderSession {
  const Plan& plan;
  const WorkFolders& folders;
  const RenderContext& context;
  ProgramWatch& programs;
  std::vector<results::JobRecord> at_start{};  // by job: its record before it is rendered
  results::Host host = this_host();
  std::mutex mutex{};  // the callers' functions are called by one thread at a time
  std::size_t done = 0;
};

/// Whether the user wants the run to end.
bool is_stopped(const RenderSession& session);

/// Tells the user about a job.
void say(RenderSession& session, const results::JobRecord& job, const std::string& what);

/// Renders the job at `index`: `job` is that of the plan, or one of its looks.
Execution render_job(RenderSession& session, std::size_t index, const PlannedJob& job);

/// A job that is not rendered, because the run ends: `record` says why. Leaves nothing on disk, so that a
/// resumed run renders it.
JudgedJob skipped_job(const RenderSession& session, std::size_t index, const results::JobRecord& record);

/// Judges the image of a job in its unfinished folder. WriteError on a full disk.
JudgedJob judge_job(RenderSession& session, std::size_t index, Execution execution);

/// Writes job.json into the unfinished folder of a job, and puts that in place.
void place_job(RenderSession& session, std::size_t index, JudgedJob& judged);

/// Compares the verdicts with what is expected, and writes job.json into `folder`.
void write_job(const RenderSession& session, const std::filesystem::path& folder, JudgedJob& judged);

/// Counts a job that is done. `is_news`: the caller's progress is told.
void count_done(RenderSession& session, const JudgedJob& judged, bool is_news);

}  // namespace orbs::run
