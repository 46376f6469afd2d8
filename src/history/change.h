#pragma once

#include "results/least_change.h"

#include <cstddef>
#include <string>
#include <vector>

/// What differs between two runs, as plain data.
namespace orbs::history {

/// In how many comparisons of two runs of equal programs on an equal machine any number is called changed.
/// The three kinds of numbers, light, error and time, share it evenly.
inline constexpr double kFalseAlarms = 0.01;

/// Smaller changes are not reported, however certain they are: of the mean of a channel, of the mean squared
/// error, of the time.
using results::kLeastError;
using results::kLeastLight;
inline constexpr double kLeastTime = 0.05;

enum class Quantity { Verdict, Light, Error, Time };

/// "verdict", "light", "error", "time".
std::string quantity_name(Quantity quantity);

enum class Direction { Worse, Neither, Better };

/// "worse", "changed", "better".
std::string direction_name(Direction direction);

struct Change {
  Quantity quantity = Quantity::Verdict;
  Direction direction = Direction::Neither;
  std::string renderer;
  std::string requirement;  // "" for all targets of a renderer together
  std::string target;       // likewise
  std::string before;       // with unit
  std::string after;
  double by_chance =
      0;            // the probability that equal programs differ so much; 0 for a verdict, which is a fact
  double size = 0;  // to order changes of one kind by: how much worse
  std::string reason{};  // of the verdict in the second run
  std::string since{};   // of a step in many runs: the first run after it, with its date
};

/// Fills the change of a mean, 'R', 'G' or 'B', that was off by `before` and is off by `after`: worse where
/// it is off by more. An error of the other sign is another one, and is called so: worse, or neither where
/// less than half of it is left, as after a mend that went too far. What is within kLeastLight has no sign.
void describe_light(char channel, double before, double after, Change& change);

/// "1 in 340": how often equal programs differ so much; "" for a verdict. Below 1e-9 "< 1 in 1e9", since no
/// distribution is known so far out.
std::string chance_text(const Change& change);

/// A test of one number: the change that is reported if its probability is small enough among all tests.
struct Candidate {
  Change change;
  double probability = 1;
};

/// Appends the changes whose probabilities are significant together at `level`. The tests of renderers as a
/// whole share one half of it and those of single targets the other, so that hundreds of targets do not hide
/// a renderer. The tests of each half share it by Holm's procedure (1979, "A Simple Sequentially Rejective
/// Multiple Test Procedure").
void keep_significant(std::vector<Candidate> candidates, double level, std::vector<Change>& changes);

}  // namespace orbs::history
