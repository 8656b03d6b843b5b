// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Kinematic bodies have no unknowns: what they contribute to J v is moved to the right-hand side. A row whose
// Jacobian is empty gets d = C, so that no division by zero can follow from it.
#include "solve/exact_problem.h"

#include <algorithm>
#include <cmath>

namespace epode {
namespace {

void multiply(const double* S, const double* x, double* y)
{
    y[0] = S[0] * x[0] + S[3] * x[1] + S[4] * x[2];
    y[1] = S[3] * x[0] + S[1] * x[1] + S[5] * x[2];
    y[2] = S[4] * x[0] + S[5] * x[1] + S[2] * x[2];
}

void copy(const Sym3& s, double* out)
{
    const double six[] = {s.xx, s.yy, s.zz, s.xy, s.xz, s.yz};
    std::copy_n(six, 6, out);
}

void put(Vec3 a, double* out) { out[0] = a.x, out[1] = a.y, out[2] = a.z; }

// block += s x y^T, 6x6 column-major
void add_outer(double* block, double s, const double* x, const double* y)
{
    const DoubleLane* a = reinterpret_cast<const DoubleLane*>(x);
    DoubleLane* out = reinterpret_cast<DoubleLane*>(block);
    for (int c = 0; c < 6; ++c) {
        const double sy = s * y[c];
        for (int r = 0; r < 3; ++r) out[3 * c + r] += a[r] * sy;
    }
}

}  // namespace

bool ExactProblem::build(const RowSystem& system, Arena& arena)
{
    rows_ = arena.take<ExactRow>(int(system.rows.size()));
    if (arena.failed() || !number_bodies(system, arena)) return false;
    fill_rows(system);
    return true;
}

bool ExactProblem::number_bodies(const RowSystem& system, Arena& arena)
{
    const int count = int(system.bodies.size());
    dynamic_ = arena.take<int>(count);
    masses_ = arena.take<BodyMass>(count);
    v_star_ = arena.take<double>(6 * count);
    if (arena.failed()) return false;
    int n = 0;
    for (int i = 0; i < count; ++i) {
        const SolverBody& body = system.bodies[std::size_t(i)];
        dynamic_[std::size_t(i)] = body.inv_mass > 0 ? n : -1;
        if (body.inv_mass <= 0) continue;
        BodyMass& mass = masses_[std::size_t(n)];
        mass.mass = body.mass;
        mass.inv_mass = body.inv_mass;
        copy(body.inertia, mass.I);
        copy(body.inv_inertia, mass.inv_I);
        put(body.v, &v_star_[std::size_t(6 * n)]);
        put(body.w, &v_star_[std::size_t(6 * n + 3)]);
        ++n;
    }
    masses_ = masses_.first(std::size_t(n));
    v_star_ = v_star_.first(std::size_t(6 * n));
    return true;
}

bool ExactProblem::build_factor(const RowSystem& system, PlanCache* plans, Arena& arena)
{
    const int blocks = int(system.blocks.size());
    auto pairs = arena.take<BodyPair>(blocks);
    slots_ = arena.take<PairSlots>(blocks);
    if (arena.failed()) return false;
    for (int k = 0; k < blocks; ++k) {
        const RowBlock& block = system.blocks[std::size_t(k)];
        int a = dynamic_[std::size_t(block.body1)];
        int b = block.body2 >= 0 ? dynamic_[std::size_t(block.body2)] : -1;
        if (a < 0) a = b;
        if (b < 0) b = a;
        pairs[std::size_t(k)] = {a, b};
    }
    if (!plan_.take(int(masses_.size()), pairs, plans, arena) || !H_.prepare(plan_.plan(), arena))
        return false;
    for (int k = 0; k < blocks; ++k) {
        const auto [a, b] = pairs[std::size_t(k)];
        PairSlots& s = slots_[std::size_t(k)];
        s = {H_.diagonal(a), H_.diagonal(b), nullptr, false};
        if (a != b) s.ab = H_.between(a, b, s.transposed);
    }
    return true;
}

void ExactProblem::fill_rows(const RowSystem& system)
{
    scale_ = 0;
    for (std::size_t k = 0; k < system.blocks.size(); ++k) {
        const RowBlock& block = system.blocks[k];
        for (int i = block.first; i < block.first + block.count; ++i) {
            const auto at = std::size_t(i);
            ExactRow& row = rows_[at];
            row.pair = int(k);
            fill_row(system.rows[at], system.numbers[at], block, system, row);
            scale_ = std::max(scale_, velocity_scale(row));
        }
    }
    if (!(scale_ > 0)) scale_ = 1;
}

// max(|c - J v*|, |J| |v*| / 1000)
double ExactProblem::velocity_scale(const ExactRow& row) const
{
    double sum = 0, motion = 0;
    const auto add = [&](const double* J, const double* v) {
        for (int i = 0; i < 6; ++i) {
            const double x = J[i] * v[i];
            sum += x;
            motion += std::fabs(x);
        }
    };
    add(row.J, v_star_.data() + 6 * row.a);
    if (row.b >= 0) add(row.J + 6, v_star_.data() + 6 * row.b);
    return std::max(std::fabs(row.c - sum), 1e-3 * motion);
}

void ExactProblem::fill_row(const Row& row, const RowNumbers& n, const RowBlock& block,
                            const RowSystem& system, ExactRow& out) const
{
    double* half = out.J;
    int* body = &out.a;
    out.c = n.c;
    out.C = n.C;
    out.b = -1;
    const auto take = [&](int island_body, Vec3 lin, Vec3 ang) {
        if (island_body < 0) return;
        const SolverBody& s = system.bodies[std::size_t(island_body)];
        const int index = dynamic_[std::size_t(island_body)];
        if (index < 0) {
            out.c -= double(dot(lin, s.v)) + double(dot(ang, s.w));
            return;
        }
        put(lin, half), put(ang, half + 3);
        half = out.J + 6;
        *body = index;
        body = &out.b;
    };
    take(block.body1, row.lin1, row.ang1);
    take(block.body2, row.lin2, row.ang2);

    double mobility = 0, y[3];
    for (int k = 0; k < 2; ++k) {
        const int index = k == 0 ? out.a : out.b;
        if (index < 0) break;
        const BodyMass& mass = masses_[std::size_t(index)];
        const double* J = out.J + 6 * k;
        multiply(mass.inv_I, J + 3, y);
        mobility += mass.inv_mass * (J[0] * J[0] + J[1] * J[1] + J[2] * J[2]) +
                    (J[3] * y[0] + J[4] * y[1] + J[5] * y[2]);
    }
    out.d = mobility + out.C;
    out.weight_min = 1e-11 * out.d;
}

void ExactProblem::response(const ExactRow& row, double* twelve) const
{
    for (int k = 0; k < 2; ++k) {
        const int index = k == 0 ? row.a : row.b;
        if (index < 0) return;
        const BodyMass& mass = masses_[std::size_t(index)];
        for (int i = 0; i < 3; ++i) twelve[6 * k + i] = mass.inv_mass * row.J[6 * k + i];
        multiply(mass.inv_I, row.J + 6 * k + 3, twelve + 6 * k + 3);
    }
}

int ExactProblem::factor(std::span<const double> D)
{
    H_.clear();
    for (std::size_t n = 0; n < masses_.size(); ++n) {
        double* h = H_.diagonal(int(n));
        const BodyMass& mass = masses_[n];
        h[0] = h[7] = h[14] = mass.mass;
        h[21] = mass.I[0], h[28] = mass.I[1], h[35] = mass.I[2];
        h[22] = h[27] = mass.I[3];
        h[23] = h[33] = mass.I[4];
        h[29] = h[34] = mass.I[5];
    }
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        if (!(D[i] > 0)) continue;
        const ExactRow& row = rows_[i];
        const PairSlots& s = slots_[std::size_t(row.pair)];
        const double* Ja = row.J;
        const double* Jb = row.J + 6;
        // A pair of which one body is kinematic has both slots on the dynamic one.
        add_outer(s.aa, D[i], Ja, Ja);
        if (row.b < 0) continue;
        add_outer(s.bb, D[i], Jb, Jb);
        s.transposed ? add_outer(s.ab, D[i], Jb, Ja) : add_outer(s.ab, D[i], Ja, Jb);
    }
    ++factorisations_;
    return H_.factor();
}

void ExactProblem::momentum_change(std::span<const double> v, std::span<double> r) const
{
    for (std::size_t n = 0; n < masses_.size(); ++n) {
        const BodyMass& mass = masses_[n];
        double dv[6];
        for (std::size_t i = 0; i < 6; ++i) dv[i] = v_star_[6 * n + i] - v[6 * n + i];
        for (std::size_t i = 0; i < 3; ++i) r[6 * n + i] = mass.mass * dv[i];
        multiply(mass.I, dv + 3, &r[6 * n + 3]);
    }
}

void ExactProblem::velocities(std::span<const double> p, std::span<double> v) const
{
    std::fill(v.begin(), v.end(), 0.0);
    for (std::size_t i = 0; i < rows_.size(); ++i)
        if (p[i] != 0) add_jt(rows_[i], p[i], v.data());
    velocities_after(v, v);
}

void ExactProblem::velocities_after(std::span<const double> momentum, std::span<double> v) const
{
    for (std::size_t n = 0; n < masses_.size(); ++n) {
        const BodyMass& mass = masses_[n];
        double turn[3];
        multiply(mass.inv_I, &momentum[6 * n + 3], turn);
        for (std::size_t i = 0; i < 3; ++i) {
            v[6 * n + i] = v_star_[6 * n + i] + mass.inv_mass * momentum[6 * n + i];
            v[6 * n + 3 + i] = v_star_[6 * n + 3 + i] + turn[i];
        }
    }
}

double ExactProblem::residual(const BoxState& state, std::span<double> v) const
{
    velocities(state.p, v);
    double worst = 0;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        const ExactRow& row = rows_[i];
        if (!(row.d > 0)) continue;
        const double p = state.p[i];
        const double w = jv(row, v.data()) + row.C * p - row.c;
        const double clipped = std::min(std::max(p - w / row.d, state.lo[i]), state.hi[i]);
        worst = std::max(worst, row.d * std::fabs(p - clipped));
    }
    return worst / scale_;
}

void ExactProblem::store(RowSystem& system, std::span<const double> p, std::span<double> v) const
{
    for (std::size_t i = 0; i < rows_.size(); ++i) system.numbers[i].p = Real(p[i]);
    velocities(p, v);
    for (std::size_t k = 0; k < dynamic_.size(); ++k) {
        if (dynamic_[k] < 0) continue;
        const double* six = v.data() + 6 * dynamic_[k];
        system.bodies[k].v = {Real(six[0]), Real(six[1]), Real(six[2])};
        system.bodies[k].w = {Real(six[3]), Real(six[4]), Real(six[5])};
    }
}

}  // namespace epode
