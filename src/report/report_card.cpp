#include "report/report_card.h"

#include "base/short_sentence.h"
#include "base/statistics.h"
#include "report/clocks.h"
#include "report/undecided.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <map>
#include <string_view>
#include <utility>

#include <fmt/format.h>

namespace orbs::report {

namespace {

using results::Expectation;
using results::RunRecord;
using results::TargetRecord;
using results::Verdict;
using results::VerdictKind;

// How many targets of a renderer are what.
struct Count {
  std::size_t judged = 0;  // declared and supported
  std::size_t passes = 0;
  std::size_t remarks = 0;  // of the passes
  std::size_t known = 0;
  std::size_t wrong = 0;
  std::size_t no_image = 0;
  std::size_t open = 0;  // undecided, without reference, or not rendered yet
  std::size_t waiting = 0;
};

void add(const TargetRecord& target, Count& count) {
  const auto kind = kind_of(target.verdict);
  if (!target.declared || kind == VerdictKind::Unsupported) return;
  ++count.judged;
  if (target.expectation == Expectation::Known) {
    ++count.known;
  } else if (kind == VerdictKind::Pass) {
    ++count.passes;
    if (target.verdict == Verdict::PassWithRemarks) ++count.remarks;
  } else if (kind == VerdictKind::WrongImage) {
    ++count.wrong;
  } else if (kind == VerdictKind::NoImage) {
    ++count.no_image;
  } else {
    ++count.open;
    if (kind == VerdictKind::Skipped) ++count.waiting;
  }
}

std::string targets_text(std::size_t count) {
  return fmt::format("{} target{}", count, count == 1 ? "" : "s");
}

std::string standing_of(const Count& count) {
  if (count.wrong + count.no_image > 0) return "wrong";
  if (count.judged == 0 || count.waiting == count.judged) return "open";
  if (count.open > 0) return "undecided";
  return count.known > 0 ? "known" : "right";
}

// The mean error of R, G and B together, where it is certain of all three that they are off to the same side.
std::optional<double> certain_lightness(const TargetRecord& target) {
  double sum = 0;
  int darker = 0;
  int brighter = 0;
  for (const auto& measure : target.measures) {
    if (measure.name.rfind("mean_ratio_", 0) != 0) continue;
    sum += measure.value;
    if (measure.high && *measure.high < 0) ++darker;
    if (measure.low && *measure.low > 0) ++brighter;
  }
  return darker == 3 || brighter == 3 ? std::optional(sum / 3) : std::nullopt;
}

// ": too dark by 24 to 51 %", where all wrong images are.
std::string lightness_text(const RunRecord& run, const std::string& renderer) {
  constexpr double kPercent = 100;
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (const auto& target : run.targets) {
    if (target.renderer != renderer || !target.declared ||
        kind_of(target.verdict) != VerdictKind::WrongImage || target.expectation == Expectation::Known)
      continue;
    const auto off = certain_lightness(target);
    if (!off) return "";
    low = std::min(low, *off);
    high = std::max(high, *off);
  }
  if (!(low * high > 0)) return "";
  // More than all of the light cannot be missing.
  const double floor = high < 0 ? std::max(low, -1.0) : low;
  const auto [least, most] = std::minmax({std::fabs(floor), std::fabs(high)});
  const auto by = fmt::format("{:.2g}", kPercent * least) == fmt::format("{:.2g}", kPercent * most)
                      ? fmt::format("{:.2g}", kPercent * most)
                      : fmt::format("{:.2g} to {:.2g}", kPercent * least, kPercent * most);
  return fmt::format(": too {} by {} %", high < 0 ? "dark" : "bright", by);
}

// The first group with a diagnosis that holds at least half of what is wrong is the cause that leads.
std::string cause_text(const RunRecord& run,
                       const std::string& renderer,
                       const std::vector<TroubleGroup>& groups,
                       std::size_t wrong) {
  for (const auto& group : groups) {
    if (!group.is_diagnosis || group.state == results::kKnown || 2 * group.targets.size() < wrong) continue;
    if (group.targets.size() == wrong) return fmt::format(": {}", group.what);
    return fmt::format(": in {} of them {}", group.targets.size(), group.what);
  }
  return lightness_text(run, renderer);
}

std::string sentence_of(const Count& count, const std::string& cause) {
  const auto all = targets_text(count.judged);
  if (count.judged == 0) return "nothing that it declares was asked of it";
  if (count.waiting == count.judged) return "nothing is judged yet";
  std::vector<std::string> parts;
  if (count.wrong > 0) parts.push_back(fmt::format("wrong in {} of {}{}", count.wrong, all, cause));
  if (count.no_image > 0) parts.push_back(fmt::format("no image of {} of {}", count.no_image, all));
  const bool is_wrong = !parts.empty();
  if (count.known > 0)
    parts.push_back(is_wrong ? fmt::format("{} known", count.known)
                             : fmt::format("wrong in {} of {}, all of them known", count.known, all));
  if (parts.empty() && count.open > 0)
    parts.push_back(count.passes == 0 ? "nothing is decided"
                                      : fmt::format("right on {} of {}", count.passes, all));
  if (count.open > 0) parts.push_back(fmt::format("{} undecided", count.open));
  if (parts.empty())
    parts.push_back(count.judged == 1 ? "right on its target" : fmt::format("right on all {}", all));
  if (count.remarks > 0) parts.push_back(fmt::format("{} with remarks", count.remarks));
  std::string text;
  for (const auto& part : parts) text += (text.empty() ? "" : "; ") + part;
  return text;
}

// Two diagnoses of one fault differ in their numbers, of which pi is one: "shifted by (2, 1) px: then 60.2
// dB".
std::string without_numbers(const std::string& text) {
  std::string out;
  for (const char c : text.substr(0, text.find(": then")))
    if (std::isdigit(static_cast<unsigned char>(c)) == 0 && c != '.' && c != '-') out += c;
  const auto pi = out.rfind(" pi");
  return pi != std::string::npos && pi + 3 == out.size() ? out.substr(0, pi + 1) : out;
}

// The text that most of the group's targets have, the first of several.
std::string usual_text(const std::vector<std::string>& texts) {
  std::map<std::string, int> counts;
  for (const auto& text : texts) ++counts[text];
  return *std::max_element(texts.begin(), texts.end(),
                           [&](const auto& a, const auto& b) { return counts[a] < counts[b]; });
}

std::string why_undecided(const std::string& reason) {
  const auto undecided = undecided_of(reason);
  return undecided ? "undecided because of " + undecided->cause : "noise allows no decision";
}

// Why the failure is known, without what is news about its numbers.
std::string why_known(const std::string& expected) {
  return expected.substr(0, expected.find("; better than "));
}

TroubleGroup group_of(const TargetRecord& target) {
  constexpr std::size_t kMostColumns = 96;
  TroubleGroup group{std::string(state_name(target)), "", names_a_fault(target), {}};
  if (group.is_diagnosis) {
    group.what = target.diagnosis.substr(0, target.diagnosis.find(": then"));
  } else if (!target.expected.empty()) {
    group.what = why_known(target.expected);
  } else if (target.verdict == Verdict::PassWithRemarks) {
    group.what = "an error that breaks no gate";
  } else if (target.verdict == Verdict::Inconclusive) {
    group.what = why_undecided(target.reason);
  } else {
    group.what = target.diagnosis == results::kNoUsualFault ? std::string(results::kNoUsualFault)
                                                            : short_sentence(target.reason, kMostColumns);
  }
  return group;
}

// Wrong images first, then those that are missing, then what is undecided, then what is known.
int rank_of(const TroubleGroup& group) {
  if (group.state == results::kKnown) return 3;
  if (group.state == verdict_name(Verdict::PassWithRemarks)) return 4;
  const auto verdict = results::verdict_named(group.state);
  if (!verdict) return 0;
  return counts_as_failure(*verdict) && is_decided(*verdict) ? 0 : 2;
}

std::vector<TroubleGroup> groups_of(const RunRecord& run, const std::string& renderer) {
  std::vector<TroubleGroup> groups;
  std::vector<std::vector<std::string>> texts;  // of each group
  std::map<std::pair<std::string, std::string>, std::size_t> index;
  for (std::size_t i = 0; i < run.targets.size(); ++i) {
    const auto& target = run.targets[i];
    if (target.renderer != renderer || !target.declared) continue;
    const auto kind = kind_of(target.verdict);
    if (kind == VerdictKind::Unsupported || kind == VerdictKind::Skipped) continue;
    if (target.verdict == Verdict::Pass && target.expectation == Expectation::None) continue;
    auto group = group_of(target);
    const auto [at, is_new] = index.try_emplace(
        {group.state, group.is_diagnosis ? without_numbers(group.what) : group.what}, groups.size());
    if (is_new) {
      groups.push_back(group);
      texts.emplace_back();
    }
    groups[at->second].targets.push_back(i);
    texts[at->second].push_back(group.what);
  }
  for (std::size_t i = 0; i < groups.size(); ++i) groups[i].what = usual_text(texts[i]);
  std::stable_sort(groups.begin(), groups.end(), [](const auto& a, const auto& b) {
    return std::pair(rank_of(a), b.targets.size()) < std::pair(rank_of(b), a.targets.size());
  });
  return groups;
}

// CPU seconds times the squared noise of a target's image, which no number of samples changes. Only of
// renders in looks: others may have no noise, or one that they do not know.
std::map<std::string, double> work_of(const RunRecord& run,
                                      const results::JobsById& jobs,
                                      const std::string& renderer) {
  std::map<std::string, double> work;
  for (const auto& target : run.targets) {
    if (target.renderer != renderer || target.jobs.size() != 1) continue;
    const auto job = jobs.find(target.jobs.front());
    if (job == jobs.end() || job->second->sampling.looks == 0) continue;
    const auto noise = std::find_if(target.measures.begin(), target.measures.end(),
                                    [](const auto& one) { return one.name == "noise_squared"; });
    if (noise == target.measures.end()) continue;
    const double product = noise->value * job->second->cost.cpu_seconds;
    if (product > 0 && std::isfinite(product)) work[target.target] = product;
  }
  return work;
}

std::string sentence_of(const NoiseCost& cost) {
  const auto ends = fmt::format("({:.2g} to {:.2g}, {} targets)", cost.low, cost.high, cost.targets);
  if (cost.low <= 1 && cost.high >= 1)
    return fmt::format("no difference to {} in CPU time for equal noise is shown {}", cost.than, ends);
  return fmt::format("takes {:.2g} times the CPU time of {} for equal noise {}", cost.ratio, cost.than, ends);
}

// Nothing where fewer than three targets are shared, of which no scatter can be told.
std::optional<NoiseCost> cost_beside(const std::map<std::string, double>& own,
                                     const std::map<std::string, double>& other,
                                     const std::string& than) {
  constexpr std::size_t kFewest = 3;
  std::vector<double> logs;
  for (const auto& [target, work] : own)
    if (const auto found = other.find(target); found != other.end())
      logs.push_back(std::log(work / found->second));
  if (logs.size() < kFewest) return std::nullopt;
  const auto count = static_cast<double>(logs.size());
  double mean = 0;
  for (const double value : logs) mean += value / count;
  double squares = 0;
  for (const double value : logs) squares += (value - mean) * (value - mean);
  const double error = std::sqrt(squares / (count - 1) / count);
  const auto interval = student_interval(mean, error, count - 1, 0.05);
  NoiseCost cost{than, std::exp(interval.value), std::exp(interval.low), std::exp(interval.high),
                 logs.size()};
  cost.sentence = sentence_of(cost);
  return cost;
}

// All are compared with the first renderer whose renders say something. What a wrong image costs is no news.
void add_costs(const RunRecord& run, std::vector<ReportCard>& cards) {
  const auto jobs = jobs_by_id(run);
  std::vector<std::map<std::string, double>> works;
  works.reserve(cards.size());
  for (const auto& card : cards)
    works.push_back(renders_elsewhere(run, card.renderer) ? std::map<std::string, double>{}
                                                          : work_of(run, jobs, card.renderer));
  const auto base = std::find_if(works.begin(), works.end(), [](const auto& work) { return !work.empty(); });
  if (base == works.end()) return;
  const auto at = static_cast<std::size_t>(base - works.begin());
  for (std::size_t i = at + 1; i < cards.size(); ++i)
    if (cards[i].standing != "wrong") cards[i].cost = cost_beside(works[i], *base, cards[at].renderer);
}

}  // namespace

std::vector<ReportCard> report_cards(const RunRecord& run) {
  std::vector<ReportCard> cards;
  for (const auto& renderer : run.renderers) {
    Count count;
    for (const auto& target : run.targets)
      if (target.renderer == renderer.name) add(target, count);
    ReportCard card{renderer.name,
                    standing_of(count),
                    "",
                    groups_of(run, renderer.name),
                    {},
                    clocks_text(run, renderer.name)};
    card.sentence = sentence_of(count, cause_text(run, renderer.name, card.groups, count.wrong));
    cards.push_back(std::move(card));
  }
  add_costs(run, cards);
  return cards;
}

}  // namespace orbs::report
