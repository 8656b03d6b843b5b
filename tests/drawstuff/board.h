/* SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026 The Epode authors
 *
 * The board that every.c draws, seen from above: cells two metres wide at height 1. Row 0 shows each shape by
 * floats, row 1 by doubles, row 2 the styles. pictures_test.cpp reads it too, to know where the cells are. */
#ifndef EPODE_TESTS_BOARD_H
#define EPODE_TESTS_BOARD_H

#define BOARD_WIDTH 480
#define BOARD_HEIGHT 300

/* Columns go to the right in the picture (-y), rows up (+x). */
#define BOARD_X(row) (2.0f + 2.0f * (float)(row))
#define BOARD_Y(column) (7.0f - 2.0f * (float)(column))
#define BOARD_EYE \
    {             \
        4, 0, 11  \
    }
#define BOARD_LOOK \
    {              \
        0, -90, 0  \
    }

#endif
