#include "cli/study_context.h"

#include "base/terminal.h"
#include "cli/interrupt.h"

#include <fmt/format.h>

namespace orbs::cli {

studies::StudyContext study_context(const Program& program, std::FILE* stream) {
  return {program.folder, program.version, &catch_interrupts(), [=](const std::string& line) {
            print_clean(stream, "{}\n", line);
            // Without this a file or a pipe would get its first line after minutes.
            std::fflush(stream);
          }};
}

}  // namespace orbs::cli
