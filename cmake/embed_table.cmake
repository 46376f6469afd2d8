# embed_table(<target> <csv file> <function>)
# Compiles the rows of a table of numbers into the target, as
#   std::span<const std::array<double, columns>> orbs::<target's module>::<function>()
# which spectra/embedded_tables.h declares: a program that needs the table needs no path to it. Comments (#) and the
# row of column names are left out.
function(embed_table target csv function)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${csv})
  file(STRINGS ${csv} rows REGEX "^[0-9]")
  list(LENGTH rows row_count)
  list(GET rows 0 first)
  string(REGEX MATCHALL "," commas ${first})
  list(LENGTH commas column_count)
  math(EXPR column_count "${column_count} + 1")
  list(TRANSFORM rows REPLACE "(.+)" "    {{\\1}},")
  list(JOIN rows "\n" rows)
  set(source ${CMAKE_CURRENT_BINARY_DIR}/${function}.cpp)
  file(CONFIGURE OUTPUT ${source} CONTENT [[// Written by cmake/embed_table.cmake from @csv@.
#include "spectra/embedded_tables.h"

namespace orbs::spectra {
namespace {
constexpr std::array<std::array<double, @column_count@>, @row_count@> kRows{{
@rows@
}};
}  // namespace

std::span<const std::array<double, @column_count@>> @function@() { return kRows; }

}  // namespace orbs::spectra
]] @ONLY)
  target_sources(${target} PRIVATE ${source})
endfunction()
