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

std::string patterns_text(ObjectReader& in, const std::string& key) {
  auto text = in.text(key);
  if (patterns_of(text).empty()) in.fail(key, "must hold a name or a pattern such as 'm*'");
  return text;
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

VersionRange load_version(ObjectReader& in) {
  if (!in.has("version")) return {};
  try {
    return parse_version_range(in.text("version"));
  } catch (const InputError& e) {
    in.fail("version", e.what());
  }
}

ExpectedFailure load_entry(ObjectReader in, const std::vector<std::string>& renderers) {
  ExpectedFailure entry;
  entry.place = in.place("renderer");
  entry.renderer = patterns_text(in, "renderer");
  refuse_unknown_renderers(in, entry.renderer, renderers);
  entry.version = load_version(in);
  entry.scene = patterns_text(in, "scene");
  entry.verdict = in.text("verdict");
  entry.reason = in.text("reason");
  if (trim(entry.reason).empty()) in.fail("reason", "must say why the failure is accepted");
  if (in.has("measure")) {
    auto numbers = in.object("measure");
    for (const auto& check : numbers.keys())
      entry.measure[check] =
          numbers.holds_number(check) ? std::optional<double>(numbers.number(check)) : std::nullopt;
    numbers.finish();
  }
  in.finish();
  return entry;
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

std::vector<ExpectedFailure> load_expected(ObjectReader& in, const std::vector<std::string>& renderers) {
  std::vector<ExpectedFailure> expected;
  for (auto& entry : in.objects_or_none("expected"))
    expected.push_back(load_entry(std::move(entry), renderers));
  return expected;
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
