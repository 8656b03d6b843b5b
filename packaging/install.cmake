# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
#
# What `cmake --install` puts under a prefix. Nothing installed holds the prefix itself: the tree may be moved.
#   include/ode/*.h   lib/libode.so.8 and libode_single.so.8 with their links, or libode.a and libode_single.a
#                     (for Windows bin/libode.dll, lib/libode.dll.a and those of libode_single; for WebAssembly
#                     libode.a, and share/epode/web: epode.wasm and what loads it)
#   lib/pkgconfig/ode.pc, ode-single.pc
#   lib/cmake/ode, lib/cmake/epode     bin/ode-config, bin/epode    share/epode/replay.html     share/doc/epode     lib/epode: the recorder
#   include/epode/robots.h   lib/libepode_robots.so, where pugixml is there
#   include/drawstuff/*.h   lib/libdrawstuff.a   lib/pkgconfig/drawstuff.pc, where drawstuff is built (ODE::drawstuff in lib/cmake/ode)
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(EPODE_ODE_VERSION 0.16.2)
set(EPODE_CMAKE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/ode)
set(EPODE_PACKAGING ${PROJECT_SOURCE_DIR}/packaging)
set(EPODE_OUT ${PROJECT_BINARY_DIR}/packaging)

# The way from a folder of the installed tree back to its prefix.
file(RELATIVE_PATH EPODE_PREFIX_FROM_PC /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
file(RELATIVE_PATH EPODE_PREFIX_FROM_BIN /${CMAKE_INSTALL_BINDIR} /)
string(REGEX REPLACE "/$" "" EPODE_PREFIX_FROM_PC ${EPODE_PREFIX_FROM_PC})
string(REGEX REPLACE "/$" "" EPODE_PREFIX_FROM_BIN ${EPODE_PREFIX_FROM_BIN})

install(FILES ${EPODE_HEADERS} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/ode)
install(FILES LICENSE README.md CHANGES.md DESTINATION ${CMAKE_INSTALL_DOCDIR})

# What a program must name besides the library: a shared one brings it, a static one does not.
set(EPODE_PC_LIBS "")
set(EPODE_PC_PRIVATE "-lstdc++ -lm ${CMAKE_THREAD_LIBS_INIT}")
string(STRIP ${EPODE_PC_PRIVATE} EPODE_PC_PRIVATE)
if(EPODE_WASM)
  set(EPODE_PC_PRIVATE "-lc++ -lc++abi")
endif()
if(EPODE_STATIC)
  set(EPODE_PC_LIBS " ${EPODE_PC_PRIVATE}")
endif()

# install_ode(target LIBRARY PC PRECISION FLAG): library, links and pkg-config file of one precision.
function(install_ode target LIBRARY PC PRECISION FLAG)
  target_include_directories(${target} INTERFACE $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  install(TARGETS ${target} EXPORT ode-targets RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR}
          LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
  configure_file(${EPODE_PACKAGING}/ode.pc.in ${EPODE_OUT}/${PC}.pc @ONLY)
  install(FILES ${EPODE_OUT}/${PC}.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
endfunction()

# The compiler's default in our headers is double, so ode.pc needs no flag, as Debian's has none.
if("double" IN_LIST EPODE_PRECISIONS)
  install_ode(ode ode ode dDOUBLE "")
endif()
if("single" IN_LIST EPODE_PRECISIONS)
  install_ode(ode_single ode_single ode-single dSINGLE " -DdIDESINGLE")
endif()

# drawstuff is a static library and brings along what it wants, for the CMake package and for drawstuff.pc.
set(EPODE_DRAWSTUFF_WANTS "")
if(TARGET drawstuff)
  set(EPODE_DRAWSTUFF_WANTS epoxy stdc++ dl m)
  if(EPODE_DRAWSTUFF_HAS_WINDOWS)
    list(PREPEND EPODE_DRAWSTUFF_WANTS glfw)
  endif()
endif()
file(RELATIVE_PATH EPODE_PREFIX_FROM_CMAKE /${EPODE_CMAKE_DIR} /)
string(REGEX REPLACE "/$" "" EPODE_PREFIX_FROM_CMAKE ${EPODE_PREFIX_FROM_CMAKE})

# One file serves find_package(ODE) and find_package(ode): CMake looks for the name in lower case too.
configure_file(${EPODE_PACKAGING}/ode-config.cmake.in ${EPODE_OUT}/ode-config.cmake @ONLY)
write_basic_package_version_file(${EPODE_OUT}/ode-config-version.cmake VERSION ${EPODE_ODE_VERSION}
                                 COMPATIBILITY AnyNewerVersion)
install(FILES ${EPODE_OUT}/ode-config.cmake ${EPODE_OUT}/ode-config-version.cmake DESTINATION ${EPODE_CMAKE_DIR})
install(EXPORT ode-targets NAMESPACE ODE:: DESTINATION ${EPODE_CMAKE_DIR})
# And find_package(epode), by Epode's own version.
configure_file(${EPODE_PACKAGING}/epode-config.cmake.in ${EPODE_OUT}/epode-config.cmake @ONLY)
write_basic_package_version_file(${EPODE_OUT}/epode-config-version.cmake VERSION ${PROJECT_VERSION} COMPATIBILITY SameMinorVersion)
install(FILES ${EPODE_OUT}/epode-config.cmake ${EPODE_OUT}/epode-config-version.cmake
        DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/epode)

configure_file(${EPODE_PACKAGING}/ode-config.in ${EPODE_OUT}/ode-config @ONLY)
install(PROGRAMS ${EPODE_OUT}/ode-config DESTINATION ${CMAKE_INSTALL_BINDIR})

if(TARGET epode)
  file(RELATIVE_PATH EPODE_LIB_FROM_BIN /${CMAKE_INSTALL_BINDIR} /${CMAKE_INSTALL_LIBDIR})
  set_target_properties(epode PROPERTIES INSTALL_RPATH "$ORIGIN/${EPODE_LIB_FROM_BIN}")
  install(TARGETS epode RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
  if(TARGET epode_preload)
    # No program is linked with them.
    set_target_properties(epode_observer PROPERTIES INSTALL_RPATH "$ORIGIN/..")
    install(TARGETS epode_preload epode_observer LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}/epode)
  endif()
  # The replay page's template is there when record/page/build has made it; without it `epode --html` says so.
  install(FILES ${PROJECT_SOURCE_DIR}/build/page/replay.html DESTINATION share/epode OPTIONAL)
endif()

# libepode_robots and its headers: link with -lepode_robots.
if(TARGET epode_robots)
  set_target_properties(epode_robots PROPERTIES INSTALL_RPATH "$ORIGIN")
  install(FILES ${PROJECT_SOURCE_DIR}/include/epode/robots.h ${PROJECT_SOURCE_DIR}/include/epode/robot_sensors.h
          ${PROJECT_SOURCE_DIR}/include/epode/decomposition.h ${PROJECT_SOURCE_DIR}/include/epode/batch.h
          DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/epode)
  install(TARGETS epode_robots LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
endif()

if(TARGET drawstuff)
  list(TRANSFORM EPODE_DRAWSTUFF_WANTS PREPEND -l OUTPUT_VARIABLE EPODE_DRAWSTUFF_LIBS)
  list(JOIN EPODE_DRAWSTUFF_LIBS " " EPODE_DRAWSTUFF_LIBS)
  file(GLOB EPODE_DRAWSTUFF_HEADERS CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/include/drawstuff/*.h)
  install(FILES ${EPODE_DRAWSTUFF_HEADERS} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/drawstuff)
  install(TARGETS drawstuff ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
  configure_file(${EPODE_PACKAGING}/drawstuff.pc.in ${EPODE_OUT}/drawstuff.pc @ONLY)
  install(FILES ${EPODE_OUT}/drawstuff.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
endif()
