// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The object lies in one of the frames. If that is not the library's, or ends elsewhere than the function's did, the
// function is gone and its stack is used by another one. A function's stack ends in the same place whenever it calls,
// but for arguments that do not fit into registers.
#include "base/stack_frames.h"

#if defined(__linux__)
#include <dlfcn.h>
#include <unwind.h>
#endif

namespace epode {

#if defined(__linux__)

namespace {

constexpr std::uintptr_t kArguments = 512;  // bytes

struct Search {
    std::uintptr_t object, bottom;
    std::uintptr_t frame = 0, code = 0;  // the last frame that does not lie further out than the object
    bool found = false;
};

_Unwind_Reason_Code look(_Unwind_Context* context, void* data)
{
    Search& search = *static_cast<Search*>(data);
    const std::uintptr_t bottom = _Unwind_GetCFA(context);
    search.found = bottom > search.object;
    if (search.found) return _URC_END_OF_STACK;
    search.frame = bottom, search.code = _Unwind_GetIP(context);
    return _URC_NO_REASON;
}

// Linked into the program itself, all of it looks like ours.
bool is_ours(std::uintptr_t code)
{
    Dl_info here, there;
    if (!dladdr(reinterpret_cast<const void*>(&look), &here)) return true;
    return dladdr(reinterpret_cast<const void*>(code - 1), &there) && there.dli_fbase == here.dli_fbase;
}

}  // namespace

bool may_be_running(const void* object, std::uintptr_t bottom)
{
    Search search{reinterpret_cast<std::uintptr_t>(object), bottom};
    _Unwind_Backtrace(look, &search);
    if (!search.found || search.code == 0) return true;
    const bool same = bottom == 0 || search.frame - bottom + kArguments <= 2 * kArguments;
    return same && is_ours(search.code);
}

#else

bool may_be_running(const void*, std::uintptr_t) { return true; }

#endif

}  // namespace epode
