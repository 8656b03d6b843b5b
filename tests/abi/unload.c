/* SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026 The Epode authors
 *
 * unload FILE: a plug-in host that closes the library without dCloseODE, while threads of a step wait for work. They
 * must not run on in memory that is gone.
 */
#include <dlfcn.h>
#include <stdio.h>
#include <unistd.h>

typedef void* Handle;
typedef void (*Function)(void);

static Function find(void* library, const char* name)
{
    Function found = NULL;
    *(void**)&found = dlsym(library, name);
    return found;
}

#define CALL(result, name, ...) ((result(*)(__VA_ARGS__))find(library, name))

int main(int count, char** files)
{
    void* library = dlopen(count > 1 ? files[1] : "libode.so.8", RTLD_NOW);
    Handle world, last = NULL;
    int k, stepped;
    if (!library) return fprintf(stderr, "%s\n", dlerror()), 1;
    CALL(int, "dInitODE2", unsigned)(0);
    world = CALL(Handle, "dWorldCreate", void)();
    for (k = 0; k < 2000; ++k) {
        const Handle body = CALL(Handle, "dBodyCreate", Handle)(world);
        const Handle joint = CALL(Handle, "dJointCreateBall", Handle, Handle)(world, NULL);
        CALL(void, "dJointAttach", Handle, Handle, Handle)(joint, body, k % 20 ? last : NULL);
        last = body;
    }
    CALL(void, "dWorldSetStepThreads", Handle, int)(world, 4);
    stepped = CALL(int, "dWorldStepFast1", Handle, double, int)(world, 0.01, 4);
    dlclose(library);
    sleep(1);
    library = dlopen(count > 1 ? files[1] : "libode.so.8", RTLD_NOW);
    stepped += library ? CALL(int, "dWorldStepFast1", Handle, double, int)(world, 0.01, 4) : 0;
    CALL(void, "dWorldDestroy", Handle)(world);
    CALL(void, "dCloseODE", void)();
    printf("%d steps\n", stepped);
    return stepped != 2;
}
