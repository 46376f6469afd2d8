// Writes the TypeScript types of all that the page reads, from the fields() of the records:
//   orbs-page-types <file>
#include "base/files.h"
#include "json/page_types.h"
#include "report/file_change.h"
#include "report/overview.h"
#include "report/progress.h"
#include "report/target_data.h"
#include "results/study_kinds.h"
#include "studies/cost/change.h"
#include "studies/cost/json.h"
#include "studies/stability/json.h"

#include <cstdio>
#include <exception>

namespace {

using namespace orbs;

std::string page_types() {
  json::PageTypes types;
  types.add<report::Overview>();
  types.add<report::TargetDetail>();
  types.add<report::Progress>();
  types.add<report::FileChange>();
  types.add<studies::CostStudy>();
  types.add<studies::CostChanges>();
  types.add<studies::StabilityStudy>();
  std::string kinds;
  for (const auto& kind : results::kStudyKinds)
    kinds += fmt::format("  {{ name: \"{}\", file: \"{}\" }},\n", kind.name, kind.file);
  return fmt::format(
      "// Written by the build from the fields() of the C++ records, which say what each member means.\n"
      "{}\n"
      "/** The kinds of studies and their files. */\n"
      "export const kStudyKinds = [\n{}] as const;\n"
      "export type StudyKind = (typeof kStudyKinds)[number][\"name\"];\n",
      types.text(), kinds);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fputs("usage: orbs-page-types <file>\n", stderr);
    return 2;
  }
  try {
    write_file(argv[1], page_types());
    return 0;
  } catch (const std::exception& e) {
    std::fprintf(stderr, "%s\n", e.what());
    return 2;
  }
}
