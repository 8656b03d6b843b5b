// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The table of joint types by number, and who has been refused already: without a handler a message is
// printed once per C function, as EPODE_USER does once per call site.
#include "joints/registry.h"

namespace epode {

const JointType* joint_type(int number)
{
    static constexpr const JointType* kTypes[] = {
#define JOINT_TYPE(Name, Number) &k##Name##Type,
#include "joints/joint_types.inc"
#undef JOINT_TYPE
    };
    for (const JointType* type : kTypes)
        if (type->number == number) return type;
    return nullptr;
}

void refuse_for(const char* caller, const char* text)
{
    static std::atomic<const char*> refused[256] = {};
    std::atomic<bool> told{true};  // silent once the table is full, which the number of functions forbids
    for (std::atomic<const char*>& slot : refused) {
        const char* present = nullptr;
        const bool first = slot.compare_exchange_strong(present, caller);
        if (!first && present != caller) continue;
        told = !first;
        break;
    }
    refuse(text, caller, told);
}

}  // namespace epode
