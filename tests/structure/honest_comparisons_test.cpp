// The count of right images that were called wrong: docs/reports/honest-comparisons.csv, which `orbs
// sensitivity
// --counts` writes, and the table of docs/understand/verdicts.md that is made of it.
#include "base/files.h"
#include "base/text.h"
#include "structure/documentation.h"

#include <cmath>
#include <map>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace {

struct Counts {
  int comparisons = 0;
  int inconclusive = 0;
  int called_wrong = 0;

  void add(const Counts& other) {
    comparisons += other.comparisons;
    inconclusive += other.inconclusive;
    called_wrong += other.called_wrong;
  }
};

struct Line {
  std::string suite, size, noise;
  Counts counts;
};

std::vector<Line> lines_of(const std::string& csv) {
  std::vector<Line> lines;
  std::istringstream in(csv);
  std::string text;
  std::getline(in, text);  // the names of the columns
  while (std::getline(in, text)) {
    std::istringstream cells(text);
    std::vector<std::string> cell(6);
    for (auto& one : cell) std::getline(cells, one, ',');
    lines.push_back(
        {cell[0], cell[1], cell[2], {std::stoi(cell[3]), std::stoi(cell[4]), std::stoi(cell[5])}});
  }
  return lines;
}

// E. B. Wilson, "Probable inference, the law of succession, and statistical inference", J. Am. Stat. Assoc.
// 22, 1927: the upper end of the 95 % interval of a share.
double upper_end(const Counts& counts) {
  constexpr double z = 1.96;
  const double n = counts.comparisons;
  const double p = counts.called_wrong / n;
  return (p + z * z / (2 * n) + z * std::sqrt(p * (1 - p) / n + z * z / (4 * n * n))) / (1 + z * z / n);
}

std::string row(const std::string& what, const Counts& counts) {
  return fmt::format("| {} | {} | {} | {} | at most {:.2g} of 1000 |\n", what, counts.comparisons,
                     counts.inconclusive, counts.called_wrong, 1000 * upper_end(counts));
}

std::string table_of(const std::vector<Line>& lines) {
  std::vector<std::string> order;
  std::map<std::string, Counts> sums;
  const auto add = [&](const std::string& what, const Counts& counts) {
    if (!sums.contains(what)) order.push_back(what);
    sums[what].add(counts);
  };
  for (const auto& line : lines) add(fmt::format("suite {} at {}", line.suite, line.size), line.counts);
  for (const auto& line : lines) add(line.noise, line.counts);
  for (const auto& line : lines) add("all", line.counts);
  std::string text =
      "| right images | comparisons | inconclusive | called wrong | 95 % interval |\n|---|---|---|---|---|\n";
  for (const auto& what : order) text += row(what, sums.at(what));
  return text;
}

}  // namespace

TEST(HonestComparisons, ThePageShowsTheCommittedCounts) {
  const std::filesystem::path root(ORBS_SOURCE_DIR);
  const auto lines = lines_of(orbs::read_file(root / "docs/reports/honest-comparisons.csv"));
  EXPECT_EQ(orbs::structure::check_generated_part(root / "docs/understand/verdicts.md", "honest comparisons",
                                                  table_of(lines)),
            "");
  // Images without noise are drawn, not rendered; the page says what is wrong with them.
  Counts all;
  Counts rendered;
  for (const auto& line : lines) {
    all.add(line.counts);
    if (line.noise != "noise-free") rendered.add(line.counts);
  }
  EXPECT_GE(all.comparisons, 5000);
  EXPECT_LE(1000 * rendered.called_wrong, rendered.comparisons);
}
