/* SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026 The Epode authors
 *
 * A client built against headers that are not ours, such as Debian's: plain declarations, nothing else.
 */
typedef struct dxWorld* dWorldID;
extern dWorldID dWorldCreate(void);
extern void dWorldDestroy(dWorldID world);
extern void dWorldSetGravity(dWorldID world, double x, double y, double z);
extern void dWorldGetGravity(dWorldID world, double* gravity);

int main(void)
{
    double gravity[4];
    dWorldID world = dWorldCreate();
    dWorldSetGravity(world, 1, 2, -9.81);
    dWorldGetGravity(world, gravity);
    dWorldDestroy(world);
    return gravity[0] == 1 && gravity[1] == 2 && gravity[2] == -9.81 ? 0 : 1;
}
