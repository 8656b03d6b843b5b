# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
#
# What the port calls, without vcpkg: `cmake -DPORT=FOLDER -DFROM=ARCHIVE -DTO=FOLDER -DALL=OPTIONS -DJOBS=N -P vcpkg.cmake` builds and
# installs the port as vcpkg does for one triplet without debugging information, with OPTIONS for all of CMake. It has of vcpkg's functions what their manual says and this port asks for.
cmake_minimum_required(VERSION 3.25)
file(READ ${PORT}/vcpkg.json manifest)
string(JSON VERSION GET "${manifest}" version)
string(JSON PORT_NAME GET "${manifest}" name)
set(CURRENT_PACKAGES_DIR ${TO}/packages)
set(CURRENT_BUILDTREES_DIR ${TO}/buildtrees)
if(NOT DEFINED FEATURES)
  set(FEATURES core)
endif()

function(run)
  execute_process(COMMAND ${ARGN} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

function(vcpkg_download_distfile variable)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "FILENAME;SHA512" "URLS")
  file(SHA512 ${FROM} sum)
  if(NOT sum STREQUAL arg_SHA512)
    message(FATAL_ERROR "the port wants an archive of SHA512 ${arg_SHA512}, not ${sum}")
  endif()
  if(NOT arg_FILENAME OR NOT arg_URLS MATCHES "(^|/)${arg_FILENAME}$")
    message(FATAL_ERROR "the port fetches ${arg_URLS} as '${arg_FILENAME}'")
  endif()
  set(${variable} ${FROM} PARENT_SCOPE)
endfunction()

function(vcpkg_extract_source_archive variable)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "ARCHIVE" "")
  file(ARCHIVE_EXTRACT INPUT ${arg_ARCHIVE} DESTINATION ${CURRENT_BUILDTREES_DIR}/src)
  file(GLOB folders ${CURRENT_BUILDTREES_DIR}/src/*)
  list(LENGTH folders count)
  if(NOT count EQUAL 1)
    message(FATAL_ERROR "the archive has not one folder at its top: ${folders}")
  endif()
  set(${variable} ${folders} PARENT_SCOPE)
endfunction()

function(vcpkg_cmake_configure)
  cmake_parse_arguments(PARSE_ARGV 0 arg "" "SOURCE_PATH" "OPTIONS")
  run(${CMAKE_COMMAND} -S ${arg_SOURCE_PATH} -B ${CURRENT_BUILDTREES_DIR}/rel -G Ninja ${ALL} ${arg_OPTIONS}
      -DBUILD_SHARED_LIBS=ON -DCMAKE_INSTALL_PREFIX=${CURRENT_PACKAGES_DIR} -DCMAKE_INSTALL_LIBDIR=lib)
endfunction()

function(vcpkg_cmake_install)
  run(${CMAKE_COMMAND} --build ${CURRENT_BUILDTREES_DIR}/rel -j${JOBS})
  run(${CMAKE_COMMAND} --install ${CURRENT_BUILDTREES_DIR}/rel)
endfunction()

# The package moves to share/NAME, a level higher, and with the last of them goes lib/cmake.
function(vcpkg_cmake_config_fixup)
  cmake_parse_arguments(PARSE_ARGV 0 arg "DO_NOT_DELETE_PARENT_CONFIG_PATH" "PACKAGE_NAME;CONFIG_PATH" "")
  set(here ${CURRENT_PACKAGES_DIR}/${arg_CONFIG_PATH})
  if(NOT IS_DIRECTORY ${here})
    message(FATAL_ERROR "no ${here} to move")
  endif()
  file(MAKE_DIRECTORY ${CURRENT_PACKAGES_DIR}/share)
  file(RENAME ${here} ${CURRENT_PACKAGES_DIR}/share/${arg_PACKAGE_NAME})
  if(NOT arg_DO_NOT_DELETE_PARENT_CONFIG_PATH)
    cmake_path(GET here PARENT_PATH parent)
    file(REMOVE_RECURSE ${parent})
  endif()
  file(GLOB targets ${CURRENT_PACKAGES_DIR}/share/${arg_PACKAGE_NAME}/*-targets.cmake)
  foreach(file IN LISTS targets)
    file(READ ${file} text)
    string(REGEX REPLACE "(get_filename_component\\(_IMPORT_PREFIX)[^\n]*\n(get_filename_component\\(_IMPORT_PREFIX[^\n]*\n)+"
           "\\1 \"\${CMAKE_CURRENT_LIST_DIR}/../../\" ABSOLUTE)\n" text "${text}")
    file(WRITE ${file} "${text}")
  endforeach()
endfunction()

function(vcpkg_fixup_pkgconfig)
endfunction()

function(vcpkg_install_copyright)
  cmake_parse_arguments(PARSE_ARGV 0 arg "" "" "FILE_LIST")
  file(MAKE_DIRECTORY ${CURRENT_PACKAGES_DIR}/share/${PORT_NAME})
  file(COPY_FILE ${arg_FILE_LIST} ${CURRENT_PACKAGES_DIR}/share/${PORT_NAME}/copyright)
endfunction()

include(${PORT}/portfile.cmake)
