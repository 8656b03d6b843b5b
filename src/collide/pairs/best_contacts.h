// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Keeps the first contacts in an order, as many as the sink can hold. The client's array is the heap, with
// the last of the kept contacts on top; it is sorted at the end. No memory, n log(capacity) steps.
//   before(a, b)  a strict total order of dContactGeom.
#pragma once

#include <utility>

#include "collide/contact_sink.h"

namespace epode {

template <typename Before>
class BestContacts {
  public:
    BestContacts(ContactSink& sink, Before before) : sink_(sink), base_(sink.count()), before_(before) {}

    void add(const ContactPoint& point)
    {
        if (sink_.add(point)) {
            if (!sink_.unimportant()) rise(sink_.count() - base_ - 1);
            return;
        }
        if (sink_.unimportant() || sink_.count() == base_) return;
        dContactGeom candidate = {};
        ContactSink one(&candidate, sizeof(candidate), 1, false);
        one.add(point);
        if (!before_(candidate, at(0))) return;
        at(0) = candidate;
        settle(0, sink_.count() - base_);
    }

    // Contacts that nobody minds the order of stay as they were found.
    void finish()
    {
        if (sink_.unimportant()) return;
        for (int last = sink_.count() - base_ - 1; last > 0; --last) {
            std::swap(at(0), at(last));
            settle(0, last);
        }
    }

  private:
    dContactGeom& at(int i) { return *sink_.at(base_ + i); }

    void rise(int i)
    {
        for (; i > 0 && before_(at((i - 1) / 2), at(i)); i = (i - 1) / 2) std::swap(at((i - 1) / 2), at(i));
    }

    void settle(int i, int count)
    {
        for (;;) {
            int last = i;
            for (const int child : {2 * i + 1, 2 * i + 2})
                if (child < count && before_(at(last), at(child))) last = child;
            if (last == i) return;
            std::swap(at(i), at(last));
            i = last;
        }
    }

    ContactSink& sink_;
    int base_;
    Before before_;
};

}  // namespace epode
