#include "cli/page_editor.h"

#include "base/error.h"
#include "base/local_time.h"
#include "base/text.h"
#include "json/locate.h"
#include "registry/configuration_files.h"
#include "registry/expected.h"
#include "run/expected.h"

#include <algorithm>
#include <optional>

#include <fmt/format.h>

namespace orbs::cli {

namespace {

// "" for no last day.
std::optional<registry::Day> last_day(const std::string& text) {
  if (text.empty()) return std::nullopt;
  auto day = registry::parse_day(text);
  if (const auto today = registry::day_of(local_time_now()); day.text < today)
    throw InputError(fmt::format("the last day, {}, is over: today is {}", day.text, today));
  return day;
}

// The line of the entry for the target of this record, which has one renderer and one scene.
int line_of_entry(const std::filesystem::path& file,
                  const std::string& text,
                  const results::TargetRecord& target) {
  const auto entries = registry::expected_of_text(file, text);
  const auto last = std::find_if(entries.rbegin(), entries.rend(), [&](const auto& entry) {
    return entry.renderer == target.renderer && entry.scene == target.target;
  });
  if (last == entries.rend()) return 1;
  return json::locate(text, fmt::format("/expected/{}", entries.rend() - last - 1)).line;
}

server::EditedText accept(const registry::Configuration& configuration,
                          const results::RunRecord& run,
                          const std::string& reason,
                          const std::string& until) {
  if (trim(reason).empty()) throw InputError("the reason must say why the failure is accepted");
  auto change = run::acceptance_of(configuration, {reason, last_day(until)}, run);
  const auto& target = run.targets.front();
  if (change.entries == 0)
    throw InputError(fmt::format("'{}' by '{}' is no failure that can be accepted: its state is '{}'",
                                 target.target, target.renderer, results::state_name(target)));
  const auto& file = configuration.own_file;
  const int line = line_of_entry(file, change.after, target);
  return {file, std::move(change.before), std::move(change.after), line};
}

}  // namespace

server::Editor page_editor(const registry::Configuration& configuration) {
  return {
      [configuration](const results::RunRecord& run, const std::string& reason, const std::string& until) {
        return accept(configuration, run, reason, until);
      },
      [](const std::filesystem::path& file, const std::string& text) { registry::write_own(file, text); }};
}

}  // namespace orbs::cli
