#include "cli/run/run_end.h"

#include "base/terminal.h"
#include "base/text.h"
#include "base/text_table.h"
#include "report/report_card.h"
#include "report/short_reason.h"
#include "report/table.h"

#include <algorithm>
#include <map>
#include <tuple>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

namespace orbs::cli {

namespace {

// The slowest renders first, with what they took.
std::string durations_text(const results::RunRecord& record, int count) {
  std::vector<const results::JobRecord*> jobs;
  for (const auto& job : record.jobs)
    if (job.end.outcome != results::JobOutcome::Skipped) jobs.push_back(&job);
  std::stable_sort(jobs.begin(), jobs.end(),
                   [](const auto* a, const auto* b) { return a->cost.wall_seconds > b->cost.wall_seconds; });
  if (jobs.size() > static_cast<std::size_t>(count)) jobs.resize(static_cast<std::size_t>(count));
  std::vector<TableRow> rows{{"slowest renders", "", "wall", "CPU", "spp"}};
  for (const auto* job : jobs)
    rows.push_back({job->identity.renderer, job->identity.scene,
                    fmt::format("{:.1f} s", job->cost.wall_seconds),
                    fmt::format("{:.1f} s", job->cost.cpu_seconds), fmt::format("{}", job->identity.spp)});
  return text_table(rows, {}, {terminal_width(STDOUT_FILENO), {}});
}

// "orbs: 3 pass, 1 fail", by state of its targets.
std::string counts_text(const results::RunRecord& record) {
  std::string text;
  for (const auto& renderer : record.renderers) {
    std::map<std::string, int> counts;
    for (const auto& target : record.targets)
      if (target.renderer == renderer.name) ++counts[std::string(results::state_name(target))];
    std::vector<std::string> parts;
    for (const auto& [state, number] : counts) parts.push_back(fmt::format("{} {}", number, state));
    text += fmt::format("{}: {}\n", renderer.name, fmt::join(parts, ", "));
  }
  return text;
}

// "16 to 4096", or "16" of two equal ones.
std::string range_text(int least, int most) {
  return least == most ? std::to_string(least) : fmt::format("{} to {}", least, most);
}

// "orbs: 16 to 4096 samples per pixel in 1 to 9 looks, 61 CPU s; undecided: 1 edge, 2 budget". Nothing for
// fixed samples.
std::string samples_text(const results::RunRecord& record, const std::string& renderer) {
  int least = 0;
  int most = 0;
  int fewest_looks = 0;
  int most_looks = 0;
  double cpu_seconds = 0;
  std::map<std::string, int> undecided;
  for (const auto& job : record.jobs) {
    if (job.identity.renderer != renderer || job.sampling.looks == 0) continue;
    const bool is_first = least == 0;
    least = is_first ? job.identity.spp : std::min(least, job.identity.spp);
    most = std::max(most, job.identity.spp);
    fewest_looks = is_first ? job.sampling.looks : std::min(fewest_looks, job.sampling.looks);
    most_looks = std::max(most_looks, job.sampling.looks);
    cpu_seconds += job.cost.cpu_seconds;
    if (!job.sampling.end.empty() && job.sampling.end != "decided") ++undecided[job.sampling.end];
  }
  if (least == 0) return "";
  auto text =
      fmt::format("{}: {} samples per pixel in {} look{}, {:.0f} CPU s", renderer, range_text(least, most),
                  range_text(fewest_looks, most_looks), most_looks == 1 ? "" : "s", cpu_seconds);
  std::vector<std::string> parts;
  for (const auto& [end, number] : undecided) parts.push_back(fmt::format("{} {}", number, end));
  if (!parts.empty()) text += fmt::format("; undecided: {}", fmt::join(parts, ", "));
  return text + "\n";
}

// "orbs: right on all 48 targets", a line for each renderer: what a reader sees last is the answer.
std::string report_card_text(const results::RunRecord& record) {
  std::string text;
  for (const auto& card : report::report_cards(record))
    text +=
        fmt::format("{}: {}{}{}\n", card.renderer, card.sentence, card.cost ? "; " + card.cost->sentence : "",
                    card.clock.empty() ? "" : "; " + card.clock);
  return text;
}

}  // namespace

bool fails_run(const results::TargetRecord& target) {
  return target.declared && results::counts_as_failure(target.verdict, target.expectation);
}

bool ended_by_failures(const results::RunRecord& record, const registry::RunSettings& settings) {
  const auto failed = std::count_if(record.targets.begin(), record.targets.end(), [](const auto& target) {
    return target.verdict != results::Verdict::Skipped && fails_run(target);
  });
  return record.interrupted && settings.max_fail > 0 && failed >= settings.max_fail;
}

void print_end(const results::RunRecord& record,
               const registry::RunSettings& settings,
               const std::filesystem::path& folder,
               const Program& program) {
  auto style = report::style_for(STDOUT_FILENO);
  style.whole_reasons = settings.verbose;
  if (settings.quiet)
    print_clean("{}results: {}\n", counts_text(record), folder.string());
  else
    print_clean("\n{}\n{:.1f} s in all; results: {}\n", report::summary_text(record, style),
                record.wall_seconds, folder.string());
  if (!settings.quiet)
    for (const auto& renderer : record.renderers) print_clean("{}", samples_text(record, renderer.name));
  const auto is_cut = [&](const auto& target) {
    const auto reason = reason_text(target);
    return report::line_reason(target.verdict, target.expectation, reason, style.width) != reason;
  };
  if (!settings.quiet && !settings.verbose &&
      std::any_of(record.targets.begin(), record.targets.end(), is_cut))
    print_clean("-v prints whole reasons; results.json holds them\n");
  if (settings.durations > 0) print_clean("\n{}", durations_text(record, settings.durations));
  if (results::judged_nothing(record))
    print_clean(stderr, "orbs: nothing was judged: every target is unsupported, for the reasons above\n");
  if (ended_by_failures(record, settings))
    print_clean("ended after {} failed target{} (--maxfail)\n", settings.max_fail,
                settings.max_fail == 1 ? "" : "s");
  if (settings.quiet) return;
  print_clean("\n{}", report_card_text(record));
  const auto relative = folder.lexically_proximate(std::filesystem::current_path()).string();
  const auto orbs = called_as(program.command_line);
  const std::vector<std::string> argv = record.interrupted
                                            ? std::vector<std::string>{orbs, "run", "--resume", relative}
                                            : std::vector<std::string>{orbs, "serve", relative};
  print_clean("next: {}   ({})\n", shell_text(argv),
              record.interrupted ? "continues this run" : "shows the images in the browser");
}

std::string repeats_text(const std::vector<results::RunRecord>& runs, int width) {
  using Key = std::tuple<std::string, std::string, std::string>;
  std::map<Key, std::map<std::string, int>> states;
  for (const auto& run : runs)
    for (const auto& target : run.targets)
      if (target.declared && target.verdict != results::Verdict::Skipped)
        ++states[{target.renderer, target.requirement, target.target}]
                [std::string(results::state_name(target))];
  std::vector<TableRow> rows;
  std::map<std::string, int> steady;
  for (const auto& [key, counts] : states) {
    if (counts.size() == 1) {
      ++steady[counts.begin()->first];
      continue;
    }
    std::vector<std::string> parts;
    for (const auto& [state, number] : counts) parts.push_back(fmt::format("{} {}", number, state));
    const auto& [renderer, requirement, target] = key;
    rows.push_back({"flaky", renderer, requirement, target, fmt::format("{}", fmt::join(parts, ", "))});
  }
  std::vector<std::string> parts;
  for (const auto& [state, number] : steady) parts.push_back(fmt::format("{} {}", number, state));
  return text_table(rows, {}, {width, {}}) +
         fmt::format("{} runs: {} flaky target{}; the same in all: {}\n", runs.size(), rows.size(),
                     rows.size() == 1 ? "" : "s",
                     parts.empty() ? "none" : fmt::format("{}", fmt::join(parts, ", ")));
}

}  // namespace orbs::cli
