#include "history/best_split.h"

#include "base/student_t.h"

#include <algorithm>
#include <cmath>

namespace orbs::history {

namespace {

double mean_of(const std::vector<double>& numbers, std::size_t begin, std::size_t end) {
  double sum = 0;
  for (std::size_t i = begin; i < end; ++i) sum += numbers[i];
  return sum / static_cast<double>(end - begin);
}

}  // namespace

Split best_split(const Values& values) {
  const auto& x = values.numbers;
  const auto count = static_cast<double>(x.size());
  const double degrees = count - 2;
  Split best;
  double best_t = -1;
  for (std::size_t at = 1; at < x.size(); ++at) {
    const double before = mean_of(x, 0, at);
    const double after = mean_of(x, at, x.size());
    double squares = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
      const double residual = x[i] - (i < at ? before : after);
      squares += residual * residual;
    }
    const auto first = static_cast<double>(at);
    const double error = std::sqrt(squares / degrees * (1 / first + 1 / (count - first)));
    const double t = before == after ? 0 : std::fabs(after - before) / error;
    if (t > best_t) {
      best = {at, before, after, 1};
      best_t = t;
    }
  }
  best.probability =
      std::min(1.0, student_tail(best_t, std::min(degrees, values.most_degrees)) * (count - 1));
  return best;
}

}  // namespace orbs::history
