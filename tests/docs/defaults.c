/* SPDX-License-Identifier: BSD-3-Clause */
/* Copyright (c) 2026 The Epode authors */
/* What dDefaultsText writes for each preset, an empty line between them, for the table of
   docs/guide/defaults.md (defaults.py). */
#include <ode/ext.h>
#include <ode/ode.h>
#include <stdio.h>

int main(void)
{
    static const int presets[] = {dDefaultsOde, dDefaultsGame, dDefaultsRobot};
    for (int i = 0; i < 3; ++i) {
        char text[16384];
        if (dDefaultsText(presets[i], text, sizeof text) >= (int)sizeof text) return 1;
        printf("%s\n", text);
    }
    return 0;
}
