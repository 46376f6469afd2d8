# Everything from outside; the Debian packages that hold it are listed in ./bootstrap.
find_package(Threads REQUIRED)
find_package(fmt REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(embree 3 REQUIRED)
find_package(ZLIB REQUIRED)
find_path(ORBS_HTTPLIB_INCLUDE httplib.h REQUIRED)
find_library(ORBS_HTTPLIB_LIBRARY cpp-httplib REQUIRED)
add_library(orbs_httplib INTERFACE)
target_include_directories(orbs_httplib SYSTEM INTERFACE ${ORBS_HTTPLIB_INCLUDE})
target_link_libraries(orbs_httplib INTERFACE ${ORBS_HTTPLIB_LIBRARY} Threads::Threads)
find_path(ORBS_CLI11_INCLUDE CLI/CLI.hpp REQUIRED)
add_library(orbs_cli11 INTERFACE)
target_include_directories(orbs_cli11 SYSTEM INTERFACE ${ORBS_CLI11_INCLUDE})

# Debian's OpenImageIOConfig.cmake refuses to load unless its eight command-line tools (with Qt) are installed too. We
# need two libraries, so we find these ourselves.
find_path(ORBS_OIIO_INCLUDE OpenImageIO/imageio.h REQUIRED)
find_library(ORBS_OIIO_LIBRARY OpenImageIO REQUIRED)
find_library(ORBS_OIIO_UTIL_LIBRARY OpenImageIO_Util REQUIRED)
add_library(orbs_oiio INTERFACE)
target_include_directories(orbs_oiio SYSTEM INTERFACE ${ORBS_OIIO_INCLUDE})
target_link_libraries(orbs_oiio INTERFACE ${ORBS_OIIO_LIBRARY} ${ORBS_OIIO_UTIL_LIBRARY})
