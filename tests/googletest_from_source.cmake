# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
#
# GoogleTest for another machine: Debian has its sources (package googletest), compiled here by the cross compiler.
set(EPODE_GOOGLETEST /usr/src/googletest/googletest CACHE PATH "GoogleTest's sources, for cross builds")
find_package(Threads REQUIRED)
add_library(epode_gtest_main STATIC ${EPODE_GOOGLETEST}/src/gtest-all.cc ${EPODE_GOOGLETEST}/src/gtest_main.cc)
target_include_directories(epode_gtest_main SYSTEM PUBLIC ${EPODE_GOOGLETEST}/include PRIVATE ${EPODE_GOOGLETEST})
target_compile_options(epode_gtest_main PRIVATE -w)
target_link_libraries(epode_gtest_main PUBLIC Threads::Threads)
add_library(GTest::gtest ALIAS epode_gtest_main)
add_library(GTest::gtest_main ALIAS epode_gtest_main)
