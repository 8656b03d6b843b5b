// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Inner steps move copies of the bodies, eight side by side; what was read of a body once is not read again
// until the step ends. Joints that have to be asked for their rows read the bodies themselves, which are then
// moved too; after the last inner step they are in any case, and nothing is left to integrate. Velocities in
// them stay those of the beginning until the step is accepted.
#include "step/island/substep_model.h"

#include "dynamics/exact_spin.h"
#include "dynamics/integrate.h"
#include "joints/drive_rows.h"
#include "step/island/problem/assemble.h"
#include "step/island/problem/default_softness.h"
#include "tasks/prefetched.h"

namespace epode {
namespace {

template <std::size_t kCount>
void set(Lanes (&to)[kCount], std::size_t lane, const Real (&from)[kCount])
{
    for (std::size_t i = 0; i < kCount; ++i) to[i].at[lane] = from[i];
}

void set(Lanes (&to)[3], std::size_t lane, Vec3 a) { set(to, lane, {a.x, a.y, a.z}); }
void set(Lanes (&to)[4], std::size_t lane, Quat q) { set(to, lane, {q.w, q.x, q.y, q.z}); }

void set(Lanes (&to)[6], std::size_t lane, const Sym3& s)
{
    set(to, lane, {s.xx, s.yy, s.zz, s.xy, s.xz, s.yz});
}

void set(Lanes (&to)[9], std::size_t lane, const Mat3& R)
{
    set(to, lane, {R.row0.x, R.row0.y, R.row0.z, R.row1.x, R.row1.y, R.row1.z, R.row2.x, R.row2.y, R.row2.z});
}

Vec3 vec_in(const Lanes* a, std::size_t lane) { return {a[0].at[lane], a[1].at[lane], a[2].at[lane]}; }

Quat quat_in(const Lanes* q, std::size_t lane)
{
    return {q[0].at[lane], q[1].at[lane], q[2].at[lane], q[3].at[lane]};
}

bool is_raised(const Body& body, const SolverBody& solver)
{
    SolverBody plain;
    load_inertia(body, plain);
    const Sym3 &a = plain.inv_inertia, &b = solver.inv_inertia;
    return a.xx != b.xx || a.yy != b.yy || a.zz != b.zz || a.xy != b.xy || a.xz != b.xz || a.yz != b.yz;
}

void load_pose(const Body& body, const SolverBody& solver, SolverPose& pose)
{
    const Sym3& s = solver.inv_inertia;
    pose.x = body.position(), pose.inv_mass = solver.inv_mass, pose.q = body.orientation();
    pose.main = {s.xx, s.yy, s.zz}, pose.mixed = {s.xy, s.xz, s.yz};
    pose.unused1 = pose.unused2 = 0;
}

// Bodies have the velocities of the step's beginning; those of other islands do not change.
class IslandTurning final : public Turning {
  public:
    IslandTurning(std::span<Body* const> bodies, const Velocity* motion) : bodies_(bodies), motion_(motion) {}

    Vec3 of(const Body& body) const override
    {
        const auto i = std::size_t(body.island_index);
        return i < bodies_.size() && bodies_[i] == &body ? motion_[i].w : body.angular_velocity();
    }

  private:
    std::span<Body* const> bodies_;
    const Velocity* motion_;
};

void find_motion(const RowSystem& system, const RowBlock& block, std::span<const Velocity> bodies,
                 BodyMotion* out)
{
    const auto at = [&](int body) {
        if (body < 0) return BodyMotion{};
        return BodyMotion{bodies[std::size_t(body)].v, bodies[std::size_t(body)].w};
    };
    out[0] = at(block.body1), out[1] = at(block.body2);
    for (const WideTerm& term : terms_of(system, block)) *out++ = at(term.body);
}

}  // namespace

bool SubstepModel::prepare(Arena& arena)
{
    RowSystem& system = work_.system;
    const int bodies = int(system.bodies.size());
    lanes_ = arena.take<BodyLanes>((bodies + kLanes - 1) / kLanes);
    system.poses = arena.take<SolverPose>(system.blocks.empty() ? 0 : bodies + system.worlds());
    if (arena.failed()) return false;
    // What no body fills must be numbers.
    if (!lanes_.empty()) lanes_.back() = {};
    // Ranges of bodies begin with a group of lanes.
    static_assert(kObjectRange % kLanes == 0);
    for_each_prefetched<kLinesOfBody>(tasks_, island_bodies(), [&](std::size_t i, Body& body) {
        SolverBody& solver = system.bodies[i];
        load_body(i, body, solver);
        if (!system.poses.empty()) load_pose(body, solver, system.poses[i]);
    });
    if (!system.poses.empty())
        for (SolverPose& world : system.poses.subspan(std::size_t(bodies))) world = {};
    return true;
}

// f(groups, first body, bodies) on all workers.
template <typename F>
void SubstepModel::in_groups(F&& f) const
{
    tasks_.in_ranges(int(work_.island.bodies.size()), kObjectRange,
                     [&](int first, int last) { f(lanes_.data() + first / kLanes, first, last - first); });
}

// What is free turns over the whole step (step/island/free_flight.h). A raised inertia has another momentum, and what the velocity did
// not show of it becomes velocity.
bool SubstepModel::begin_exact_turn(Body& body, SolverBody& solver, bool raised) const
{
    if (!world_.exact_rotation || body.kinematic() || is_unattached(body)) return false;
    if (!raised) return true;
    solver.w += release_excess(body);
    return false;
}

void SubstepModel::load_body(std::size_t i, Body& body, SolverBody& solver)
{
    const std::size_t lane = i % kLanes;
    BodyLanes& to = lanes_[i / kLanes];
    if (lane == 0) to.any_gyroscopic = to.any_uneven = to.any_limit = false, to.finite = to.exact = 0;
    const bool raised = tension_ && is_raised(body, solver);
    const Sym3 inv_inertia =
        raised ? rotate(transpose(body.rotation()), solver.inv_inertia) : body.inv_inertia;
    const bool uneven = raised || !isotropic(body.inv_inertia);
    const bool exact = begin_exact_turn(body, solver, raised);
    const bool gyroscopic = !exact && body.gyroscopic && !body.kinematic() && !isotropic(body.inertia);
    const bool limit = body.max_angular_speed < kInf;
    to.any_uneven |= uneven, to.any_gyroscopic |= gyroscopic, to.any_limit |= limit;
    if (body.finite_rotation) to.finite = static_cast<unsigned char>(to.finite | 1u << lane);
    if (exact) to.exact = static_cast<unsigned char>(to.exact | 1u << lane);
    to.uneven[int(lane)] = uneven ? 1 : 0, to.max_spin[int(lane)] = body.max_angular_speed;
    set(to.x, lane, body.position());
    set(to.q, lane, body.orientation()), set(to.next, lane, body.orientation());
    set(to.R, lane, body.rotation());
    to.inv_mass[int(lane)] = solver.inv_mass;
    const bool all = borne_.empty();
    set(to.force, lane, all ? load(body.facc) : force_left(world_, body, borne_[i]));
    set(to.torque, lane, all ? load(body.tacc) : borne_[i].torque);
    set(to.inertia, lane, gyroscopic ? body.inertia : Sym3{});
    set(to.inv_inertia, lane, inv_inertia);
    set(to.inv_in_world, lane, solver.inv_inertia);
}

void SubstepModel::apply_forces(std::span<Velocity> bodies, Real h) const
{
    in_groups([&](BodyLanes* groups, int first, int count) {
        kernels_.accelerate(groups, count, bodies.data() + first, h);
    });
}

void SubstepModel::advance(std::span<Velocity> motion, std::span<const Velocity> bodies, Real h)
{
    const std::span<SolverPose> poses = work_.system.poses;
    in_groups([&](BodyLanes* groups, int first, int count) {
        kernels_.turn(groups, count, motion.data() + first, h);
        for (int i = 0; i < count; i += kLanes)
            if (groups[i / kLanes].finite | groups[i / kLanes].exact)
                turn_few(std::size_t((first + i) / kLanes), motion.data(), bodies.data(), h);
        kernels_.place(groups, count, poses.empty() ? nullptr : poses.data() + first);
    });
}

// f(lane, index of the body) for each set bit.
template <typename F>
void SubstepModel::for_bits(std::size_t group, unsigned char bits, F&& f) const
{
    for (std::size_t lane = 0; lane < kLanes && bits >> lane != 0; ++lane)
        if (bits >> lane & 1) f(lane, group * kLanes + lane);
}

void SubstepModel::kick_spins(std::span<Velocity> bodies, Real h) const
{
    if (!world_.exact_rotation) return;
    in_groups([&](BodyLanes* groups, int first, int count) {
        for (int i = 0; i < count; i += kLanes) {
            const BodyLanes& lanes = groups[i / kLanes];
            for_bits(std::size_t((first + i) / kLanes), lanes.exact, [&](std::size_t lane, std::size_t body) {
                const Mat3 R{vec_in(lanes.R, lane), vec_in(lanes.R + 3, lane), vec_in(lanes.R + 6, lane)};
                bodies[body].w = kicked_spin(*work_.island.bodies[body], R, {}, bodies[body].w, h);
            });
        }
    });
}

void SubstepModel::turn_few(std::size_t group, const Velocity* motion, const Velocity* bodies, Real h)
{
    BodyLanes& lanes = lanes_[group];
    for_bits(group, lanes.finite, [&](std::size_t lane, std::size_t i) {
        set(lanes.next, lane, turned(*work_.island.bodies[i], quat_in(lanes.q, lane), motion[i].w, h));
    });
    const IslandTurning turning(work_.island.bodies, motion);
    for_bits(group, lanes.exact, [&](std::size_t lane, std::size_t i) {
        set(lanes.next, lane,
            turned_exactly(*work_.island.bodies[i], quat_in(lanes.q, lane), motion[i].w, bodies[i].w, h,
                           turning));
    });
}

void SubstepModel::settle()
{
    for_each_prefetched<kLinesOfBody>(tasks_, island_bodies(), [&](std::size_t i, Body& body) {
        const BodyLanes& from = lanes_[i / kLanes];
        const std::size_t lane = i % kLanes;
        store(body.pos, vec_in(from.x, lane));
        store_quat(body.q, quat_in(from.q, lane));
        store_mat(body.R, {vec_in(from.R, lane), vec_in(from.R + 3, lane), vec_in(from.R + 6, lane)});
        const Lanes* s = from.inv_in_world;
        work_.system.bodies[i].inv_inertia = {s[0].at[lane], s[1].at[lane], s[2].at[lane],
                                              s[3].at[lane], s[4].at[lane], s[5].at[lane]};
    });
}

void SubstepModel::refresh(std::span<const Velocity> bodies)
{
    const auto& blocks = work_.system.blocks;
    bool settled = false;
    for (std::size_t k = 0; k < blocks.size(); ++k) {
        if (blocks[k].contact || blocks[k].followed) continue;  // the solver follows these itself
        if (!settled) settle();
        settled = true;
        refresh_block(k, bodies);
    }
}

void SubstepModel::refresh_block(std::size_t k, std::span<const Velocity> bodies)
{
    RowSystem& system = work_.system;
    RowBlock& block = system.blocks[k];
    Row rows[kMaxBlockRows];
    RowWriter out(rows, info_);
    Joint& joint = *work_.joints[k];
    BodyMotion motion[kMaxBodyTerms];
    if (joint.driven) find_motion(system, block, bodies, motion), out.set_motion(motion);
    emit_joint(joint, out);
    if (block.term_count > 0) place_terms(out.terms(), system, block);
    EPODE_ASSERT(out.count() == block.count);  // of every joint type: see StepInfo::inner
    block.arms = out.arms();
    for (int i = 0; i < block.count && i < out.count(); ++i) {
        Row& row = system.rows[std::size_t(block.first + i)];
        // Decided at the beginning of the step, by the velocities of then.
        const bool has_restitution = row.has_restitution;
        const Real restitution_velocity = row.restitution_velocity;
        const Real cfm = has_default_softness(rows[i]) ? row.cfm : rows[i].cfm;
        row = rows[i];
        row.cfm = cfm;
        row.has_restitution = has_restitution;
        row.restitution_velocity = restitution_velocity;
    }
}

void SubstepModel::gather_contacts()
{
    for (RowBlock& block : work_.system.blocks)
        if (block.contact)
            gather_contact(work_.island, block,
                           work_.system.rows.subspan(std::size_t(block.first), std::size_t(block.count)));
}

void gather_contact(const Island& island, RowBlock& block, std::span<Row> rows)
{
    if (block.body2 < 0) return;
    const Vec3 x1 = island.bodies[std::size_t(block.body1)]->position();
    const Vec3 x2 = island.bodies[std::size_t(block.body2)]->position();
    const Vec3 half_gap = Real(0.5) * ((x2 + block.arms.r2) - (x1 + block.arms.r1));
    block.arms.r1 += half_gap;
    block.arms.r2 -= half_gap;
    for (Row& row : rows) {
        if (row.lin1 == Vec3{}) continue;  // rolling rows have no arm
        row.ang1 = cross(block.arms.r1, row.lin1);
        row.ang2 = cross(block.arms.r2, row.lin2);
    }
}

}  // namespace epode
