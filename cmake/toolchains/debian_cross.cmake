# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
#
# What Debian's cross compilers have in common. Before this is included, EPODE_TRIPLE names the target as GCC does, and
# CMAKE_SYSTEM_PROCESSOR the processor; EPODE_EMULATOR is what runs its programs (QEMU's for that processor where nothing is said).
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_C_COMPILER ${EPODE_TRIPLE}-gcc)
set(CMAKE_CXX_COMPILER ${EPODE_TRIPLE}-g++)
if(NOT EPODE_EMULATOR)
  set(EPODE_EMULATOR qemu-${CMAKE_SYSTEM_PROCESSOR} -L /usr/${EPODE_TRIPLE})
endif()
set(CMAKE_CROSSCOMPILING_EMULATOR "${EPODE_EMULATOR}" CACHE STRING "What runs the programs of the target")
# Libraries and packages of the target only: this machine's own would be found first.
set(CMAKE_FIND_ROOT_PATH /usr/${EPODE_TRIPLE})
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)
