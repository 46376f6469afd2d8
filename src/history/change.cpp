#include "history/change.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include <fmt/format.h>

namespace orbs::history {

std::string quantity_name(Quantity quantity) {
  switch (quantity) {
    case Quantity::Verdict:
      return "verdict";
    case Quantity::Light:
      return "light";
    case Quantity::Error:
      return "error";
    case Quantity::Time:
      return "time";
  }
  return {};
}

std::string direction_name(Direction direction) {
  switch (direction) {
    case Direction::Worse:
      return "worse";
    case Direction::Neither:
      return "changed";
    case Direction::Better:
      return "better";
  }
  return {};
}

void describe_light(char channel, double before, double after, Change& change) {
  constexpr double kPercent = 100;
  constexpr double kLeft = 0.5;
  const double was = std::fabs(before);
  const double is = std::fabs(after);
  const bool is_other_sign = (before < 0) != (after < 0) && std::min(was, is) > kLeastLight;
  change.quantity = Quantity::Light;
  change.direction = is > was ? Direction::Worse : Direction::Better;
  if (is_other_sign) change.direction = is < kLeft * was ? Direction::Neither : Direction::Worse;
  change.before = fmt::format("mean of {} {:+.3f} %", channel, kPercent * before);
  change.after = fmt::format("{:+.3f} %{}", kPercent * after, is_other_sign ? " (other sign)" : "");
  change.size = std::fabs(after - before);
}

std::string chance_text(const Change& change) {
  constexpr double kLeast = 1e-9;
  if (change.quantity == Quantity::Verdict) return "";
  return change.by_chance < kLeast ? "< 1 in 1e9" : fmt::format("1 in {:.2g}", 1 / change.by_chance);
}

namespace {

void keep_by_holm(std::vector<Candidate> candidates, double level, std::vector<Change>& changes) {
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const Candidate& a, const Candidate& b) { return a.probability < b.probability; });
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    if (candidates[i].probability > level / static_cast<double>(candidates.size() - i)) return;
    candidates[i].change.by_chance = candidates[i].probability;
    changes.push_back(std::move(candidates[i].change));
  }
}

}  // namespace

void keep_significant(std::vector<Candidate> candidates, double level, std::vector<Change>& changes) {
  const auto targets =
      std::stable_partition(candidates.begin(), candidates.end(),
                            [](const Candidate& candidate) { return candidate.change.target.empty(); });
  std::vector<Candidate> of_targets(std::make_move_iterator(targets),
                                    std::make_move_iterator(candidates.end()));
  candidates.erase(targets, candidates.end());
  keep_by_holm(std::move(candidates), level / 2, changes);
  keep_by_holm(std::move(of_targets), level / 2, changes);
}

}  // namespace orbs::history
