#include "cli/not_empty.h"

namespace orbs::cli {

CLI::Validator not_empty(const std::string& what) {
  return {[=](const std::string& text) { return text.empty() ? "needs " + what : ""; }, ""};
}

}  // namespace orbs::cli
