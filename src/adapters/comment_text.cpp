#include "adapters/comment_text.h"

#include <algorithm>
#include <cctype>

namespace orbs::adapters {

std::string comment_text(const std::string& name) {
  std::string text = name;
  std::replace_if(
      text.begin(), text.end(), [](unsigned char c) { return std::iscntrl(c) != 0; }, ' ');
  return text;
}

}  // namespace orbs::adapters
