# orbs_module(<name> [COLD] [ALONE <folder>] USES <modules...> PACKAGES <third-party targets...>)
# One static library per folder of src/. USES is the whole list of folders that it may include:
# tests/structure reads the same lines and fails on any #include beyond them. COLD: it waits for renders and reads and
# writes records; a release optimises it a little, which takes half the time to compile.
function(orbs_module name)
  cmake_parse_arguments(arg "COLD" "ALONE" "USES;PACKAGES" ${ARGN})
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/${name}/*.cpp)
  list(FILTER sources EXCLUDE REGEX "[/_]main\\.cpp$")
  add_library(orbs_${name} STATIC ${sources})
  target_include_directories(orbs_${name} PUBLIC ${CMAKE_CURRENT_SOURCE_DIR})
  list(TRANSFORM arg_USES PREPEND orbs_)
  target_link_libraries(orbs_${name} PUBLIC ${arg_USES} fmt::fmt PRIVATE orbs_options ${arg_PACKAGES})
  if(arg_COLD)
    orbs_optimise_little(orbs_${name})
    orbs_precompile(orbs_${name} supervisor)
  else()
    orbs_precompile(orbs_${name} base)
  endif()
  orbs_compile_together(orbs_${name} ${arg_ALONE})
endfunction()

function(orbs_optimise_little target)
  target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
endfunction()

# Most of the time of compiling a file is reading the same headers of the standard library: they are read once for all
# targets that are optimised alike, with the first of them.
set(ORBS_STANDARD_HEADERS <algorithm> <array> <cmath> <cstdint> <filesystem> <fmt/format.h> <functional> <map> <memory>
  <optional> <set> <span> <string> <string_view> <utility> <variant> <vector>)
function(orbs_precompile target first)
  if(target STREQUAL orbs_${first})
    target_precompile_headers(${target} PRIVATE ${ORBS_STANDARD_HEADERS})
  else()
    target_precompile_headers(${target} REUSE_FROM orbs_${first})
  endif()
endfunction()

# orbs_shared_module(<name> USES <modules...> PACKAGES <third-party targets...>)
# One shared library, liborbs-<name>.so beside the programs, which one of them loads when it is needed. Of the modules it
# may include headers alone: it has what it calls from the packages.
function(orbs_shared_module name)
  cmake_parse_arguments(arg "" "" "USES;PACKAGES" ${ARGN})
  file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/${name}/*.cpp)
  add_library(orbs_${name} MODULE ${sources})
  target_include_directories(orbs_${name} PRIVATE ${CMAKE_CURRENT_SOURCE_DIR})
  target_link_libraries(orbs_${name} PRIVATE orbs_options ${arg_PACKAGES})
  string(REPLACE "_" "-" file ${name})
  set_target_properties(orbs_${name} PROPERTIES OUTPUT_NAME orbs-${file} CXX_VISIBILITY_PRESET hidden
    LIBRARY_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR})
endfunction()

# orbs_program(<name> <main file> USES <modules...> PACKAGES <third-party targets...>)
# A program: one main file, named main.cpp or *_main.cpp, which may include what its own USES names.
function(orbs_program name main)
  cmake_parse_arguments(arg "" "" "USES;PACKAGES" ${ARGN})
  add_executable(${name} ${main})
  list(TRANSFORM arg_USES PREPEND orbs_)
  target_link_libraries(${name} PRIVATE orbs_options ${arg_USES} ${arg_PACKAGES})
  target_compile_definitions(${name} PRIVATE ORBS_VERSION="${ORBS_VERSION}")
  set_target_properties(${name} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR})
endfunction()
