#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <utility>

/// The parts of a one-file page: the built page, and the script elements that hold its data.
namespace orbs::report {

/// The built page before and after the place of its data. InputError when the page is not built.
std::pair<std::string, std::string> page_template(const std::filesystem::path& bundle);

/// `json` escaped for the inside of an HTML script element, so that nothing in it can end the element.
std::string script_text(std::string_view json);

/// A script element that the browser does not run. `content` holds no '<'.
std::string data_element(const std::string& id, const std::string& type, const std::string& content);

}  // namespace orbs::report
