// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What a state says of a world's contacts besides the pairs, until it is accepted.
#pragma once

#include "contacts/contact_world.h"

namespace epode {

class ContactWorld::Loaded {
    friend class ContactWorld;
    void clear()
    {
        rests.clear(), ended.clear();
        h = 0;
        few_active = unfinished = settled = any_rests = false;
    }
    Array<float> rests;  // of each pair: the size of the step since which it rests; 0: it does not
    Array<dContactEvent> ended;
    Real h = 0;
    bool few_active = false, unfinished = false, settled = false, any_rests = false;
};

}  // namespace epode
