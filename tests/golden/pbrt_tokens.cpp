#include "golden/pbrt_tokens.h"

#include "base/text.h"

#include <algorithm>
#include <stdexcept>

namespace orbs::tests {

std::vector<std::string> pbrt_tokens(const std::string& text) {
  std::vector<std::string> tokens;
  for (const std::string& whole : split(text, '\n')) {
    const std::string line = whole.substr(0, whole.find('#'));
    for (std::size_t i = 0; i < line.size();) {
      if (line[i] == ' ') {
        ++i;
      } else if (line[i] == '"') {
        const auto end = line.find('"', i + 1);
        if (end == std::string::npos) throw std::runtime_error("unfinished string: " + line);
        tokens.push_back(line.substr(i, end - i));
        i = end + 1;
      } else if (line[i] == '[' || line[i] == ']') {
        tokens.emplace_back(1, line[i++]);
      } else {
        const auto end = std::min(line.find_first_of(" []\"", i), line.size());
        tokens.push_back(line.substr(i, end - i));
        i = end;
      }
    }
  }
  return tokens;
}

}  // namespace orbs::tests
