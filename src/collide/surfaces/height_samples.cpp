// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "collide/surfaces/height_samples.h"

namespace epode {

bool HeightSamples::take(const HeightfieldData& data)
{
    if (data.source != HeightfieldData::Source::kCallback || !of(data).empty()) return true;
    const int first = heights_.size();
    for (int j = 0; j < data.nz; ++j)
        for (int i = 0; i < data.nx; ++i)
            if (!heights_.push(data.sample(i, j))) return false;
    return fields_.push({&data, first, data.nx * data.nz});
}

std::span<const Real> HeightSamples::of(const HeightfieldData& data) const
{
    for (const Field& field : fields_)
        if (field.data == &data)
            return heights_.span().subspan(std::size_t(field.first), std::size_t(field.count));
    return {};
}

}  // namespace epode
