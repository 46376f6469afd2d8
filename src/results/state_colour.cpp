#include "results/state_colour.h"

#include "base/terminal.h"

namespace orbs::results {

std::string_view state_colour(Verdict verdict, Expectation expectation) {
  if (expectation == Expectation::Known) return colour::kGreen;
  if (expectation == Expectation::News) return colour::kRed;
  if (passes(verdict)) return colour::kGreen;
  if (verdict == Verdict::Unsupported || verdict == Verdict::Skipped) return colour::kFaint;
  return verdict == Verdict::Inconclusive ? colour::kYellow : colour::kRed;
}

}  // namespace orbs::results
