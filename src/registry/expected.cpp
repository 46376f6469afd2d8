#include "registry/expected.h"

#include "base/error.h"
#include "base/text.h"
#include "json/locate.h"
#include "json/writer.h"
#include "registry/filters.h"

#include <algorithm>
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

std::string entry_text(const ExpectedFailure& entry) {
  json::Writer out;
  out.begin_object().member("renderer", entry.renderer);
  if (!entry.version.text.empty()) out.member("version", entry.version.text);
  out.member("scene", entry.scene).member("verdict", entry.verdict).member("reason", entry.reason);
  if (!entry.measure.empty()) {
    out.key("measure").begin_object();
    for (const auto& [check, number] : entry.measure) {
      out.key(check);
      if (number) {
        out.value(*number);
      } else {
        out.null();
      }
    }
    out.end_object();
  }
  return std::string(trim(out.end_object().text()));
}

}  // namespace

void check_expected(ObjectReader& in,
                    const std::vector<std::string>& renderers,
                    std::vector<ExpectedFailure>& expected) {
  auto entries = in.objects_or_none("expected");
  for (std::size_t i = 0; i < entries.size(); ++i) {
    auto& failure = expected[i];
    failure.place = entries[i].place("renderer");
    check_patterns(entries[i], "renderer", failure.renderer);
    refuse_unknown_renderers(entries[i], failure.renderer, renderers);
    check_patterns(entries[i], "scene", failure.scene);
    if (trim(failure.reason).empty()) entries[i].fail("reason", "must say why the failure is accepted");
  }
}

const ExpectedFailure* find_expected(const std::vector<ExpectedFailure>& expected,
                                     const std::string& renderer,
                                     const std::string& version,
                                     const std::string& target) {
  const auto found = std::find_if(expected.rbegin(), expected.rend(), [&](const ExpectedFailure& entry) {
    return matches_any(patterns_of(entry.renderer), renderer) &&
           matches_any(patterns_of(entry.scene), target) && is_in_range(entry.version, version);
  });
  return found == expected.rend() ? nullptr : &*found;
}

std::string with_expected(const std::string& text,
                          const std::vector<ExpectedFailure>& present,
                          const std::vector<ExpectedFailure>& added) {
  auto out = text;
  bool has_array = json::has_value(text, "/expected");
  for (auto entry : added) {
    const auto same = std::find_if(present.begin(), present.end(), [&](const ExpectedFailure& other) {
      return other.renderer == entry.renderer && other.scene == entry.scene;
    });
    if (same != present.end()) {
      entry.version = same->version;
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
