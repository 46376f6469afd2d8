#include "json/page_types.h"

#include <cstdlib>
#include <memory>

#include <cxxabi.h>

namespace orbs::json {

std::string type_name(const std::type_info& type) {
  int status = 0;
  const std::unique_ptr<char, decltype(&std::free)> name(
      abi::__cxa_demangle(type.name(), nullptr, nullptr, &status), &std::free);
  const std::string whole = status == 0 ? name.get() : type.name();
  return whole.substr(whole.rfind(':') + 1);
}

std::string PageTypes::text() const {
  std::string text;
  for (const auto& [name, type] : types_) text += fmt::format("\nexport type {} = {};\n", name, type);
  return text;
}

}  // namespace orbs::json
