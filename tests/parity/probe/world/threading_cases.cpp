// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// In which order a self-threaded implementation runs calls: those that wait together, those that become
// ready when others are done, and those posted from inside a call.
#include <ode/ode.h>

#include <string>

#include "case_list.h"

namespace parity {
namespace {

class Calls {
  public:
    Calls() : functions_(dThreadingImplementationGetFunctions(id_)), wait_(functions_->alloc_call_wait(id_))
    {}
    ~Calls()
    {
        functions_->free_call_wait(id_, wait_);
        dThreadingFreeImplementation(id_);
    }
    Calls(const Calls&) = delete;
    Calls& operator=(const Calls&) = delete;

    dCallReleaseeID post(std::size_t index, std::size_t dependencies = 0, dCallReleaseeID dependent = nullptr)
    {
        dCallReleaseeID own = nullptr;
        functions_->post_call(id_, nullptr, &own, dependencies, dependent, wait_, &run, this, index, "call");
        return own;
    }
    std::string order_of_all()
    {
        functions_->wait_call(id_, nullptr, wait_, nullptr, "all");
        return order_;
    }

  private:
    static int run(void* context, dcallindex_t index, dCallReleaseeID)
    {
        Calls& calls = *static_cast<Calls*>(context);
        calls.order_ += static_cast<char>('a' + index);
        if (index == 20) { calls.post(5), calls.post(6); }
        return 1;
    }

    dThreadingImplementationID id_ = dThreadingAllocateSelfThreadedImplementation();
    const dThreadingFunctionsInfo* functions_;
    dCallWaitID wait_;
    std::string order_;
};

PARITY_CASE(service_order_of_calls)
{
    Calls together;
    for (std::size_t i = 0; i < 5; ++i) { together.post(i); }
    out.put_text("together", together.order_of_all());

    Calls after;
    const dCallReleaseeID last = after.post(0, 3);
    for (std::size_t i = 1; i < 4; ++i) { after.post(i, 0, last); }
    after.post(4);
    out.put_text("after", after.order_of_all());

    Calls inside;
    inside.post(0), inside.post(20), inside.post(1);
    out.put_text("inside", inside.order_of_all());
}

}  // namespace
}  // namespace parity
