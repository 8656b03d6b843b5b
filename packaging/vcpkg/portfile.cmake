# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
#
# A port of vcpkg, for an overlay (--overlay-ports): the library and its headers. scripts/release writes where the source is and its
# SHA512 in place of @URL@ and @SHA512@.
vcpkg_download_distfile(ARCHIVE URLS "@URL@" FILENAME "epode-${VERSION}.tar.gz" SHA512 @SHA512@)
vcpkg_extract_source_archive(SOURCE_PATH ARCHIVE "${ARCHIVE}")

set(PRECISIONS double)
if("single" IN_LIST FEATURES)
  set(PRECISIONS "double\;single")
endif()
vcpkg_cmake_configure(SOURCE_PATH "${SOURCE_PATH}"
                      OPTIONS "-DEPODE_PRECISIONS=${PRECISIONS}" -DEPODE_TESTS=OFF -DEPODE_TOOLS=OFF -DEPODE_INSTALL=ON)
vcpkg_cmake_install()
vcpkg_cmake_config_fixup(PACKAGE_NAME ode CONFIG_PATH lib/cmake/ode DO_NOT_DELETE_PARENT_CONFIG_PATH)
vcpkg_cmake_config_fixup(PACKAGE_NAME epode CONFIG_PATH lib/cmake/epode)
vcpkg_fixup_pkgconfig()
# Programs of a shell have no place in vcpkg's bin, and there is pkg-config.
if(NOT VCPKG_TARGET_IS_WINDOWS)
  file(REMOVE_RECURSE "${CURRENT_PACKAGES_DIR}/bin" "${CURRENT_PACKAGES_DIR}/debug/bin")
endif()
file(REMOVE_RECURSE "${CURRENT_PACKAGES_DIR}/debug/include" "${CURRENT_PACKAGES_DIR}/debug/share")
vcpkg_install_copyright(FILE_LIST "${SOURCE_PATH}/LICENSE")
