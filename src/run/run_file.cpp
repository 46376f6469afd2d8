#include "run/run_file.h"

#include "base/error.h"
#include "base/files.h"
#include "base/local_time.h"
#include "json/document.h"
#include "json/field_reader.h"
#include "json/field_writer.h"

#include <fmt/format.h>

namespace orbs::run {

namespace {

constexpr const char* kRunFile = "run.json";
constexpr const char* kFormat = "orbs-run/2";

}  // namespace

std::filesystem::path make_run_folder(const std::string& wanted, const std::string& kind) {
  std::error_code failed;
  if (!wanted.empty()) {
    const auto folder = std::filesystem::absolute(wanted).lexically_normal();
    const bool is_taken =
        std::filesystem::exists(folder, failed) &&
        !(std::filesystem::is_directory(folder, failed) && std::filesystem::is_empty(folder, failed));
    if (is_taken)
      throw InputError(
          fmt::format("{}: exists already; name a new or empty folder with -o", folder.string()));
    make_folder(folder);
    return folder;
  }
  const auto stamp = kind + local_time_now("-%y%m%d-%H%M%S");
  for (int number = 1;; ++number) {
    const auto name = number == 1 ? stamp : fmt::format("{}-{}", stamp, number);
    const auto folder = std::filesystem::absolute(name);
    // False when it exists: two runs that start in the same second take different names.
    if (std::filesystem::create_directory(folder, failed)) return folder;
    if (failed)
      throw InputError(fmt::format("{}: the folder cannot be made: {}", folder.string(), failed.message()));
  }
}

RunFile read_run_file(const std::filesystem::path& folder) {
  std::error_code ignored;
  if (!std::filesystem::exists(folder / kRunFile, ignored))
    throw InputError(
        fmt::format("{}: holds no {}, so there is no run to resume; name the folder that 'orbs run' made",
                    folder.string(), kRunFile));
  const auto document = json::parse_file(folder / kRunFile);
  json::ObjectReader in(document);
  json::check_format(in, kFormat);
  RunFile file;
  json::FieldReader read(in);
  fields(read, file);
  return file;
}

void write_run_file(const RunFile& file, const std::filesystem::path& folder) {
  json::Writer out;
  out.begin_object().member("format", kFormat);
  json::write_fields(out, file);
  write_file(folder / kRunFile, out.end_object().text());
}

}  // namespace orbs::run
