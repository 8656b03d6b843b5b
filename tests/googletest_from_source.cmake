# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
#
# GoogleTest for another machine: Debian has its sources (package googletest), compiled here by the cross compiler.
# WebAssembly has neither threads nor processes for it.
set(EPODE_GOOGLETEST /usr/src/googletest/googletest CACHE PATH "GoogleTest's sources, for cross builds")
add_library(epode_gtest_main STATIC ${EPODE_GOOGLETEST}/src/gtest-all.cc ${EPODE_GOOGLETEST}/src/gtest_main.cc)
target_include_directories(epode_gtest_main SYSTEM PUBLIC ${EPODE_GOOGLETEST}/include PRIVATE ${EPODE_GOOGLETEST})
target_compile_options(epode_gtest_main PRIVATE -w)
if(EPODE_WASM)
  target_compile_definitions(epode_gtest_main PUBLIC GTEST_HAS_PTHREAD=0 GTEST_HAS_STREAM_REDIRECTION=0 GTEST_HAS_DEATH_TEST=0)
endif()
target_link_libraries(epode_gtest_main PUBLIC ${EPODE_SYSTEM})
add_library(GTest::gtest ALIAS epode_gtest_main)
add_library(GTest::gtest_main ALIAS epode_gtest_main)
