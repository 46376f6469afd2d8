# Everything from outside; the packages that hold it are listed in system.sh.
find_package(Threads REQUIRED)
find_package(fmt REQUIRED)
find_package(nlohmann_json REQUIRED)
# Embree 4 is what distributions have since 2024; 3.13 is that of Debian 12 and Ubuntu 22.04. Images are the same.
find_package(embree 4 QUIET)
if(NOT embree_FOUND)
  find_package(embree 3.13 REQUIRED)
endif()
add_library(orbs_embree INTERFACE)
target_link_libraries(orbs_embree INTERFACE embree)
target_compile_definitions(orbs_embree INTERFACE ORBS_EMBREE_MAJOR=${EMBREE_VERSION_MAJOR})
find_package(ZLIB REQUIRED)
find_package(OpenEXR CONFIG REQUIRED)
find_package(PNG REQUIRED)
find_path(ORBS_CLI11_INCLUDE CLI/CLI.hpp REQUIRED)
add_library(orbs_cli11 INTERFACE)
target_include_directories(orbs_cli11 SYSTEM INTERFACE ${ORBS_CLI11_INCLUDE})
# Its headers alone: importer/library/compiled.cpp compiles what we need of them.
find_path(ORBS_TINYGLTF_INCLUDE tiny_gltf.h REQUIRED)
add_library(orbs_tinygltf INTERFACE)
find_path(ORBS_TINYGLTF_JSON json.hpp PATH_SUFFIXES nlohmann REQUIRED)
target_include_directories(orbs_tinygltf SYSTEM INTERFACE ${ORBS_TINYGLTF_INCLUDE} ${ORBS_TINYGLTF_JSON})

# Debian's OpenImageIOConfig.cmake refuses to load unless its eight command-line tools (with Qt) are installed too. We
# need two libraries, so we find these ourselves.
find_path(ORBS_OIIO_INCLUDE OpenImageIO/imageio.h REQUIRED)
find_library(ORBS_OIIO_LIBRARY OpenImageIO REQUIRED)
find_library(ORBS_OIIO_UTIL_LIBRARY OpenImageIO_Util REQUIRED)
add_library(orbs_oiio INTERFACE)
target_include_directories(orbs_oiio SYSTEM INTERFACE ${ORBS_OIIO_INCLUDE})
target_link_libraries(orbs_oiio INTERFACE ${ORBS_OIIO_LIBRARY} ${ORBS_OIIO_UTIL_LIBRARY})
