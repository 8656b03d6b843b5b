// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Reads filters and calls the program's callback in the caller's floating-point modes.
#include "query/query_filter.h"

#include "base/float_environment.h"
#include "base/objects/struct_size.h"

namespace epode {

template <>
inline constexpr std::size_t kSmallestSize<dQueryFilter> = offsetof(dQueryFilter, skip_body);

// Only checks that the body's handle is alive.
struct AnyBody : Tagged {};
template <>
struct HandleOf<AnyBody> {
    using Id = dBodyID;
    static constexpr Tag kTag = Tag::kBody;
};

namespace {

constexpr dQueryFilter kEverything{sizeof(dQueryFilter), ~0ul, ~0ul, nullptr, nullptr, nullptr, 0};

}  // namespace

bool QueryFilter::keeps(dGeomID named) const
{
    if (!callback) return true;
    const CallerFloatEnvironment program;
    return callback(data, named) != 0;
}

bool read_filter(const dQueryFilter* given, const char* caller, QueryFilter& filter)
{
    if (!given) return true;
    const unsigned size = given->struct_size;
    if (!accepts_size<dQueryFilter>(size)) {
        refuse_for(caller, SizeRefusal<dQueryFilter>(size).text());
        return false;
    }
    const dQueryFilter whole = completed(*given, kEverything);
    if (whole.skip_body && !from_handle<AnyBody>(whole.skip_body)) {
        refuse_for(caller,
                   "skip_body of the filter is destroyed or no body (accepted: a body, or 0 for none)");
        return false;
    }
    filter = {whole.category_bits, whole.collide_bits, whole.skip_body,
              whole.callback,      whole.data,         whole.skip_overlaps != 0};
    return true;
}

}  // namespace epode

using namespace epode;

extern "C" int dQueryFilterInit(dQueryFilter* filter, unsigned struct_size)
{
    EPODE_SIZED_AS(filter, struct_size, 0);
    copy_sized(kEverything, filter, struct_size);
    return 1;
}
