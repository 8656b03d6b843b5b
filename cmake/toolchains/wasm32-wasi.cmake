# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
#
# WebAssembly with WASI's C library, by Debian's clang 19 (`scripts/setup wasm` installs it); what is built runs under Node.
# One thread, no exceptions: that is how Debian builds the libraries of C and C++ for it.
set(CMAKE_SYSTEM_NAME Generic)  # CMake 3.25 does not know WASI; both are static libraries and programs alone
set(CMAKE_SYSTEM_PROCESSOR wasm32)
set(CMAKE_C_COMPILER clang-19)
set(CMAKE_CXX_COMPILER clang++-19)
set(CMAKE_C_COMPILER_TARGET wasm32-wasi)
set(CMAKE_CXX_COMPILER_TARGET wasm32-wasi)
set(CMAKE_AR llvm-ar-19)
set(CMAKE_RANLIB llvm-ranlib-19)
# Without its own folders, clang would find what WASI lacks in this machine's /usr/include.
set(headers "-nostdlibinc -isystem /usr/include/wasm32-wasi")
set(CMAKE_C_FLAGS_INIT "-msimd128 ${headers}")
set(CMAKE_CXX_FLAGS_INIT "-msimd128 -fno-exceptions -nostdlibinc -isystem /usr/include/wasm32-wasi/c++/v1 -isystem /usr/include/wasm32-wasi")
# The stack lies below the data: where it is exceeded, the program traps and overwrites nothing.
set(CMAKE_EXE_LINKER_FLAGS_INIT "-Wl,-z,stack-size=8388608 -Wl,--stack-first")
set(CMAKE_CROSSCOMPILING_EMULATOR node --no-warnings ${CMAKE_CURRENT_LIST_DIR}/../../tests/wasm/wasi.mjs)
set(CMAKE_FIND_ROOT_PATH /usr/lib/wasm32-wasi)
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)
