# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
#
# 32-bit ARM with VFPv3, as Debian's armhf: without NEON, whose floats flush denormal numbers to zero (`scripts/setup targets`).
set(EPODE_TRIPLE arm-linux-gnueabihf)
set(CMAKE_SYSTEM_PROCESSOR arm)
include(${CMAKE_CURRENT_LIST_DIR}/debian_cross.cmake)
