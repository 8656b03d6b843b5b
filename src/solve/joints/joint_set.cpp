// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Packing writes rows one lane at a time; the kernels compute what follows from them (the matrix of each
// joint) for several lanes at once.
#include "solve/joints/joint_set.h"

#include <algorithm>
#include <cstring>

#include "solve/common/colours.h"

namespace epode {
namespace {

template <typename L>
void set(L* to, int lane, Vec3 a)
{
    using N = typename L::Number;
    to[0][lane] = N(a.x), to[1][lane] = N(a.y), to[2][lane] = N(a.z);
}

template <typename L>
void set(L* to, int lane, const Sym3& s)
{
    set(to, lane, Vec3{s.xx, s.yy, s.zz});
    set(to + 3, lane, Vec3{s.xy, s.xz, s.yz});
}

// Most rows have the same parameters as the row in their place in the joint before; mapping takes four
// divisions. Which rows are compliant relative to their inverse effective mass is decided by the kernels.
class AimMap {
  public:
    explicit AimMap(const Substep& step) : step_(step) {}

    const RowAim& of(const Row& row, int place)
    {
        if (!last_[place] || !alike(row, *last_[place])) aims_[place] = map_row(row, step_, kInf);
        last_[place] = &row;
        return aims_[place];
    }

  private:
    static bool alike(const Row& a, const Row& b)
    {
        return a.kind == b.kind && a.erp == b.erp && a.cfm == b.cfm && a.soft == b.soft && a.drive == b.drive;
    }

    const Substep& step_;
    const Row* last_[kMaxBlockRows] = {};
    RowAim aims_[kMaxBlockRows];
};

// The target of one row.
struct RowTarget {
    Real c, C, relaxed;
};

}  // namespace

// A point needs three free rows, which come first.
template <typename L>
typename JointSetOf<L>::Shape JointSetOf<L>::shape_of(const RowSystem& system, const RowBlock& block)
{
    Shape shape{block.form, block.count, 0};
    for (int i = 0; i < block.count; ++i)
        if (system.numbers[std::size_t(block.first + i)].bounded()) {
            if (i < 3) shape.form = RowForm::kFree;
            ++shape.bounded;
        }
    return shape;
}

template <typename L>
bool JointSetOf<L>::pack(const RowSystem& system, std::span<const int> blocks, Arena& arena)
{
    if (blocks.empty()) return true;
    const auto joints = arena.take<Joint>(int(blocks.size()));
    if (arena.failed()) return false;
    for (std::size_t i = 0; i < blocks.size(); ++i) joints[i] = {blocks[i], 0, 0};
    colour(system, joints, arena);
    if (arena.failed() || !sort(joints, find_shapes(system, joints), arena)) return false;
    int size = 0;
    for (JointBatch& batch : batches_) {
        batch.at = size;
        size += JointLayout(batch).size;
    }
    numbers_ = arena.take<L>(size);
    if (arena.failed()) return false;
    for (std::size_t b = 0; b < batches_.size(); ++b) place(system, b);
    return true;
}

template <typename L>
void JointSetOf<L>::colour(const RowSystem& system, std::span<Joint> joints, Arena& arena)
{
    const auto palettes = arena.take_zeroed<Palette>(int(system.bodies.size()));
    if (arena.failed()) return;
    for (Joint& joint : joints) {
        const RowBlock& block = system.blocks[std::size_t(joint.block)];
        Palette nothing[2];  // for static bodies
        const auto palette_of = [&](int body, Palette& none) -> Palette& {
            const bool moves = body >= 0 && system.bodies[std::size_t(body)].inv_mass > 0;
            return moves ? palettes[std::size_t(body)] : none;
        };
        joint.colour = first_free(palette_of(block.body1, nothing[0]), palette_of(block.body2, nothing[1]));
        colours_ = std::max(colours_, joint.colour + 1);
    }
}

// Numbers the shapes in the order of their first appearance; returns their count.
template <typename L>
int JointSetOf<L>::find_shapes(const RowSystem& system, std::span<Joint> joints)
{
    int count = 0;
    for (Joint& joint : joints) {
        const Shape shape = shape_of(system, system.blocks[std::size_t(joint.block)]);
        joint.shape = int(std::find(shapes_, shapes_ + count, shape) - shapes_);
        if (joint.shape == count) shapes_[count++] = shape;
    }
    return count;
}

// Counting sort by colour, then shape; then cut into eights.
template <typename L>
bool JointSetOf<L>::sort(std::span<Joint> joints, int shapes, Arena& arena)
{
    const int keys = colours_ * shapes;
    const auto starts = arena.take_zeroed<int>(keys + 1);
    const auto order = arena.take<int>(int(joints.size()));
    if (arena.failed()) return false;
    const auto key = [shapes](const Joint& j) { return std::size_t(j.colour * shapes + j.shape); };
    int max_batches = 0;
    for (const Joint& joint : joints)
        if (starts[key(joint) + 1]++ % kLanes == 0) ++max_batches;
    for (std::size_t k = 1; k < starts.size(); ++k) starts[k] += starts[k - 1];
    for (const Joint& joint : joints) order[std::size_t(starts[key(joint)]++)] = joint.block;

    batches_ = arena.take<JointBatch>(max_batches);
    sources_ = arena.take<Source>(max_batches * kLanes);
    if (arena.failed()) return false;
    // After the sort, starts[k] is where the next key begins.
    std::size_t next = 0;
    int from = 0;
    for (int k = 0; k < keys; ++k) {
        const Shape& shape = shapes_[k % shapes];
        for (const int to = starts[std::size_t(k)]; from < to; ++next) {
            const int count = std::min(kLanes, to - from);
            batches_[next] = {shape.form, shape.rows, shape.bounded, count, 0, -1, false, {}, {}};
            for (int lane = 0; lane < kLanes; ++lane)
                sources_[next * kLanes + std::size_t(lane)].block =
                    lane < count ? order[std::size_t(from + lane)] : -1;
            from += count;
        }
    }
    return true;
}

// Bodies, the order of rows, bounds and warm start.
template <typename L>
void JointSetOf<L>::place(const RowSystem& system, std::size_t b)
{
    JointBatch& batch = batches_[b];
    const JointLayout at(batch);
    L* n = &numbers_[std::size_t(batch.at)];
    const int from = batch.count < kLanes ? 0 : at.sum;
    std::memset(static_cast<void*>(n + from), 0, sizeof(L) * std::size_t(at.size - from));
    for (int lane = 0; lane < kLanes; ++lane) {
        Source& source = sources_[b * kLanes + std::size_t(lane)];
        batch.body1[lane] = batch.body2[lane] = second_slot(system, -1);
        if (source.block < 0) continue;
        const RowBlock& block = system.blocks[std::size_t(source.block)];
        batch.body1[lane] = block.body1, batch.body2[lane] = second_slot(system, block.body2);
        source.first = block.first;
        const RowNumbers* numbers = &system.numbers[std::size_t(block.first)];
        int free = 0, bound = batch.rows - batch.bounded;
        for (int i = 0; i < block.count; ++i) {
            const bool has_bounds = numbers[i].bounded();
            const int to = has_bounds ? bound++ : free++;
            source.row[to] = static_cast<unsigned char>(i);
            n[at.p + to][lane] = Number(numbers[i].p);
            if (!has_bounds) continue;
            const int side = to - (batch.rows - batch.bounded);
            n[at.lo + side][lane] = Number(numbers[i].lo), n[at.hi + side][lane] = Number(numbers[i].hi);
        }
    }
}

template <typename L>
void JointSetOf<L>::fill_lane(const RowSystem& system, const RowBlock& block, const Source& source, L* n,
                              int lane, const JointLayout& at, RowForm form) const
{
    static const SolverBody world{};
    const SolverBody& a = system.bodies[std::size_t(block.body1)];
    const SolverBody& b = block.body2 >= 0 ? system.bodies[std::size_t(block.body2)] : world;
    n[JointLayout::kInvMass][lane] = Number(a.inv_mass);
    n[JointLayout::kInvMass + 1][lane] = Number(b.inv_mass);
    set(n + JointLayout::kInvInertia, lane, a.inv_inertia);
    set(n + JointLayout::kInvInertia + 6, lane, b.inv_inertia);
    const Row* rows = &system.rows[std::size_t(block.first)];
    if (form == RowForm::kFree) {
        for (int i = 0; i < block.count; ++i) {
            const Row& row = rows[source.row[i]];
            L* J = n + JointLayout::jacobian(i);
            set(J, lane, row.lin1), set(J + 3, lane, row.ang1);
            const bool two = block.body2 >= 0;
            set(J + 6, lane, two ? row.lin2 : Vec3{}), set(J + 9, lane, two ? row.ang2 : Vec3{});
        }
        return;
    }
    set(n + at.arms, lane, block.arms.r1), set(n + at.arms + 3, lane, block.arms.r2);
    for (int i = 0; form == RowForm::kTurned && i < 3; ++i)
        set(n + at.directions + 3 * i, lane, rows[i].lin1);
    for (int i = 3; i < block.count; ++i) set(n + at.axes + 3 * (i - 3), lane, rows[source.row[i]].ang1);
}

template <typename L>
template <typename Aim>
void JointSetOf<L>::fill(const RowSystem& system, const Aim& aim)
{
    for (std::size_t b = 0; b < batches_.size(); ++b) {
        const JointBatch& batch = batches_[b];
        if (batch.facts >= 0) continue;
        const JointLayout at(batch);
        L* n = &numbers_[std::size_t(batch.at)];
        for (int lane = 0; lane < batch.count; ++lane) {
            const Source& source = sources_[b * kLanes + std::size_t(lane)];
            const RowBlock& block = system.blocks[std::size_t(source.block)];
            fill_lane(system, block, source, n, lane, at, batch.form);
            for (int i = 0; i < block.count; ++i) {
                const RowTarget target = aim(std::size_t(source.first + source.row[i]), i);
                n[at.c + i][lane] = Number(target.c), n[at.C + i][lane] = Number(target.C);
                n[at.relaxed + i][lane] = Number(target.relaxed);
            }
        }
    }
}

template <typename L>
void JointSetOf<L>::load(const RowSystem& system)
{
    fill(system, [&](std::size_t row, int) {
        const RowNumbers& n = system.numbers[row];
        return RowTarget{n.c, n.C, n.c};
    });
    kernels_->begin(batches_.data(), int(batches_.size()), numbers_.data(), {nullptr, nullptr, false, 0});
}

template <typename L>
bool JointSetOf<L>::follow(const RowSystem& system, const Substep& step, std::span<const Velocity> bodies,
                           Arena& arena)
{
    int size = 0;
    for (JointBatch& batch : batches_) {
        if (batch.form == RowForm::kFree) continue;
        batch.facts = size;
        size += FactLayout(batch).size;
    }
    facts_ = arena.take<L>(size);
    if (arena.failed()) return false;
    JointRows from{{}, {}, system.poses.data(), bodies.data(), step};
    for (std::size_t b = 0; b < batches_.size(); ++b)
        if (batches_[b].facts >= 0) take_facts(system, b, from);
    return true;
}

template <typename L>
void JointSetOf<L>::take_facts(const RowSystem& system, std::size_t b, JointRows& from)
{
    static constexpr Row kNoRow{};
    static constexpr RowBlock kNoBlock{};
    JointBatch& batch = batches_[b];
    const FactLayout fact(batch);
    L* f = &facts_[std::size_t(batch.facts)];
    // Lanes without a joint must hold finite numbers.
    const int blank = batch.count < kLanes ? 0 : fact.keeps;
    std::memset(static_cast<void*>(f + blank), 0, sizeof(L) * std::size_t(fact.size - blank));
    for (int lane = 0; lane < batch.count; ++lane) {
        const Source& source = sources_[b * kLanes + std::size_t(lane)];
        RowBlock& block = system.blocks[std::size_t(source.block)];
        from.block[lane] = &block, block.followed = true;
        for (int i = 0; i < batch.rows; ++i) {
            const Row& row = system.rows[std::size_t(source.first + source.row[i])];
            from.row[i][lane] = &row;
            if (row.soft) f[fact.keeps + i][lane] = 1;
            if (row.has_restitution) batch.has_restitution = true;
        }
    }
    for (int lane = batch.count; lane < kLanes; ++lane) {
        from.block[lane] = &kNoBlock;
        for (int i = 0; i < batch.rows; ++i) from.row[i][lane] = &kNoRow;
    }
    kernels_->take_facts(batch, &numbers_[std::size_t(batch.at)], f, from);
}

template <typename L>
void JointSetOf<L>::load_substep(const RowSystem& system, const Substep& step)
{
    AimMap aims(step);
    fill(system, [&](std::size_t i, int place) {
        const Row& row = system.rows[i];
        const RowAim& aim = aims.of(row, place);
        const Real c = std::min(aim.rate * row.error + target_speed(row, step), row.cap);
        return RowTarget{c, aim.C, aim.spring ? c : std::min(row.speed, row.cap)};
    });
    kernels_->begin(batches_.data(), int(batches_.size()), numbers_.data(),
                    {facts_.data(), system.poses.data(), false, kSoftShare});
}

template <typename L>
void JointSetOf<L>::turn(const RowSystem& system)
{
    kernels_->begin(batches_.data(), int(batches_.size()), numbers_.data(),
                    {facts_.data(), system.poses.data(), true, kSoftShare});
}

template <typename L>
void JointSetOf<L>::apply_impulses(std::span<Velocity> bodies) const
{
    kernels_->on_velocities.apply_impulses(batches_.data(), int(batches_.size()), numbers_.data(),
                                           bodies.data());
}

template <typename L>
void JointSetOf<L>::sweep(std::span<Velocity> bodies, const JointSweep& how)
{
    kernels_->on_velocities.sweep(batches_.data(), int(batches_.size()), numbers_.data(), bodies.data(), how);
}

template <>
void FloatJointSet::apply_impulses(std::span<FloatVelocity> bodies) const
{
    machine_->floats->on_floats.apply_impulses(batches_.data(), int(batches_.size()), numbers_.data(),
                                               bodies.data());
}

template <>
void FloatJointSet::sweep(std::span<FloatVelocity> bodies, const JointSweep& how)
{
    machine_->floats->on_floats.sweep(batches_.data(), int(batches_.size()), numbers_.data(), bodies.data(),
                                      how);
}

// Calls f(row of the system, its place in the batch, the batch's numbers and layout, lane).
template <typename L>
template <typename Visit>
void JointSetOf<L>::for_each_row(Visit&& f) const
{
    for (std::size_t b = 0; b < batches_.size(); ++b) {
        const JointBatch& batch = batches_[b];
        const JointLayout at(batch);
        const L* n = &numbers_[std::size_t(batch.at)];
        for (int lane = 0; lane < batch.count; ++lane) {
            const Source& source = sources_[b * kLanes + std::size_t(lane)];
            for (int i = 0; i < batch.rows; ++i) f(std::size_t(source.first + source.row[i]), i, n, at, lane);
        }
    }
}

template <typename L>
void JointSetOf<L>::store_impulses(std::span<RowNumbers> numbers) const
{
    for_each_row([&](std::size_t row, int i, const L* n, const JointLayout& at, int lane) {
        numbers[row].p = n[at.p + i][lane];
    });
}

template <typename L>
void JointSetOf<L>::sum_impulses()
{
    for (const JointBatch& batch : batches_) {
        const JointLayout at(batch);
        L* n = &numbers_[std::size_t(batch.at)];
        for (int i = 0; i < batch.rows; ++i)
            for (int lane = 0; lane < kLanes; ++lane) n[at.sum + i][lane] += n[at.p + i][lane];
    }
}

template <typename L>
void JointSetOf<L>::store_sums(std::span<RowNumbers> numbers) const
{
    for_each_row([&](std::size_t row, int i, const L* n, const JointLayout& at, int lane) {
        numbers[row].p = n[at.sum + i][lane];
    });
}

template <typename L>
void JointSetOf<L>::describe(std::span<RowNumbers> numbers, std::span<Row> rows) const
{
    describe_rows(rows);
    for_each_row([&](std::size_t row, int i, const L* n, const JointLayout& at, int lane) {
        numbers[row].c = n[at.c + i][lane];
        numbers[row].C = n[at.C + i][lane];
        numbers[row].p = n[at.p + i][lane];
    });
}

template <typename L>
void JointSetOf<L>::describe_rows(std::span<Row> rows) const
{
    const auto vec_at = [](const L* n, int lane) { return Vec3{n[0][lane], n[1][lane], n[2][lane]}; };
    for (std::size_t b = 0; b < batches_.size(); ++b) {
        const JointBatch& batch = batches_[b];
        if (batch.facts < 0) continue;
        const JointLayout at(batch);
        const L* n = &numbers_[std::size_t(batch.at)];
        for (int lane = 0; lane < batch.count; ++lane) {
            const Source& source = sources_[b * kLanes + std::size_t(lane)];
            const Vec3 r1 = vec_at(n + at.arms, lane), r2 = vec_at(n + at.arms + 3, lane);
            for (int i = 0; i < batch.rows; ++i) {
                Row& row = rows[std::size_t(source.first + source.row[i])];
                if (i < 3 && batch.form == RowForm::kTurned)
                    row.lin1 = vec_at(n + at.directions + 3 * i, lane);
                row.ang1 = i < 3 ? cross(r1, row.lin1) : vec_at(n + at.axes + 3 * (i - 3), lane);
                row.lin2 = -row.lin1;
                row.ang2 = i < 3 ? -cross(r2, row.lin1) : -row.ang1;
            }
        }
    }
}

template <typename L>
void JointSetOf<L>::apply_restitution(const RowSystem& system, std::span<Velocity> bodies)
{
    for (std::size_t b = 0; b < batches_.size(); ++b) {
        if (batches_[b].facts >= 0 && !batches_[b].has_restitution) continue;
        const JointLayout at(batches_[b]);
        L* n = &numbers_[std::size_t(batches_[b].at)];
        bool lanes[kLanes] = {};
        for (int lane = 0; lane < batches_[b].count; ++lane) {
            const Source& source = sources_[b * kLanes + std::size_t(lane)];
            for (int i = 0; i < batches_[b].rows; ++i) {
                const auto k = std::size_t(source.first + source.row[i]);
                const Row& row = system.rows[k];
                if (!row.has_restitution || n[at.sum + i][lane] + n[at.p + i][lane] == 0) continue;
                n[at.relaxed + i][lane] = Number(row.restitution_velocity);
                lanes[lane] = true;
            }
        }
        if (std::find(lanes, lanes + kLanes, true) != lanes + kLanes)
            visit_lanes(batches_[b], lanes, n, second_slot(system, -1), bodies);
    }
}

// The other lanes are blanked in a copy, and act on the world.
template <typename L>
void JointSetOf<L>::visit_lanes(const JointBatch& batch, const bool* lanes, L* n, int world,
                                std::span<Velocity> bodies)
{
    constexpr JointLayout kLargest(RowForm::kFree, kMaxBlockRows, kMaxBlockRows);
    const JointLayout at(batch);
    L copy[std::size_t(kLargest.size)];
    JointBatch one = batch;
    one.at = 0;
    std::copy_n(n, at.size, copy);
    for (int lane = 0; lane < kLanes; ++lane) {
        if (lanes[lane]) continue;
        one.body1[lane] = one.body2[lane] = world;
        for (L& numbers : std::span(copy, std::size_t(at.size))) numbers[lane] = 0;
    }
    kernels_->on_velocities.sweep(&one, 1, copy, bodies.data(), {1, true});
    for (int i = 0; i < batch.rows; ++i)
        for (int lane = 0; lane < kLanes; ++lane)
            if (lanes[lane]) n[at.p + i][lane] = copy[at.p + i][lane];
}

template class JointSetOf<Lanes>;
template class JointSetOf<FloatLanes>;

}  // namespace epode
