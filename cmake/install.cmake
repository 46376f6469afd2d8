# cmake --install: programs, page, data and adapters together in lib/orbs, where the programs look for the nearest
# configuration.json, so that a run needs no checkout; links in bin; manual page and completions, which the program
# prints from its own description of the command line. cpack makes a Debian package of the same files.
set(home lib/orbs)
install(TARGETS orbs orbs-tracer orbs-supervisor orbs_image_formats RUNTIME DESTINATION ${home} LIBRARY DESTINATION ${home})
install(DIRECTORY ${PROJECT_BINARY_DIR}/web DESTINATION ${home} OPTIONAL
  PATTERN "CMakeFiles" EXCLUDE PATTERN "*.cmake" EXCLUDE)  # built by orbs-page alone
install(DIRECTORY data adapters DESTINATION ${home}
  PATTERN "__pycache__" EXCLUDE PATTERN "node_modules" EXCLUDE)
install(FILES configuration.json DESTINATION ${home})
install(DIRECTORY include/orbs DESTINATION include)  # for plug-ins
install(DIRECTORY plugins/saddle DESTINATION share/doc/orbs/plugins)  # how one is written
install(DIRECTORY examples/minimal-renderer examples/embree-pathtracer DESTINATION share/doc/orbs/examples)  # a renderer to copy
install(TARGETS saddle LIBRARY DESTINATION ${home}/plugins)
install(FILES LICENSE DESTINATION share/doc/orbs RENAME copyright)
install(FILES README.md CHANGELOG.md DESTINATION share/doc/orbs)
install(DIRECTORY docs DESTINATION share/doc/orbs)

set(made ${PROJECT_BINARY_DIR}/install)
file(MAKE_DIRECTORY ${made})
foreach(program orbs orbs-tracer)
  file(CREATE_LINK ../${home}/${program} ${made}/${program} SYMBOLIC)
  install(FILES ${made}/${program} DESTINATION bin)
endforeach()

set(printed)
function(print_file name)
  list(GET ARGN 0 program)
  add_custom_command(OUTPUT ${made}/${name} COMMAND ${ARGN} > ${made}/${name} DEPENDS ${program} VERBATIM)
  set(printed ${printed} ${made}/${name} PARENT_SCOPE)
endfunction()
print_file(orbs.1 orbs manual)
print_file(orbs-tracer.1 orbs-tracer --manual)
print_file(orbs.bash orbs completion bash)
print_file(_orbs orbs completion zsh)
print_file(orbs.fish orbs completion fish)
add_custom_target(orbs-printed ALL DEPENDS ${printed})
# What is installed but for the page, and what a run needs: no test is among it.
add_custom_target(orbs-programs DEPENDS orbs-printed)
add_dependencies(orbs-programs orbs orbs-tracer orbs-supervisor saddle)
install(FILES ${made}/orbs.1 ${made}/orbs-tracer.1 DESTINATION share/man/man1)
install(FILES ${made}/orbs.bash DESTINATION share/bash-completion/completions RENAME orbs)
install(FILES ${made}/_orbs DESTINATION share/zsh/vendor-completions)
install(FILES ${made}/orbs.fish DESTINATION share/fish/vendor_completions.d)

set(CPACK_PACKAGE_NAME orbs)
set(CPACK_PACKAGE_VENDOR "ORB.S Suite")
set(CPACK_PACKAGE_CONTACT "ORB.S Suite <orbs@localhost>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "Benchmark of renderers, with a reference path tracer")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)  # the libraries that the programs are linked with
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "bubblewrap")
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "blender, povray")
set(CPACK_DEBIAN_COMPRESSION_TYPE gzip)  # most of it are EXR images, which are compressed
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
include(CPack)
