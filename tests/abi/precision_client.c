/* SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026 The Epode authors
 *
 * A client that notices when the library reads its numbers as something else. C and C++.
 */
#include <ode/ode.h>

int main(void)
{
    dVector3 gravity;
    dWorldID world = dWorldCreate();
    dWorldSetGravity(world, 1, 2, REAL(-9.81));
    dWorldGetGravity(world, gravity);
    dWorldDestroy(world);
    return gravity[0] == 1 && gravity[1] == 2 && gravity[2] == REAL(-9.81) ? 0 : 1;
}
