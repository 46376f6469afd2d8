#include "report/page_template.h"

#include "base/error.h"
#include "base/files.h"

#include <fmt/format.h>

namespace orbs::report {

std::pair<std::string, std::string> page_template(const std::filesystem::path& bundle) {
  constexpr std::string_view kMark = "<!--orbs-data-->";
  const auto file = bundle / "single.html";
  if (!std::filesystem::exists(file))
    throw InputError(
        fmt::format("{}: is missing: the results page has not been built; './bootstrap build' makes it "
                    "and says what it needs (Node.js 18 or newer and npm)",
                    file.string()));
  const auto text = read_file(file);
  const auto at = text.find(kMark);
  if (at == std::string::npos)
    throw InputError(fmt::format("{}: has no {}; build it again", file.string(), kMark));
  return {text.substr(0, at), text.substr(at + kMark.size())};
}

std::string script_text(std::string_view json) {
  std::string out;
  out.reserve(json.size());
  for (const char c : json) {
    if (c == '<') {
      out += "\\u003c";
    } else {
      out += c;
    }
  }
  return out;
}

std::string data_element(const std::string& id, const std::string& type, const std::string& content) {
  return fmt::format("<script type=\"{}\" id=\"{}\">{}</script>\n", type, id, content);
}

}  // namespace orbs::report
