// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Batches are scheduled from the leaves: a body comes as early as what hangs on it allows, those far from their
// roots first, so that a figure of eleven bodies takes four batches and a chain one for each body.
#include "solve/substeps/joint_forest.h"

#include <algorithm>
#include <utility>

#include "math/cholesky.h"

namespace epode {
namespace {

constexpr int kFullBundle = 8;                               // bodies
constexpr std::size_t kNobody = 0, kWorld = 1, kSpares = 2;  // nodes that are no body's

constexpr int triangle(int n) { return n * (n + 1) / 2; }

}  // namespace

bool JointForest::build(const RowSystem& system, std::span<const NetworkJoint> joints, Arena& arena)
{
    is_forest_ = false;
    const int count = int(joints.size() + system.bodies.size());  // joints, and roots
    bundles_ = arena.take<Bundle>(int(system.bodies.size()));
    links_ = arena.take<Link>(count);
    order_ = arena.take<int>(int(joints.size()));
    seen_ = arena.take_zeroed<unsigned char>(int(system.bodies.size()));
    if (arena.failed() || !list_ends(system, joints, arena)) return false;
    for (std::size_t j = 0; j < joints.size(); ++j) {
        const NetworkJoint& joint = joints[j];
        if (joint.moves(0) == joint.moves(1)) {
            if (!joint.moves(0) || joint.body[0] == joint.body[1]) return true;
            continue;
        }
        if (!grow(joints, joint.body[joint.moves(0) ? 0 : 1], int(j))) return true;
    }
    for (const NetworkJoint& joint : joints)
        if (joint.moves(0) && joint.moves(1) && !seen_[std::size_t(joint.body[0])] &&
            !grow(joints, joint.body[0], -1))
            return true;
    is_forest_ = joints_found_ == int(joints.size());
    return true;
}

// The joints of each body that moves, side by side.
bool JointForest::list_ends(const RowSystem& system, std::span<const NetworkJoint> joints, Arena& arena)
{
    first_ = arena.take_zeroed<int>(int(system.bodies.size()) + 2);
    ends_ = arena.take<int>(2 * int(joints.size()));
    if (arena.failed()) return false;
    const auto for_ends = [&](auto&& f) {
        for (std::size_t j = 0; j < joints.size(); ++j)
            for (int side = 0; side < 2; ++side)
                if (joints[j].moves(side)) f(std::size_t(joints[j].body[side]), int(j));
    };
    for_ends([&](std::size_t b, int) { ++first_[b + 2]; });
    for (std::size_t b = 2; b < first_.size(); ++b) first_[b] += first_[b - 1];
    for_ends([&](std::size_t b, int j) { ends_[std::size_t(first_[b + 1]++)] = j; });
    return true;
}

// The tree of a body; joint: holds it to what cannot move, or -1. False: there is a loop.
bool JointForest::grow(std::span<const NetworkJoint> joints, int body, int joint)
{
    const int first_link = links_found_, first_joint = joints_found_;
    if (seen_[std::size_t(body)]) return false;
    seen_[std::size_t(body)] = 1;
    add_link(body, -1, joint);
    for (int i = first_link; i < links_found_; ++i) {
        const Link& link = links_[std::size_t(i)];
        const int from = link.joint < 0 ? -1 : order_[std::size_t(link.joint)];
        if (!visit(joints, link.body, from)) return false;
    }
    end_tree(first_link, first_joint);
    return true;
}

void JointForest::add_link(int body, int parent, int joint)
{
    Link& link = links_[std::size_t(links_found_++)];
    link.body = body, link.parent = parent;
    link.joint = joint < 0 ? -1 : joints_found_;
    if (joint >= 0) order_[std::size_t(joints_found_++)] = joint;
}

// Adds what hangs on a body that was reached by this joint.
bool JointForest::visit(std::span<const NetworkJoint> joints, int body, int joint)
{
    for (int e = first_[std::size_t(body)]; e < first_[std::size_t(body) + 1]; ++e) {
        const int j = ends_[std::size_t(e)];
        if (j == joint) continue;
        const NetworkJoint& other = joints[std::size_t(j)];
        const int next = other.body[other.body[0] == body ? 1 : 0];
        if (!other.moves(0) || !other.moves(1) || seen_[std::size_t(next)]) return false;
        seen_[std::size_t(next)] = 1;
        add_link(next, body, j);
    }
    return true;
}

// Into a bundle of its own, unless the last one is not full.
void JointForest::end_tree(int first_link, int first_joint)
{
    Bundle* last = bundle_count_ > 0 ? &bundles_[std::size_t(bundle_count_ - 1)] : nullptr;
    if (!last || last->last_link - last->first_link >= kFullBundle) {
        last = &bundles_[std::size_t(bundle_count_++)];
        last->first = first_joint, last->first_link = first_link;
    }
    last->last = joints_found_, last->last_link = links_found_;
}

bool JointForest::prepare(std::span<const NetworkJoint> joints, Arena& arena)
{
    nodes_ = arena.take_zeroed<ForestNode>(int(seen_.size()) + kSpares);
    if (arena.failed() || !schedule(joints, arena)) return false;
    for (int i = 0; i < 6; ++i) node(-1, kNobody)->P[triangle(i) + i] = 1;
    for (Link& link : links_.first(std::size_t(links_found_))) {
        if (link.joint < 0) continue;
        const NetworkJoint& joint = joints[std::size_t(link.joint)];
        link.side = joint.body[0] == link.body && joint.moves(0) ? 0 : 1;
    }
    return take_numbers(arena);
}

bool JointForest::schedule(std::span<const NetworkJoint> joints, Arena& arena)
{
    batches_ = arena.take<Batch>(links_found_);
    next_ = arena.take<int>(links_found_ + 1);
    ready_ = arena.take_zeroed<int>(int(seen_.size()));
    if (arena.failed()) return false;
    for (int i = 0; i <= links_found_; ++i) next_[std::size_t(i)] = i;
    for (Bundle& bundle : bundles_.first(std::size_t(bundle_count_))) schedule(bundle, joints);
    return true;
}

// From the last link: in a tree, no link is farther from the root.
void JointForest::schedule(Bundle& bundle, std::span<const NetworkJoint> joints)
{
    bundle.first_batch = batch_count_;
    for (int i = bundle.last_link - 1; i >= bundle.first_link; --i) {
        const Link& link = links_[std::size_t(i)];
        const int earliest = std::max(bundle.first_batch, ready_[std::size_t(link.body)]);
        const int batch = first_open(earliest);
        enter(i, batch, link.joint < 0 ? 0 : joints[std::size_t(link.joint)].count);
        if (link.parent >= 0) {
            int& ready = ready_[std::size_t(link.parent)];
            ready = std::max(ready, batch + 1);
        }
    }
    bundle.last_batch = batch_count_;
}

int JointForest::first_open(int batch)
{
    int found = batch;
    while (next_[std::size_t(found)] != found) found = next_[std::size_t(found)];
    while (next_[std::size_t(batch)] != found) batch = std::exchange(next_[std::size_t(batch)], found);
    return found;
}

void JointForest::enter(int link, int batch, int rows)
{
    Batch& to = batches_[std::size_t(batch)];
    if (batch == batch_count_) {
        ++batch_count_;
        to.rows = 0, to.numbers.leaves = true;
        std::fill_n(to.link, kWide, -1);
        std::fill_n(to.numbers.body, kWide, node(-1, kNobody));
        std::fill_n(to.numbers.parent, kWide, node(-1, kWorld));
    }
    int lane = 0;
    while (to.link[lane] >= 0) ++lane;
    const Link& its = links_[std::size_t(link)];
    links_[std::size_t(link)].batch = batch;
    to.link[lane] = link, to.rows = std::max(to.rows, rows);
    to.numbers.leaves = to.numbers.leaves && ready_[std::size_t(its.body)] == 0;
    to.numbers.body[lane] = node(its.body, kNobody), to.numbers.parent[lane] = node(its.parent, kWorld);
    if (lane == kWide - 1) next_[std::size_t(batch)] = batch + 1;
}

bool JointForest::take_numbers(Arena& arena)
{
    int count = 0;
    const std::span<Batch> batches = batches_.first(std::size_t(batch_count_));
    for (const Batch& batch : batches) count += kBody + 25 * batch.rows + triangle(batch.rows);
    numbers_ = arena.take<ForestLanes>(count);
    if (arena.failed()) return false;
    ForestLanes* next = numbers_.data();
    for (Batch& batch : batches) {
        ForestBatch& b = batch.numbers;
        const int n = batch.rows;
        b.D = next, b.x = b.D + kBody, b.A = b.x + n, b.B = b.A + 6 * n, b.T = b.B + 6 * n;
        b.Y = b.T + 6 * n, b.Q = b.Y + 6 * n, next = b.Q + triangle(n);
    }
    return true;
}

// The mass matrix, or its inverse.
void JointForest::load_mass(const SolverBody& body, bool inverse, double* to)
{
    std::fill_n(to, kBody, 0.0);
    Sym3 s = body.inv_inertia;
    if (!inverse) invert_positive_definite(body.inv_inertia, s);
    const double mass = inverse ? double(body.inv_mass) : 1 / double(body.inv_mass);
    for (int i = 0; i < 3; ++i) to[triangle(i) + i] = mass;
    const Real numbers[] = {s.xx, s.xy, s.yy, s.xz, s.yz, s.zz};
    for (int i = 0, k = 0; i < 3; ++i)
        for (int j = 0; j <= i; ++j) to[triangle(3 + i) + 3 + j] = double(numbers[k++]);
}

void JointForest::factor(const RowSystem& system, std::size_t bundle, std::span<const NetworkJoint> joints,
                         std::span<const NetworkRow> rows)
{
    const Bundle& its = bundles_[bundle];
    for (int i = its.first_link; i < its.last_link; ++i) {
        const Link& link = links_[std::size_t(i)];
        const bool leaf = batches_[std::size_t(link.batch)].numbers.leaves;
        const auto body = std::size_t(link.body);
        load_mass(system.bodies[body], leaf, nodes_[body].P);
    }
    for (int i = its.first_batch; i < its.last_batch; ++i) {
        Batch& batch = batches_[std::size_t(i)];
        gather(batch, joints, rows);
        kernels_->factor(batch.numbers);
    }
}

void JointForest::gather(Batch& batch, std::span<const NetworkJoint> joints, std::span<const NetworkRow> rows)
{
    ForestBatch& b = batch.numbers;
    std::fill(b.x, b.T, ForestLanes{});
    b.rows = 0;
    for (int lane = 0; lane < kWide && batch.link[lane] >= 0; ++lane) {
        Link& link = links_[std::size_t(batch.link[lane])];
        link.count = 0;
        if (link.joint < 0) continue;
        const NetworkJoint& joint = joints[std::size_t(link.joint)];
        gather_rows(b, lane, link, rows.subspan(std::size_t(joint.first), std::size_t(joint.count)));
        b.rows = std::max(b.rows, link.count);
    }
}

void JointForest::gather_rows(const ForestBatch& b, int lane, Link& link, std::span<const NetworkRow> rows)
{
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const NetworkRow& row = rows[i];
        if (row.place != RowPlace::kFactor) continue;
        const auto load = [&](ForestLanes* to, int side) {
            for (int k = 0; k < 3; ++k)
                to[k][lane] = double(row.lin[side][k]), to[3 + k][lane] = double(row.ang[side][k]);
        };
        load(b.B + 6 * link.count, link.side);
        if (link.parent >= 0) load(b.A + 6 * link.count, 1 - link.side);
        b.x[link.count][lane] = double(row.C);
        link.row[link.count++] = static_cast<unsigned char>(i);
    }
}

// f(its place in a batch, its index) of each row in the factor.
template <typename F>
void JointForest::for_rows(const Bundle& bundle, std::span<const NetworkJoint> joints, F&& f)
{
    for (int i = bundle.first_batch; i < bundle.last_batch; ++i) {
        const Batch& batch = batches_[std::size_t(i)];
        for (int lane = 0; lane < kWide && batch.link[lane] >= 0; ++lane) {
            const Link& link = links_[std::size_t(batch.link[lane])];
            for (int k = 0; k < link.count; ++k)
                f(batch.numbers.x[k][lane], std::size_t(joints[std::size_t(link.joint)].first + link.row[k]));
        }
    }
}

void JointForest::solve(std::size_t bundle, std::span<const NetworkJoint> joints, std::span<double> x)
{
    const Bundle& its = bundles_[bundle];
    for (int i = its.first_link; i < its.last_link; ++i)
        std::fill_n(nodes_[std::size_t(links_[std::size_t(i)].body)].f, 6, 0.0);
    for (int i = its.first_batch; i < its.last_batch; ++i)
        std::fill_n(batches_[std::size_t(i)].numbers.x, batches_[std::size_t(i)].numbers.rows, ForestLanes{});
    for_rows(its, joints, [&](double& place, std::size_t row) { place = x[row]; });
    for (int i = its.first_batch; i < its.last_batch; ++i)
        kernels_->eliminate(batches_[std::size_t(i)].numbers);
    for (int i = its.last_batch - 1; i >= its.first_batch; --i)
        kernels_->substitute(batches_[std::size_t(i)].numbers);
    for_rows(its, joints, [&](double place, std::size_t row) { x[row] = place; });
}

}  // namespace epode
