// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Joints are asked once for their rows; room for six rows each, and more for drives, is taken from the arena,
// and what is written stays contiguous. Contacts become manifolds, without rows, where the solver takes them.
// Forces of joints (a motor against its stop) must be in the accumulators before v* is formed, so rows come
// first.
#include "step/island/problem/assemble.h"

#include <algorithm>

#include "dynamics/exact_spin.h"
#include "dynamics/integrate.h"
#include "dynamics/joint_drives.h"
#include "joints/breaking.h"
#include "joints/drive_rows.h"
#include "joints/joint_manifolds.h"
#include "rows/policy.h"
#include "rows/wrench.h"
#include "step/island/problem/manifold_rows.h"
#include "tasks/prefetched.h"

namespace epode {
namespace {

// A tensor of the body's frame in the world's.
inline Sym3 in_world(const Body& body, const Sym3& s)
{
    return isotropic(s) ? s : rotate(body.rotation(), s);
}

// Of two tensors at once, a lane each, with the operations of rotate() (math/mat.h).
void load_both_in_world(const Mat3& R, const Sym3& s, const Sym3& t, Sym3& s_out, Sym3& t_out)
{
    typedef Real Both __attribute__((vector_size(2 * sizeof(Real))));
    struct Row {
        Both x, y, z;
    };
    const Both xx{s.xx, t.xx}, yy{s.yy, t.yy}, zz{s.zz, t.zz}, xy{s.xy, t.xy}, xz{s.xz, t.xz}, yz{s.yz, t.yz};
    const auto times = [&](Vec3 a) {
        return Row{xx * a.x + xy * a.y + xz * a.z, xy * a.x + yy * a.y + yz * a.z,
                   xz * a.x + yz * a.y + zz * a.z};
    };
    const auto dot = [](const Row& a, Vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; };
    const Row row0 = times(R.row0), row1 = times(R.row1), row2 = times(R.row2);
    const Both out[6] = {dot(row0, R.row0), dot(row1, R.row1), dot(row2, R.row2),
                         dot(row0, R.row1), dot(row0, R.row2), dot(row1, R.row2)};
    s_out = {out[0][0], out[1][0], out[2][0], out[3][0], out[4][0], out[5][0]};
    t_out = {out[0][1], out[1][1], out[2][1], out[3][1], out[4][1], out[5][1]};
}

void load_mass_and_inertias(const Body& body, SolverBody& out)
{
    out.inv_mass = body.inv_mass;
    out.mass = body.kinematic() ? 0 : body.mass.mass;
    if (!isotropic(body.inertia) && !isotropic(body.inv_inertia))  // 0 of a kinematic body is
        return load_both_in_world(body.rotation(), body.inv_inertia, body.inertia, out.inv_inertia,
                                  out.inertia);
    out.inv_inertia = in_world(body, body.inv_inertia);
    out.inertia = body.kinematic() ? Sym3{} : in_world(body, body.inertia);
}

void add_gravity(Body& body, Vec3 g)
{
    if (body.gravity) store(body.facc, load(body.facc) + body.mass.mass * g);
}

void add_applied(const RowWriter& out, Joint& joint)
{
    for (int k = 0; k < 2; ++k)
        if (Body* body = joint.node[k].body) {
            store(body->facc, load(body->facc) + out.force(k));
            store(body->tacc, load(body->tacc) + out.torque(k));
        }
}

// Contacts that can be manifolds, and the others, each in the island's order.
bool sort_joints(const Island& island, bool manifolds, Arena& arena, IslandWork& work)
{
    const std::span<Joint*> joints = island.joints;
    const std::size_t contacts = manifolds ? std::size_t(island.plain_contacts) : 0;
    work.contact_feedback = manifolds && island.feedback;
    work.contacts = joints, work.joints = {};
    if (contacts == joints.size()) return true;
    const auto sorted = arena.take<Joint*>(int(joints.size()));
    if (arena.failed()) return false;
    work.contacts = sorted.first(contacts), work.joints = sorted.subspan(contacts);
    std::size_t contact = 0, other = 0;
    for_each_prefetched<1>(std::span<Joint* const>(joints), [&](std::size_t, Joint& joint) {
        (manifolds && joint.plain ? work.contacts[contact++] : work.joints[other++]) = &joint;
    });
    return true;
}

// Emits all joints of the island; returns the number of rows and of joints that have any.
// `begins`: the step does.
void emit_rows(const StepInfo& info, std::span<Joint*> joints, bool begins, IslandWork& work, int& rows,
               int& blocks)
{
    constexpr std::size_t kAhead = 4;
    int terms = 0;
    for (std::size_t i = 0; i < joints.size(); ++i) {
        if (i + 2 * kAhead < joints.size()) prefetch<6>(joints[i + 2 * kAhead]);
        if (i + kAhead < joints.size())
            for (const JointNode& node : joints[i + kAhead]->node)
                if (node.body) prefetch<4>(node.body->pos);
        Joint* const joint = joints[i];
        if (joint->driven && begins) forget_load(*joint);
        RowWriter out(&work.system.rows[std::size_t(rows)], info);
        emit_joint(*joint, out);
        if (out.applied()) add_applied(out, *joint);
        if (out.count() == 0) continue;
        const Body* b2 = joint->body2();
        const Body* b1 = out.terms().empty() ? joint->body1() : out.terms().front().body;
        work.joints[std::size_t(blocks)] = joint;
        RowBlock& block = work.system.blocks[std::size_t(blocks)];
        block.first = rows, block.count = out.count();
        block.body1 = b1->island_index, block.body2 = b2 ? b2->island_index : -1;
        block.contact = joint->type->number == dJointTypeContact;
        block.arms = out.arms(), block.form = out.form(), block.point = out.holds_point(),
        block.followed = false, block.coulomb = false;
        block.cone = block.contact && info.cone;
        block.first_term = terms, block.term_count = int(out.terms().size());
        block.wrench = -1;
        if (block.term_count > 0) place_terms(out.terms(), work.system, block);
        terms += block.term_count;
        rows += out.count();
        ++blocks;
    }
    work.system.terms = work.system.terms.first(std::size_t(terms));
}

// The exact solver has Coulomb's friction where the world asks for it; the others bound friction so anyway.
void mark_coulomb(RowSystem& system)
{
    for (RowBlock& block : system.blocks) {
        block.coulomb = block.contact && block.count > 1;
        system.coulomb |= block.coulomb;
    }
}

// Of joints whose force or torque somebody wants. False: out of memory.
bool place_wrenches(Arena& arena, IslandWork& work)
{
    int count = 0;
    for (std::size_t k = 0; k < work.joints.size(); ++k) {
        const Joint& joint = *work.joints[k];
        if (joint.feedback || (joint.driven && drives_of(joint).limits.any()))
            work.system.blocks[k].wrench = count++;
    }
    work.system.wrenches = arena.take<BlockWrench>(count);
    if (arena.failed()) return false;
    for (BlockWrench& wrench : work.system.wrenches) wrench = {};
    return true;
}

// Where each member ends, and its own world. False: out of memory.
bool mark_parts(Arena& arena, IslandWork& work)
{
    if (work.members.size() < 2) return true;
    RowSystem& system = work.system;
    auto parts = arena.take<SystemPart>(int(work.members.size()));
    if (arena.failed()) return false;
    SystemPart end;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const int world = -1 - int(i);
        end.bodies += int(work.members[i].bodies.size());
        if (!system.contact_manifolds.empty()) end.contact_manifolds += int(work.members[i].manifolds.size());
        const auto take = [&](auto& items, int& at) {
            for (; std::size_t(at) < items.size() && items[std::size_t(at)].body1 < end.bodies; ++at)
                if (int& body2 = items[std::size_t(at)].body2; body2 < 0) body2 = world;
        };
        take(system.blocks, end.blocks);
        take(system.joint_contacts.manifolds, end.joint_manifolds);
        parts[i] = end;
    }
    system.parts = parts;
    return true;
}

}  // namespace

void place_terms(std::span<const BodyTerm> from, const RowSystem& system, const RowBlock& block)
{
    const std::span<WideTerm> to = terms_of(system, block);
    for (std::size_t i = 0; i < to.size(); ++i)
        to[i] = {from[i].body->island_index, from[i].lin, from[i].ang};
}

namespace {

// Of four contacts that carry a robot those nearest would have all of its load, by the nanometre that a float leaves: wheels next to
// casters did not brake.
constexpr Real kLeastCorrection = Real(5e-6);

// Depth that contact joints keep. Sweeps in floats open what rests by up to 1e-6 of the fall of a step, more
// sweeps converge. A layer keeps contacts in any case, and ODE has no such depth.
Real touching_depth(const World& world, Real h)
{
    constexpr Real kShare = Real(2e-6);
    constexpr int kFewSweeps = 50;
    if (world.acts_as_ode() || world.contact_layer > 0) return -kInf;
    return world.quick_iterations <= kFewSweeps ? kShare * length(world.gravity) * h * h : 0;
}

// A cone has no directions of its own.
bool bounds_friction_along_slip(const World& world, const ProblemForm& form)
{
    return !world.acts_as_ode() && !world.friction_cone && !form.cones;
}

}  // namespace

StepInfo step_info(const World& world, Real h)
{
    StepInfo info;
    info.h = h;
    info.fps = 1 / h;
    info.erp = world.erp;
    info.cfm = world.cfm;
    info.contact_layer = world.contact_layer;
    info.contact_max_vel = world.contact_max_vel;
    return info;
}

void load_inertia(const Body& body, SolverBody& out)
{
    out.inv_mass = body.inv_mass;
    out.inv_inertia = in_world(body, body.inv_inertia);
}

void load_velocity(const Body& body, SolverBody& out)
{
    out.v = body.velocity();
    out.w = body.angular_velocity();
}

void load_pushed(const Body& body, Real h, SolverBody& out)
{
    const Vec3 w = body.angular_velocity();
    const Vec3 torque = load(body.tacc) + gyroscopic_torque(body, w, h);
    out.v = body.velocity() + (h * out.inv_mass) * load(body.facc);
    out.w = w + h * (out.inv_inertia * torque);
}

void load_pushed_exactly(Body& body, Real h, SolverBody& out)
{
    out.v = body.velocity() + (h * out.inv_mass) * load(body.facc);
    out.w = kicked_spin(body, load(body.tacc), body.angular_velocity(), h);
}

void load_all_pushed(const World& world, Real h, IslandWork& work)
{
    for (std::size_t i = 0; i < work.island.bodies.size(); ++i) {
        Body& body = *work.island.bodies[i];
        turns_exactly(world, body) ? load_pushed_exactly(body, h, work.system.bodies[i])
                                   : load_pushed(body, h, work.system.bodies[i]);
    }
}

namespace {

void load_momentum(const Body& body, Real h, SolverBody& out)
{
    const Vec3 pushed = h * load(body.tacc) + body.rotation() * body.spin_excess;
    out.v = body.velocity() + (h * out.inv_mass) * load(body.facc);
    out.w = body.angular_velocity() + out.inv_inertia * pushed;
}

void load_body(const World& world, Real h, const ProblemForm& form, Body& body, SolverBody& out)
{
    form.inertia ? load_mass_and_inertias(body, out) : load_inertia(body, out);
    if (form.keeps_momentum) return load_momentum(body, h, out);
    if (!form.has_substeps)
        return turns_exactly(world, body) ? load_pushed_exactly(body, h, out) : load_pushed(body, h, out);
    load_velocity(body, out);
}

StepInfo info_for(const World& world, Real h, const ProblemForm& form, const Island& island)
{
    StepInfo info = step_info(world, h);
    if (form.keeps_depth) info.contact_layer = std::max(info.contact_layer, island.kept_depth);
    info.touching_depth = touching_depth(world, h);  // only sweeps take manifolds
    info.cone = world.friction_cone && form.cones;
    if (form.shares_load && !world.acts_as_ode()) info.least_correction = kLeastCorrection;
    info.friction_along_slip = bounds_friction_along_slip(world, form);
    return info;
}

class Assembly {
  public:
    Assembly(World& world, Real h, const ProblemForm& form, Arena& arena, IslandWork& work)
        : world_(world), h_(h), form_(form), arena_(arena), work_(work), system_(work.system)
    {
        system_.h = h;
    }

    // False: out of memory.
    bool take_memory()
    {
        const Island& island = work_.island;
        if (!sort_joints(island, form_.joint_manifolds, arena_, work_)) return false;
        const int joints = int(work_.joints.size()), contacts = int(work_.contacts.size());
        const bool as_rows = !form_.contact_manifolds;
        driven_ = std::min(joints, world_.driven_joints);
        system_.bodies = arena_.take<SolverBody>(int(island.bodies.size()));
        system_.joint_contacts.manifolds = arena_.take<JointManifold>(contacts);
        system_.joint_contacts.points = arena_.take<JointManifoldPoint>(contacts);
        system_.blocks = arena_.take<RowBlock>(joints + (as_rows ? manifold_point_count(island) : 0));
        system_.rows = arena_.take<Row>(joints * kMaxJointRows + driven_ * kMaxDriveRows +
                                        (as_rows ? manifold_row_count(island) : 0));
        system_.terms = arena_.take<WideTerm>(kMaxBodyTerms * std::min(joints, world_.couplings.size()));
        manifolds_ = arena_.take<ContactManifold*>(as_rows ? 0 : int(island.manifolds.size()));
        if (arena_.failed()) work_.joints = work_.contacts = {};  // nothing was written there
        return !arena_.failed();
    }

    void begin_bodies(const Tasks& tasks, StepUndo* undo)
    {
        const std::span<Body* const> bodies = work_.island.bodies;
        const std::size_t first = undo ? undo->first_of(bodies) : 0;
        const bool forces_known = work_.island.joints.empty();
        for_each_prefetched<kLinesOfBody>(tasks, bodies, [&](std::size_t i, Body& body) {
            if (undo) undo->save(first + i);
            body.island_index = int(i);
            add_gravity(body, world_.gravity);
            if (forces_known) load_body(world_, h_, form_, body, system_.bodies[i]);
        });
    }

    void write_rows(const Tasks& tasks, bool begins)
    {
        const Island& island = work_.island;
        int rows = 0, blocks = 0;
        StepInfo info = info_for(world_, h_, form_, island);
        info.correction = work_.correction;
        write_manifolds(work_.contacts, info, system_.joint_contacts);
        emit_rows(info, work_.joints, begins, work_, rows, blocks);
        work_.joints = work_.joints.first(std::size_t(blocks));
        place_manifolds(tasks, island);
        if (!form_.contact_manifolds) emit_manifolds(info, form_.cones, work_, rows, blocks);
        for (std::size_t i = 0; i < manifolds_.size(); ++i) manifolds_[i] = island.manifolds[i]->manifold;
        system_.contact_manifolds = manifolds_;
        system_.blocks = system_.blocks.first(std::size_t(blocks));
        system_.rows = system_.rows.first(std::size_t(rows));
        if (form_.coulomb) mark_coulomb(system_);
    }

    // Joints have added their own forces.
    void end_bodies(const Tasks& tasks)
    {
        if (work_.island.joints.empty()) return;
        const std::span<Body* const> bodies = work_.island.bodies;
        for_each_prefetched<kLinesOfBody>(tasks, bodies, [&](std::size_t i, Body& body) {
            load_body(world_, h_, form_, body, system_.bodies[i]);
        });
    }

    // False: out of memory.
    bool write_numbers(const Tasks& tasks)
    {
        system_.numbers = arena_.take<RowNumbers>(int(system_.rows.size()));
        if (arena_.failed() || !mark_parts(arena_, work_)) return false;
        if (form_.has_substeps && !place_wrenches(arena_, work_)) return false;
        end_bodies(tasks);
        if (work_.correction < 1) correct_less();
        const Real fps = 1 / h_;
        for (const RowBlock& block : system_.blocks)
            for (int i = block.first; i < block.first + block.count; ++i)
                system_.numbers[std::size_t(i)] =
                    ode_baumgarte(system_.rows[std::size_t(i)], h_, fps, block.first);
        for (std::size_t i = 0; driven_ > 0 && i < system_.rows.size(); ++i)
            if (system_.rows[i].drive) take_drive(system_.rows[i], h_, system_.numbers[i]);
        return true;
    }

  private:
    void correct_less()
    {
        for (Row& row : system_.rows)
            if (!row.drive && !row.given) row.erp *= work_.correction;
    }

    World& world_;
    const Real h_;
    const ProblemForm& form_;
    Arena& arena_;
    IslandWork& work_;
    RowSystem& system_;
    std::span<ContactManifold*> manifolds_;
    int driven_ = 0;
};

}  // namespace

bool assemble(World& world, Real h, const ProblemForm& form, const Tasks& tasks, Arena& arena,
              IslandWork& work, StepUndo* undo)
{
    Assembly assembly(world, h, form, arena, work);
    if (!assembly.take_memory()) return false;
    assembly.begin_bodies(tasks, undo);
    assembly.write_rows(tasks, undo != nullptr);
    return assembly.write_numbers(tasks);
}

}  // namespace epode
