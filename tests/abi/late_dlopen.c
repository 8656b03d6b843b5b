/* SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026 The Epode authors
 *
 * late_dlopen FILE...: a host that opens plug-ins when it has long been running, each with a library of its own.
 * Every FILE is a copy of libode.so.8; all stay open, and in each a ball meets a height field whose heights the host
 * computes, so that what a thread has of its own is used too. A library that asks for room in the static TLS block
 * cannot be opened as often: the loader keeps a few hundred bytes there for those that come late.
 */
#include <dlfcn.h>
#include <stdio.h>
#include <stdlib.h>

typedef double Real;
typedef void* Handle;

static Real flat(void* user, int x, int z)
{
    (void)user, (void)x, (void)z;
    return 0.25;
}

struct Library {
    void* handle;
    int missing;
};

typedef void (*Function)(void);

static Function find(struct Library* library, const char* name)
{
    Function found = NULL;
    *(void**)&found = dlsym(library->handle, name);
    if (!found) library->missing = 1;
    return found;
}

#define CALL(result, name, ...) ((result(*)(__VA_ARGS__))find(&library, name))

/* 1 if a ball of half a metre collides with ground at a quarter, in a library opened from that file. */
static int works(const char* file)
{
    struct Library library = {dlopen(file, RTLD_NOW | RTLD_LOCAL), 0};
    Handle data, ground, ball;
    char contacts[8 * 128];
    int touches;
    if (!library.handle) {
        fprintf(stderr, "%s\n", dlerror());
        return 0;
    }
    CALL(int, "dInitODE2", unsigned)(0);
    data = CALL(Handle, "dGeomHeightfieldDataCreate", void)();
    CALL(void, "dGeomHeightfieldDataBuildCallback", Handle, void*, Real (*)(void*, int, int), Real, Real, int, int, Real,
         Real, Real, int)(data, NULL, flat, 10, 10, 11, 11, 1, 0, 1, 0);
    ground = CALL(Handle, "dCreateHeightfield", Handle, Handle, int)(NULL, data, 1);
    ball = CALL(Handle, "dCreateSphere", Handle, Real)(NULL, 0.5);
    CALL(void, "dGeomSetPosition", Handle, Real, Real, Real)(ball, 0.3, 0.7, 0.2);
    touches = CALL(int, "dCollide", Handle, Handle, int, void*, int)(ball, ground, 1, contacts, 128);
    CALL(void, "dGeomSetPosition", Handle, Real, Real, Real)(ball, 0.3, 0.8, 0.2);
    touches -= 2 * CALL(int, "dCollide", Handle, Handle, int, void*, int)(ball, ground, 1, contacts, 128);
    if (library.missing || touches != 1) fprintf(stderr, "%s: does not collide: %d\n", file, touches);
    return !library.missing && touches == 1;
}

int main(int argc, char** argv)
{
    int i;
    for (i = 1; i < argc; i++)
        if (!works(argv[i])) {
            fprintf(stderr, "late_dlopen: %d of %d copies opened\n", i - 1, argc - 1);
            return 1;
        }
    printf("late_dlopen: %d copies opened\n", argc - 1);
    return argc > 1 ? 0 : 1;
}
