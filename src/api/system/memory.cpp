// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The client's memory hooks, and the same memory for the client. Hooks are meant to be set before anything is
// made: a block is freed by the hook in force then, which ODE leaves to the client too.
#include "base/memory.h"

using namespace epode;

extern "C" void dSetAllocHandler(dAllocFunction* fn) { memory_hooks().alloc = fn; }
extern "C" void dSetReallocHandler(dReallocFunction* fn) { memory_hooks().realloc = fn; }
extern "C" void dSetFreeHandler(dFreeFunction* fn) { memory_hooks().free = fn; }

extern "C" dAllocFunction* dGetAllocHandler(void) { return memory_hooks().alloc; }
extern "C" dReallocFunction* dGetReallocHandler(void) { return memory_hooks().realloc; }
extern "C" dFreeFunction* dGetFreeHandler(void) { return memory_hooks().free; }

extern "C" void* dAlloc(dsizeint size) { return raw_allocate(size); }
extern "C" void* dRealloc(void* ptr, dsizeint oldsize, dsizeint newsize)
{
    return raw_reallocate(ptr, oldsize, newsize);
}
extern "C" void dFree(void* ptr, dsizeint size) { raw_free(ptr, size); }
