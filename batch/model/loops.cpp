// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See loops.h.
#include "batch/model/loops.h"

#include <algorithm>
#include <set>

namespace epode::batch {

using namespace robots;

namespace {

std::vector<int> chain_to(const BatchModel& model, int last)
{
    if (last < 0) return {};
    const Dof& dof = model.dofs[size_t(last)];
    const auto first = model.chains.begin() + dof.chain;
    return {first, first + dof.depth + 1};
}

int add_pose(BatchModel& out, const Pose& at)
{
    const int first = int(out.numbers.size());
    out.numbers.insert(out.numbers.end(), {at.p.x, at.p.y, at.p.z, at.q.w, at.q.x, at.q.y, at.q.z});
    return first;
}

}  // namespace

// What nothing can move is no loop.
void add_loops(BatchModel& out, const RobotModel& model)
{
    std::set<int> moved;
    for (const Closure& closure : model.closures) {
        BatchLoop its;
        its.link_a = closure.link1, its.link_b = closure.link2, its.is_weld = closure.weld;
        const int ends[] = {out.links[size_t(its.link_a)].last_dof, out.links[size_t(its.link_b)].last_dof};
        if (its.link_a == its.link_b || std::max(ends[0], ends[1]) < 0) continue;
        its.first_a = add_pose(out, closure.pose1), its.first_b = add_pose(out, closure.pose2);
        its.row = out.loop_rows, out.loop_rows += its.rows();
        out.loops.push_back(its);
        for (const int end : ends)
            for (const int dof : chain_to(out, end)) moved.insert(dof);
    }
    out.loop_dofs.assign(moved.begin(), moved.end());
    if (out.loops.empty()) return;
    out.loop_places.assign(out.dofs.size(), -1);
    for (size_t i = 0; i < out.loop_dofs.size(); ++i) out.loop_places[size_t(out.loop_dofs[i])] = int(i);
}

std::vector<int> widened(const BatchModel& model, std::vector<int> dofs)
{
    const auto has = [&](const std::vector<int>& all, int dof) {
        return std::find(all.begin(), all.end(), dof) != all.end();
    };
    const std::vector<int> own = dofs;
    if (std::none_of(own.begin(), own.end(), [&](int dof) { return has(model.loop_dofs, dof); })) return dofs;
    for (const int dof : model.loop_dofs)
        if (!has(own, dof)) dofs.push_back(dof);
    return dofs;
}

int add_places(BatchModel& out, const std::vector<int>& dofs)
{
    std::vector<int> places;
    for (const int dof : out.loop_dofs) {
        const auto found = std::find(dofs.begin(), dofs.end(), dof);
        if (found == dofs.end()) return -1;
        places.push_back(int(found - dofs.begin()));
    }
    if (places.empty()) return -1;
    out.places.insert(out.places.end(), places.begin(), places.end());
    return int(out.places.size() - places.size());
}

void widen_dofs(BatchModel& out)
{
    if (out.loops.empty()) return;
    for (size_t i = 0; i < out.dofs.size(); ++i) {
        Dof& dof = out.dofs[i];
        if (dof.limit < 0 && dof.dry < 0 && dof.servo < 0) continue;
        const std::vector<int> wide = widened(out, chain_to(out, int(i)));
        Support its;
        its.first = int(out.support_dofs.size()), its.of_a = dof.depth + 1, its.width = int(wide.size());
        its.places = add_places(out, wide);
        if (its.places < 0) continue;
        dof.wide = int(out.supports.size()), dof.wide_y = out.wide;
        out.wide += its.width;
        out.support_dofs.insert(out.support_dofs.end(), wide.begin(), wide.end());
        out.supports.push_back(its);
    }
}

}  // namespace epode::batch
