#include "registry/expected.h"

#include "base/error.h"
#include "base/text.h"
#include "json/document.h"
#include "json/field_reader.h"
#include "json/field_writer.h"
#include "json/locate.h"
#include "registry/filters.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <set>

#include <fmt/format.h>

namespace orbs::registry {

namespace {

using json::ObjectReader;

void check_patterns(ObjectReader& in, const std::string& key, const std::string& text) {
  if (patterns_of(text).empty()) in.fail(key, "must hold a name or a pattern such as 'm*'");
}

void refuse_unknown_renderers(ObjectReader& in,
                              const std::string& patterns,
                              const std::vector<std::string>& renderers) {
  for (const auto& pattern : patterns_of(patterns))
    if (std::none_of(renderers.begin(), renderers.end(),
                     [&](const auto& name) { return glob_match(pattern, name); }))
      in.fail("renderer", fmt::format("no renderer matches '{}'{}", pattern,
                                      closest(pattern, {renderers.begin(), renderers.end()})));
}

void refuse_unknown_suite(ObjectReader& in,
                          const std::string& suite,
                          const std::vector<std::string>& suites) {
  if (std::find(suites.begin(), suites.end(), suite) == suites.end())
    in.fail("suite",
            fmt::format("there is no suite '{}'{}", suite, closest(suite, {suites.begin(), suites.end()})));
}

std::string entry_text(const ExpectedFailure& entry) {
  json::Writer out;
  json::write_record(out, entry);
  return std::string(trim(out.text()));
}

bool is_expired(const ExpectedFailure& entry, const std::string& day) {
  return entry.until && entry.until->text < day;
}

}  // namespace

void check_expected(ObjectReader& in,
                    const std::vector<std::string>& renderers,
                    const std::vector<std::string>& suites,
                    std::vector<ExpectedFailure>& expected) {
  auto entries = in.objects_or_none("expected");
  for (std::size_t i = 0; i < entries.size(); ++i) {
    auto& failure = expected[i];
    failure.place = entries[i].place("renderer");
    check_patterns(entries[i], "renderer", failure.renderer);
    refuse_unknown_renderers(entries[i], failure.renderer, renderers);
    check_patterns(entries[i], "scene", failure.scene);
    if (failure.suite) refuse_unknown_suite(entries[i], *failure.suite, suites);
    if (trim(failure.reason).empty()) entries[i].fail("reason", "must say why the failure is accepted");
  }
}

std::vector<ExpectedFailure> expected_of_text(const std::filesystem::path& file, const std::string& text) {
  const auto document = json::parse(file.string(), text);
  ObjectReader in(document);
  std::vector<ExpectedFailure> entries;
  for (auto& entry : in.objects_or_none("expected"))
    entries.push_back(json::read_settings<ExpectedFailure>(entry));
  return entries;
}

FoundExpected find_expected(const std::vector<ExpectedFailure>& expected,
                            const std::string& renderer,
                            const std::string& version,
                            const std::string& target,
                            const RunKind& run) {
  FoundExpected found;
  for (const auto& entry : expected) {
    const bool is_of_run = entry.suite.value_or(run.suite) == run.suite &&
                           entry.size.value_or(run.size) == run.size && is_in_range(entry.version, version);
    if (!is_of_run || !matches_any(patterns_of(entry.renderer), renderer) ||
        !matches_any(patterns_of(entry.scene), target))
      continue;
    (is_expired(entry, run.day) ? found.expired : found.counting) = &entry;
  }
  if (found.counting != nullptr) found.expired = nullptr;
  return found;
}

std::string with_expected(const std::string& text,
                          const std::vector<ExpectedFailure>& present,
                          const std::vector<ExpectedFailure>& added,
                          const std::string& day) {
  auto out = text;
  bool has_array = json::has_value(text, "/expected");
  for (auto entry : added) {
    const auto same = std::find_if(present.begin(), present.end(), [&](const ExpectedFailure& other) {
      // The numbers of another version stay: it may be what the next run is of.
      return other.renderer == entry.renderer && other.scene == entry.scene && other.suite == entry.suite &&
             other.size == entry.size && is_in_range(other.version, entry.version.text);
    });
    if (same != present.end()) {
      entry.version = same->version;
      if (!entry.until && !is_expired(*same, day)) entry.until = same->until;
      out = json::with_value(out, fmt::format("/expected/{}", same - present.begin()), entry_text(entry));
    } else if (has_array) {
      out = json::with_element(out, "/expected", entry_text(entry));
    } else {
      // As an element that is not the first: every line two columns to the right of the bracket.
      out = json::with_member(out, "expected", "[]");
      out = json::with_element(out, "/expected", entry_text(entry));
      has_array = true;
    }
  }
  return out;
}

}  // namespace orbs::registry
