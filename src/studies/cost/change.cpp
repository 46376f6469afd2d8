#include "studies/cost/change.h"

#include "base/error.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include <fmt/format.h>

namespace orbs::studies {

namespace {

// The places of a renderer or target in the earlier and the later study.
struct Places {
  std::size_t before = 0, after = 0;
};

template <class Named>
std::vector<Places> in_both(const std::vector<Named>& before, const std::vector<Named>& after) {
  std::vector<Places> places;
  for (std::size_t i = 0; i < after.size(); ++i) {
    const auto same = std::find_if(before.begin(), before.end(),
                                   [&](const Named& one) { return one.name == after[i].name; });
    if (same != before.end()) places.push_back({static_cast<std::size_t>(same - before.begin()), i});
  }
  return places;
}

// The noise of a reference follows from its samples: another noise is another reference.
bool is_same_reference(const CostTarget& a, const CostTarget& b) {
  return a.reference_noise.relmse == b.reference_noise.relmse &&
         a.reference_noise.mse == b.reference_noise.mse && a.width_px == b.width_px &&
         a.height_px == b.height_px;
}

void check_comparable(const CostRecord& before, const CostRecord& after) {
  if (before.suite != after.suite || before.size != after.size)
    throw InputError(fmt::format(
        "one study is of suite {} at size {}, the other of suite {} at size {}: only studies of the same suite and "
        "size can be compared",
        before.suite, before.size, after.suite, after.size));
  const auto there = results::timing_machine(before.host);
  const auto here = results::timing_machine(after.host);
  if (there != here)
    throw InputError(fmt::format(
        "the studies were made on different machines ({} and {}), so their times cannot be compared",
        there.empty() ? "unknown" : there, here.empty() ? "unknown" : here));
}

const CostCurve* curve_of(const CostNumbers& numbers, std::size_t target, std::size_t renderer) {
  const auto found = std::find_if(numbers.curves.begin(), numbers.curves.end(), [&](const CostCurve& curve) {
    return curve.target == target && curve.renderer == renderer;
  });
  return found == numbers.curves.end() ? nullptr : &*found;
}

double chance_of(const LogRatio& log) {
  if (!(log.variance > 0)) return log.value == 0 ? 1 : 0;
  return student_tail(log.value / std::sqrt(log.variance), std::max(1.0, log.degrees));
}

// A renderer whose times are single renders has no noise to be tested by.
bool has_noise(const TimeToError& time) { return time.log_error > 0; }

// Marks what is beyond chance by Holm's procedure (1979): the smallest probability is tested at level / n,
// the next at level / (n - 1), until one fails.
template <class Change>
void mark_changed(std::vector<Change*> tests, double level) {
  std::sort(tests.begin(), tests.end(),
            [](const Change* a, const Change* b) { return a->by_chance < b->by_chance; });
  for (std::size_t i = 0; i < tests.size(); ++i) {
    if (tests[i]->by_chance > level / static_cast<double>(tests.size() - i)) return;
    tests[i]->is_changed = true;
  }
}

using Logs = std::map<std::pair<std::size_t, std::size_t>, std::vector<LogRatio>>;  // by error and renderer

struct Studies {
  const CostRecord& before;
  const CostRecord& after;
  CostNumbers numbers_before, numbers_after;
};

void compare_target(
    const Studies& studies, Places target, Places renderer, std::size_t own, CostChanges& out, Logs& logs) {
  const auto* earlier = curve_of(studies.numbers_before, target.before, renderer.before);
  const auto* later = curve_of(studies.numbers_after, target.after, renderer.after);
  if (earlier == nullptr || later == nullptr) return;
  for (std::size_t error = 0; error < error_targets().size(); ++error) {
    const auto& from = earlier->times_to_error.at(error);
    const auto& to = later->times_to_error.at(error);
    if (!from.cpu_seconds || !to.cpu_seconds || !has_noise(from) || !has_noise(to)) continue;
    const auto log = log_ratio_of(from, to);
    logs[{error, own}].push_back(log);
    out.scenes.push_back({studies.after.targets[target.after].name,
                          studies.after.renderers[renderer.after].name, error_targets()[error],
                          *from.cpu_seconds, *to.cpu_seconds, ratio_interval(log), chance_of(log)});
  }
}

// The factor of the machine at one error, by the renderers that did not change.
std::optional<LogRatio> unchanged_log(const CostChanges& changes, const Logs& logs, std::size_t error) {
  std::vector<LogRatio> own;
  for (std::size_t renderer = 0; renderer < changes.renderers.size(); ++renderer)
    if (const auto found = logs.find({error, renderer});
        changes.renderers[renderer].is_unchanged && found != logs.end())
      own.insert(own.end(), found->second.begin(), found->second.end());
  if (own.empty()) return std::nullopt;
  return mean_over(own);
}

void add_means(const Logs& logs, CostChanges& out) {
  for (const auto& [key, own] : logs) {
    const auto& [error, renderer] = key;
    const auto mean = mean_over(own);
    MeanChange change{out.renderers[renderer].name,
                      error_targets()[error],
                      static_cast<int>(own.size()),
                      ratio_interval(mean),
                      chance_of(mean),
                      false,
                      {}};
    const auto machine = unchanged_log(out, logs, error);
    if (machine && !out.renderers[renderer].is_unchanged)
      change.ratio_to_unchanged =
          ratio_interval(sum_of({mean, {-machine->value, machine->variance, machine->degrees}}));
    out.means.push_back(change);
  }
}

// The tests of renderers as a whole share one half of the level, those of single scenes the other.
void test_all(CostChanges& out) {
  for (const auto& error : error_targets()) {
    std::vector<MeanChange*> means;
    std::vector<SceneChange*> scenes;
    for (auto& one : out.means)
      if (one.error == error) means.push_back(&one);
    for (auto& one : out.scenes)
      if (one.error == error) scenes.push_back(&one);
    mark_changed(std::move(means), kFalseChanges / 2);
    mark_changed(std::move(scenes), kFalseChanges / 2);
  }
  const auto rank = [](const SceneChange& one) {
    return std::tuple(one.error.metric, one.error.level, -std::fabs(std::log(one.time_ratio.value)));
  };
  std::stable_sort(out.scenes.begin(), out.scenes.end(),
                   [&](const SceneChange& a, const SceneChange& b) { return rank(a) < rank(b); });
}

void note_doubts(const CostRecord& record, const CostNumbers& numbers, const char* which, CostChanges& out) {
  const auto& self = numbers.self_comparison;
  if (!self)
    out.notes.push_back(fmt::format(
        "the {} study did not compare a renderer with itself: it does not tell whether the machine was steady",
        which));
  else if (!self->passed)
    out.notes.push_back(fmt::format(
        "in the {} study a renderer differs from itself, so the machine was not steady: do not trust its times",
        which));
  if (!record.is_finished) out.notes.push_back(fmt::format("the {} study was interrupted", which));
}

void note_absent(const CostRecord& has, const CostRecord& lacks, const char* which, CostChanges& out) {
  const auto note = [&](const auto& all, const auto& others, const char* what) {
    for (const auto& one : all)
      if (std::none_of(others.begin(), others.end(),
                       [&](const auto& other) { return other.name == one.name; }))
        out.notes.push_back(fmt::format("only the {} study has the {} {}", which, what, one.name));
  };
  note(has.renderers, lacks.renderers, "renderer");
  note(has.targets, lacks.targets, "target");
}

}  // namespace

CostChanges cost_changes(const CostRecord& before, const CostRecord& after) {
  check_comparable(before, after);
  const Studies studies{before, after, cost_numbers(before), cost_numbers(after)};
  CostChanges out;
  out.before = before.started;
  out.after = after.started;
  out.main_error = error_targets().at(main_error(after));
  note_doubts(before, studies.numbers_before, "earlier", out);
  note_doubts(after, studies.numbers_after, "later", out);
  if (before.settings.threads != after.settings.threads)
    out.notes.push_back(fmt::format("renders had {} threads in the earlier study and {} in the later one",
                                    before.settings.threads, after.settings.threads));
  const auto renderers = in_both(before.renderers, after.renderers);
  for (const auto& at : renderers) {
    const auto& from = before.renderers[at.before].version;
    const auto& to = after.renderers[at.after].version;
    out.renderers.push_back({after.renderers[at.after].name, from, to, !from.empty() && from == to});
  }
  Logs logs;
  const auto targets = in_both(before.targets, after.targets);
  for (const auto& target : targets) {
    if (!is_same_reference(before.targets[target.before], after.targets[target.after])) {
      out.notes.push_back(fmt::format("the reference of {} is another one: its times are not compared",
                                      after.targets[target.after].name));
      continue;
    }
    for (std::size_t own = 0; own < renderers.size(); ++own)
      compare_target(studies, target, renderers[own], own, out, logs);
  }
  if (renderers.empty() || targets.empty())
    throw InputError(
        "the studies have no renderer on the same target: there is nothing to compare; 'orbs cost --show' "
        "prints what each holds");
  note_absent(before, after, "earlier", out);
  note_absent(after, before, "later", out);
  add_means(logs, out);
  test_all(out);
  return out;
}

int exit_status(const CostChanges& changes) {
  const auto is_slower = [&](const auto& one) {
    return one.error == changes.main_error && one.is_changed && one.time_ratio.value > 1;
  };
  return std::any_of(changes.means.begin(), changes.means.end(), is_slower) ||
                 std::any_of(changes.scenes.begin(), changes.scenes.end(), is_slower)
             ? 1
             : 0;
}

}  // namespace orbs::studies
