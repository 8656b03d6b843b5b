// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Triangles are stored by rows. A pivot that is not above zero becomes one, which leaves its row alone. Every
// diagonal element of K gets a billionth of itself added: redundant rows then have a factor.
#include "solve/substeps/joint_forest.h"

#include <algorithm>
#include <cmath>

#include "math/cholesky.h"

namespace epode {
namespace {

constexpr int triangle(int n) { return n * (n + 1) / 2; }

// A = L L^T in place.
inline void factor_triangle(double* A, int n)
{
    for (int i = 0; i < n; ++i) {
        double* const row = A + triangle(i);
        for (int j = 0; j <= i; ++j) {
            const double* const other = A + triangle(j);
            double sum = row[j];
            for (int k = 0; k < j; ++k) sum -= row[k] * other[k];
            if (j < i)
                row[j] = sum * other[j];
            else
                row[j] = sum > 0 ? 1 / std::sqrt(sum) : 1;  // the reciprocal
        }
    }
}

// x = L^-1 x
inline void forward(const double* L, int n, double* x)
{
    for (int i = 0; i < n; ++i) {
        const double* const row = L + triangle(i);
        double sum = x[i];
        for (int k = 0; k < i; ++k) sum -= row[k] * x[k];
        x[i] = sum * row[i];
    }
}

// x = L^-T x
inline void backward(const double* L, int n, double* x)
{
    for (int i = n - 1; i >= 0; --i) {
        const double* const row = L + triangle(i);
        x[i] *= row[i];
        for (int k = 0; k < i; ++k) x[k] -= row[k] * x[i];
    }
}

inline double dot6(const double* a, const double* b)
{
    return ((a[0] * b[0] + a[1] * b[1]) + (a[2] * b[2] + a[3] * b[3])) + (a[4] * b[4] + a[5] * b[5]);
}

inline void add6(double s, const double* a, double* to)
{
    for (int i = 0; i < 6; ++i) to[i] += s * a[i];
}

inline void load_row(const NetworkRow& row, int side, double* J)
{
    for (int i = 0; i < 3; ++i) J[i] = double(row.lin[side][i]), J[3 + i] = double(row.ang[side][i]);
}

}  // namespace

bool JointForest::build(const RowSystem& system, std::span<const NetworkJoint> joints, Arena& arena)
{
    is_forest_ = false;
    trees_ = arena.take<Tree>(int(joints.size()));
    links_ = arena.take<Link>(int(joints.size()));
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
    is_forest_ = links_found_ == int(joints.size());
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
    Tree& tree = trees_[std::size_t(tree_count_++)];
    tree.first = links_found_, tree.root = joint < 0 ? body : -1;
    if (seen_[std::size_t(body)]) return false;
    seen_[std::size_t(body)] = 1;
    if (joint >= 0) {
        add_link(body, -1, joint);
    } else if (!visit(joints, body, -1)) {
        return false;
    }
    for (int i = tree.first; i < links_found_; ++i)
        if (!visit(joints, links_[std::size_t(i)].body, order_[std::size_t(i)])) return false;
    tree.last = links_found_;
    return true;
}

void JointForest::add_link(int body, int parent, int joint)
{
    Link& link = links_[std::size_t(links_found_)];
    link.body = body, link.parent = parent;
    order_[std::size_t(links_found_++)] = joint;
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

bool JointForest::prepare(std::span<const NetworkJoint> joints, Arena& arena)
{
    int numbers = 0;
    for (const NetworkJoint& joint : joints) numbers += kBody + 12 * joint.count + triangle(joint.count);
    numbers_ = arena.take<double>(numbers);
    roots_ = arena.take<double>(kBody * tree_count_);
    nodes_ = arena.take<Node>(int(seen_.size()));
    if (arena.failed()) return false;
    double* next = numbers_.data();
    for (std::size_t i = 0; i < joints.size(); ++i) {
        Link& link = links_[i];
        const int n = joints[i].count;
        link.side = joints[i].body[0] == link.body && joints[i].moves(0) ? 0 : 1;
        link.L = next, link.W = link.L + kBody, link.G = link.W + 6 * n, link.U = link.G + triangle(n);
        next = link.U + 6 * n;
    }
    return true;
}

void JointForest::load_mass(const SolverBody& body, Node& node) const
{
    std::fill(node.P, node.P + kBody, 0.0);
    Sym3 inertia{};
    invert_positive_definite(body.inv_inertia, inertia);
    for (int i = 0; i < 3; ++i) node.P[triangle(i) + i] = 1 / double(body.inv_mass);
    const Real numbers[] = {inertia.xx, inertia.xy, inertia.yy, inertia.xz, inertia.yz, inertia.zz};
    for (int i = 0, k = 0; i < 3; ++i)
        for (int j = 0; j <= i; ++j) node.P[triangle(3 + i) + 3 + j] = double(numbers[k++]);
}

void JointForest::factor(const RowSystem& system, std::size_t tree, std::span<const NetworkJoint> joints,
                         std::span<const NetworkRow> rows)
{
    const Tree& its = trees_[tree];
    const auto load = [&](int b) { load_mass(system.bodies[std::size_t(b)], nodes_[std::size_t(b)]); };
    if (its.root >= 0) load(its.root);
    for (int i = its.first; i < its.last; ++i) load(links_[std::size_t(i)].body);
    for (int i = its.last - 1; i >= its.first; --i) {
        const NetworkJoint& joint = joints[std::size_t(i)];
        factor_link(links_[std::size_t(i)], rows.subspan(std::size_t(joint.first), std::size_t(joint.count)));
    }
    if (its.root < 0) return;
    double* const L = roots_.data() + kBody * tree;
    std::copy_n(nodes_[std::size_t(its.root)].P, kBody, L);
    factor_triangle(L, 6);
}

void JointForest::factor_link(Link& link, std::span<const NetworkRow> rows)
{
    std::copy_n(nodes_[std::size_t(link.body)].P, kBody, link.L);
    factor_triangle(link.L, 6);
    link.count = 0;
    for (std::size_t i = 0; i < rows.size(); ++i)
        if (rows[i].place == RowPlace::kFactor) link.row[link.count++] = static_cast<unsigned char>(i);
    for (int i = 0; i < link.count; ++i) {
        const NetworkRow& row = rows[link.row[i]];
        double* const w = link.W + 6 * i;
        load_row(row, link.side, w);
        forward(link.L, 6, w);
        double* const k = link.G + triangle(i);
        for (int j = 0; j <= i; ++j) k[j] = dot6(w, link.W + 6 * j);
        k[i] += kFirm * k[i] + double(row.C);
    }
    factor_triangle(link.G, link.count);
    if (link.parent >= 0) hand_on(link, rows);
}

// U, and what the parent carries.
void JointForest::hand_on(const Link& link, std::span<const NetworkRow> rows)
{
    double* const P = nodes_[std::size_t(link.parent)].P;
    for (int i = 0; i < link.count; ++i) {
        double* const u = link.U + 6 * i;
        const double* const g = link.G + triangle(i);
        load_row(rows[link.row[i]], 1 - link.side, u);
        for (int k = 0; k < i; ++k) add6(-g[k], link.U + 6 * k, u);
        for (int k = 0; k < 6; ++k) u[k] *= g[i];
        for (int a = 0; a < 6; ++a)
            for (int b = 0; b <= a; ++b) P[triangle(a) + b] += u[a] * u[b];
    }
}

void JointForest::solve(std::size_t tree, std::span<const NetworkJoint> joints, std::span<double> x)
{
    const Tree& its = trees_[tree];
    const auto clear = [&](int b) { std::fill_n(nodes_[std::size_t(b)].f, 6, 0.0); };
    if (its.root >= 0) clear(its.root);
    for (int i = its.first; i < its.last; ++i) clear(links_[std::size_t(i)].body);
    for (int i = its.last - 1; i >= its.first; --i)
        eliminate(links_[std::size_t(i)], x.data() + joints[std::size_t(i)].first);
    if (its.root >= 0) {
        Node& root = nodes_[std::size_t(its.root)];
        std::copy_n(root.f, 6, root.dv);
        forward(roots_.data() + kBody * tree, 6, root.dv);
        backward(roots_.data() + kBody * tree, 6, root.dv);
    }
    for (int i = its.first; i < its.last; ++i)
        substitute(links_[std::size_t(i)], x.data() + joints[std::size_t(i)].first);
}

void JointForest::eliminate(Link& link, double* x)
{
    std::copy_n(nodes_[std::size_t(link.body)].f, 6, link.z);
    forward(link.L, 6, link.z);
    double g[kMaxRows];
    for (int i = 0; i < link.count; ++i) g[i] = x[link.row[i]] - dot6(link.W + 6 * i, link.z);
    forward(link.G, link.count, g);
    for (int i = 0; i < link.count; ++i) x[link.row[i]] = g[i];
    if (link.parent < 0) return;
    double* const f = nodes_[std::size_t(link.parent)].f;
    for (int i = 0; i < link.count; ++i) add6(g[i], link.U + 6 * i, f);
}

void JointForest::substitute(Link& link, double* x)
{
    double y[kMaxRows];
    for (int i = 0; i < link.count; ++i) y[i] = x[link.row[i]];
    if (link.parent >= 0)
        for (int i = 0; i < link.count; ++i)
            y[i] -= dot6(link.U + 6 * i, nodes_[std::size_t(link.parent)].dv);
    backward(link.G, link.count, y);
    double* const dv = nodes_[std::size_t(link.body)].dv;
    std::copy_n(link.z, 6, dv);
    for (int i = 0; i < link.count; ++i) add6(y[i], link.W + 6 * i, dv), x[link.row[i]] = y[i];
    backward(link.L, 6, dv);
}

}  // namespace epode
