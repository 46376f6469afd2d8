#include "history/change_colours.h"

namespace orbs::history {

namespace {

std::string_view direction_colour(Direction direction) {
  switch (direction) {
    case Direction::Worse:
      return colour::kRed;
    case Direction::Better:
      return colour::kGreen;
    case Direction::Neither:
      return colour::kYellow;
  }
  return {};
}

}  // namespace

CellColours direction_colours(const std::vector<Change>& changes, const TerminalStyle& style) {
  CellColours colours;
  if (!style.colour) return colours;
  for (std::size_t i = 0; i < changes.size(); ++i)
    colours[{i + 1, 0}] = direction_colour(changes[i].direction);
  return colours;
}

}  // namespace orbs::history
