#include "studies/looks/looks_text.h"

#include "base/error.h"
#include "base/text.h"

#include <cmath>

#include <fmt/format.h>

namespace orbs::studies {

namespace {

constexpr const char* kHead =
    "samples,gate,error_limits,sequences,failed,passed,mean_spp,fixed_failed,fixed_passed\n";

// "0.05 % (0.02 to 0.12)": a count with the ends of its 95 % interval, Wilson 1927.
std::string share_text(int count, int of) {
  constexpr double kZ = 1.96;
  constexpr double kPercent = 100;
  if (of == 0) return "-";
  const double n = of;
  const double p = count / n;
  const double middle = (p + kZ * kZ / (2 * n)) / (1 + kZ * kZ / n);
  const double reach = kZ / (1 + kZ * kZ / n) * std::sqrt(p * (1 - p) / n + kZ * kZ / (4 * n * n));
  return fmt::format("{:.3g} % ({:.3g} to {:.3g})", kPercent * p, kPercent * std::max(0.0, middle - reach),
                     kPercent * std::min(1.0, middle + reach));
}

}  // namespace

std::string looks_text(const std::vector<LooksRow>& rows) {
  std::string text = fmt::format(
      "| samples | gate | error | called wrong | passed | mean spp | fixed {0} spp: called wrong | passed |\n"
      "|---|---|---|---|---|---|---|---|\n",
      kFixedSpp);
  for (const auto& row : rows)
    text += fmt::format(
        "| {} | `{}` | {:g} limits | {} | {} | {:.0f} | {} | {} |\n", row.samples, row.gate, row.error,
        share_text(row.failed, row.sequences), share_text(row.passed, row.sequences), row.mean_spp,
        share_text(row.fixed_failed, row.sequences), share_text(row.fixed_passed, row.sequences));
  return text;
}

std::string looks_csv(const std::vector<LooksRow>& rows) {
  std::string text = kHead;
  for (const auto& row : rows)
    text += fmt::format("{},{},{:g},{},{},{},{:.6g},{},{}\n", row.samples, row.gate, row.error, row.sequences,
                        row.failed, row.passed, row.mean_spp, row.fixed_failed, row.fixed_passed);
  return text;
}

std::vector<LooksRow> read_looks_csv(const std::string& text) {
  constexpr std::size_t kColumns = 9;
  if (!text.starts_with(kHead)) throw InputError(fmt::format("the first line must be {}", kHead));
  std::vector<LooksRow> rows;
  for (const auto& line : split(text.substr(std::string(kHead).size()), '\n')) {
    if (line.empty()) continue;
    const auto cells = split(line, ',');
    if (cells.size() != kColumns)
      throw InputError(fmt::format("'{}' has {} columns, expected {}", line, cells.size(), kColumns));
    const auto number = [&](std::size_t column) { return to_number(cells[column]).value_or(0); };
    const auto count = [&](std::size_t column) { return static_cast<int>(number(column)); };
    rows.push_back(
        {cells[0], cells[1], number(2), count(3), count(4), count(5), number(6), count(7), count(8)});
  }
  return rows;
}

}  // namespace orbs::studies
