// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See batch.h.
#include "batch/batch.h"

#include "batch/asker.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <new>

#include "batch/derivatives/derivatives.h"
#include "batch/lanes/observed.h"

namespace epode::batch {

namespace {

struct FreeAligned {
    void operator()(void* block) const { ::operator delete(block, std::align_val_t(64)); }
};
using Block = std::unique_ptr<void, FreeAligned>;
Block block_of(std::size_t bytes) { return Block(::operator new(bytes, std::align_val_t(64))); }

template <typename T>
class Batch : public AnyBatch {
  public:
    Batch(BatchModel model, int copies, int threads, bool is_pinned)
        : AnyBatch(std::move(model), copies),
          kernels_(best_kernels<T>()),
          view_(model_),
          layout_(model_),
          observed_(model_),
          lanes_(kernels_.lanes),
          groups_((copies + lanes_ - 1) / lanes_),
          state_(block_of(std::size_t(groups_) * group_numbers() * sizeof(T))),
          numbers_(model_.numbers.begin(), model_.numbers.end()),
          crew_(threads, is_pinned)
    {
        for (int i = 0; i < crew_.size(); ++i) {
            work_.push_back(block_of(kernels_.work_size(view_)));
            askers_.push_back(std::make_unique<PairAsker>(model_.asked));
            kernels_.make_work(view_, askers_.back()->asker(), work_.back().get());
            observations_.push_back(block_of(std::size_t(observed_.rows) * std::size_t(lanes_) * sizeof(T)));
        }
        std::fill_n(static_cast<T*>(state_.get()), std::size_t(groups_) * group_numbers(), T(0));
        for (int i = 0; i < groups_ * lanes_; ++i) put_at_reference(i);
        if (sizeof(T) == 4) options_.tolerance = 1e-5;
    }

    int number_size() const override { return int(sizeof(T)); }
    int threads() const override { return crew_.size(); }

    void read(Quantity quantity, int first, int count, void* to) const override
    {
        T* out = static_cast<T*>(to);
        const int end = first + count;
        for (int next = first; first < end; first = next) {
            next = std::min(end, (first / lanes_ + 1) * lanes_);
            if (is_observed(quantity)) observe(first / lanes_, 0, what_of(quantity));
            copy_out(quantity, first, next - first, 0, out);
            out += std::size_t(next - first) * std::size_t(size_of(quantity));
        }
    }

    bool write(Quantity quantity, int first, int count, const void* from) override
    {
        const int size = size_of(quantity);
        const T* in = static_cast<const T*>(from);
        for (int i = 0; i < count; ++i)
            if (!can_be(quantity, in + std::size_t(i) * std::size_t(size))) return false;
        for (int i = 0; i < count; ++i, in += size) put(quantity, first + i, in);
        return true;
    }

    void bind(Quantity quantity, void* array) override
    {
        bound_[std::size_t(quantity)] = static_cast<T*>(array);
    }

    void watch(Quantity quantity, void* array) override
    {
        watched_[std::size_t(quantity)] = static_cast<T*>(array);
    }

    bool step(int steps, const Visit* visit) override
    {
        for (Quantity quantity : kWritable) {
            const bool is_read = !visit || quantity != Quantity::kControls;  // who visits gives the controls
            const T* array = is_read ? bound(quantity) : nullptr;
            if (array && !write(quantity, 0, copies_, array)) return false;
        }
        crew_.work(groups_, [&](int group, int worker) {
            for (int i = 0; i < steps; ++i)
                kernels_.step(view_, options_, numbers_of(group), are_own(), group_of(group),
                              work_[std::size_t(worker)].get());
            write_bound(group, worker);
            if (visit) (*visit)(group * lanes_, std::min(lanes_, copies_ - group * lanes_), worker);
        });
        return true;
    }

    void reset(const unsigned char* mask) override
    {
        for (int i = 0; i < copies_; ++i)
            if (!mask || mask[i]) put_at_reference(i);
        for (int group = 0; group < groups_; ++group) write_bound(group, 0);
    }

    void reset_copy(int copy) override { put_at_reference(copy); }

    void refresh(int first, int count, int worker) override
    {
        for (int group = first / lanes_; group * lanes_ < first + count; ++group) write_bound(group, worker);
    }

    int bad() const override
    {
        int count = 0;
        for (int i = 0; i < copies_; ++i) count += at(i, layout_.bad) > 0;
        return count;
    }

    void cast(const Rays& rays, int first, int count, void* ranges, int* shapes) override
    {
        while (int(casters_.size()) < crew_.size()) casters_.push_back(std::make_unique<RayCaster>(model_));
        T* out = static_cast<T*>(ranges);
        crew_.work((first + count + lanes_ - 1) / lanes_ - first / lanes_, [&](int piece, int worker) {
            const int group = first / lanes_ + piece;
            observe(group, worker, kOfState);
            for (int copy = std::max(first, group * lanes_);
                 copy < std::min(first + count, (group + 1) * lanes_); ++copy) {
                RayCaster& caster = *casters_[std::size_t(worker)];
                caster.put([&](int link) { return link_pose(copy, link, worker); });
                const std::size_t its = std::size_t(copy - first) * std::size_t(rays.count);
                caster.cast(rays, [&](int i, const RayHit& hit) {
                    out[its + std::size_t(i)] = T(hit.range);
                    if (shapes) shapes[its + std::size_t(i)] = hit.shape;
                });
            }
        });
    }

    void read(Parameter parameter, int first, int count, void* to) const override
    {
        const int size = batch::size_of(model_, parameter);
        T* out = static_cast<T*>(to);
        for (int i = first; i < first + count; ++i)
            for (int k = 0; k < size; ++k) *out++ = number(i, place_of(model_, parameter, k));
    }

    bool write(Parameter parameter, int first, int count, const void* from) override
    {
        const int size = batch::size_of(model_, parameter);
        const T* in = static_cast<const T*>(from);
        for (int i = 0; i < count * size; ++i)
            if (!batch::can_be(model_, parameter, i % size, double(in[i]))) return false;
        own_numbers();
        for (int i = first; i < first + count; ++i)
            for (int k = 0; k < size; ++k) put_number(parameter, i, k, *in++);
        return true;
    }

    // Copies of one group that follow one another share its pass.
    void jacobian(int link, const double* point, const std::vector<int>& copies, void* to) override
    {
        const std::size_t size = 6 * std::size_t(model_.velocities), lanes = std::size_t(lanes_);
        const Block rows = block_of(size * lanes * sizeof(T));
        T *out = static_cast<T*>(to), *its = static_cast<T*>(rows.get());
        int last = -1;
        for (const int copy : copies) {
            const int group = copy / lanes_, lane = copy % lanes_;
            if (group != last)
                kernels_.jacobian(view_, numbers_of(group), are_own(), group_of(group), work_[0].get(), link,
                                  point, its);
            last = group;
            for (std::size_t k = 0; k < size; ++k) *out++ = its[k * lanes + std::size_t(lane)];
        }
    }

    void differentiate(const std::vector<int>& copies, const DerivativeOptions& how,
                       const std::vector<ColumnBlock>& blocks) override
    {
        while (int(derivatives_.size()) < crew_.size())
            derivatives_.push_back(std::make_unique<Derivatives<T>>(model_, view_, kernels_));
        std::atomic<bool> lacks_memory{false};
        crew_.work(int(copies.size()), [&](int piece, int worker) {
            try {
                differentiate(copies[std::size_t(piece)], piece, worker, how, blocks);
            } catch (const std::bad_alloc&) {
                lacks_memory = true;
            }
        });
        if (lacks_memory) throw std::bad_alloc();
    }

  private:
    static constexpr Quantity kWritable[] = {Quantity::kPositions, Quantity::kVelocities, Quantity::kControls,
                                             Quantity::kApplied, Quantity::kActivations};

    std::size_t group_numbers() const { return std::size_t(layout_.rows) * std::size_t(lanes_); }
    T* group_of(int group) const
    {
        return static_cast<T*>(state_.get()) + std::size_t(group) * group_numbers();
    }
    T* bound(Quantity quantity) const { return bound_[std::size_t(quantity)]; }
    T& at(int copy, int row) const { return group_of(copy / lanes_)[row * lanes_ + copy % lanes_]; }

    int row_of(Quantity quantity) const
    {
        const int rows[] = {layout_.q,
                            layout_.v,
                            layout_.control,
                            layout_.applied,
                            layout_.forces,
                            layout_.bad,
                            layout_.residual,
                            layout_.sweeps,
                            layout_.activations,
                            observed_.position,
                            observed_.turn,
                            observed_.velocity,
                            observed_.inertia,
                            observed_.contact,
                            observed_.centre,
                            observed_.actuator,
                            observed_.constraint,
                            observed_.sensor};
        return rows[int(quantity)];
    }

    static int what_of(Quantity quantity)
    {
        const bool is_of_step = quantity == Quantity::kLinkForces || quantity == Quantity::kConstraintForces;
        return quantity == Quantity::kSensors ? kOfSensors : is_of_step ? kOfStep : kOfState;
    }

    T* observations(int worker) const { return static_cast<T*>(observations_[std::size_t(worker)].get()); }

    void observe(int group, int worker, int what) const
    {
        kernels_.observe(view_, options_, numbers_of(group), are_own(), group_of(group),
                         work_[std::size_t(worker)].get(), what, observations(worker));
    }

    // Of copies of one group, which the worker has observed if need be.
    void copy_out(Quantity quantity, int first, int count, int worker, T* out) const
    {
        const int size = size_of(quantity);
        const T* rows = is_observed(quantity) ? observations(worker) : group_of(first / lanes_);
        rows += row_of(quantity) * lanes_ + first % lanes_;
        for (int i = 0; i < count; ++i, out += size) {
            for (int k = 0; k < size; ++k) out[k] = rows[k * lanes_ + i];
            if (quantity != Quantity::kVelocities) continue;
            for (const BatchJoint& joint : model_.joints)
                if (floats(joint)) turn_rate(joint, first + i, false, out + joint.dof + 3);
        }
    }

    // Of a group that the worker has observed.
    robots::Pose link_pose(int copy, int link, int worker) const
    {
        const auto number = [&](int row) {
            return double(observations(worker)[row * lanes_ + copy % lanes_]);
        };
        const int p = observed_.position + 3 * link, q = observed_.turn + 4 * link;
        const bool stands_still = model_.links[std::size_t(link)].last_dof < 0;
        robots::Vec at{number(p), number(p + 1), number(p + 2)};
        for (int k = 0; stands_still && k < 3; ++k) at[k] += double(this->number(copy, model_.terrain + k));
        return {at, {number(q), number(q + 1), number(q + 2), number(q + 3)}};
    }

    void put_at_reference(int copy)
    {
        for (int row = 0; row < layout_.rows; ++row) at(copy, row) = 0;
        for (int k = 0; k < model_.positions; ++k)
            at(copy, layout_.q + k) = at(copy, layout_.before + k) = T(model_.reference[std::size_t(k)]);
    }

    void differentiate(int copy, int piece, int worker, const DerivativeOptions& how,
                       std::vector<ColumnBlock> blocks)
    {
        std::vector<T> rows(static_cast<std::size_t>(layout_.rows)), numbers(are_own() ? numbers_.size() : 0);
        const T* group = group_of(copy / lanes_) + copy % lanes_;
        for (std::size_t row = 0; row < rows.size(); ++row) rows[row] = group[row * std::size_t(lanes_)];
        for (std::size_t k = 0; k < numbers.size(); ++k) numbers[k] = own_[own_place(copy, int(k))];
        for (ColumnBlock& block : blocks)
            block.to =
                static_cast<T*>(block.to) + std::size_t(piece) * std::size_t(tangents() * block.columns);
        derivatives_[std::size_t(worker)]->find(rows.data(), are_own() ? numbers.data() : numbers_.data(),
                                                numbers_.data(), options_, how, blocks,
                                                work_[std::size_t(worker)].get());
    }

    bool are_own() const { return !own_.empty(); }
    std::size_t own_place(int copy, int number) const
    {
        const std::size_t group = std::size_t(copy / lanes_) * numbers_.size();
        return (group + std::size_t(number)) * std::size_t(lanes_) + std::size_t(copy % lanes_);
    }
    T number(int copy, int number) const
    {
        return are_own() ? own_[own_place(copy, number)] : numbers_[std::size_t(number)];
    }

    // From now on each copy has all numbers of the model for itself.
    void own_numbers()
    {
        if (are_own()) return;
        own_.resize(std::size_t(groups_) * numbers_.size() * std::size_t(lanes_));
        for (int i = 0; i < groups_ * lanes_; ++i)
            for (std::size_t k = 0; k < numbers_.size(); ++k) own_[own_place(i, int(k))] = numbers_[k];
    }

    void put_number(Parameter parameter, int copy, int which, T value)
    {
        each_number(model_, numbers_.data(), parameter, which, value,
                    [&](int place, T its) { own_[own_place(copy, place)] = its; });
    }

    const T* numbers_of(int group) const
    {
        return are_own() ? own_.data() + std::size_t(group) * numbers_.size() * std::size_t(lanes_)
                         : numbers_.data();
    }

    static bool floats(const BatchJoint& joint) { return joint.kind == JointKind::kFree; }
    static bool turns(const BatchJoint& joint) { return floats(joint) || joint.kind == JointKind::kBall; }
    static int quaternion_of(const BatchJoint& joint) { return joint.position + (floats(joint) ? 3 : 0); }

    // A floating base's angular velocity, between its link's axes and the world's.
    void turn_rate(const BatchJoint& joint, int copy, bool to_world, T* a) const
    {
        const int q = layout_.q + quaternion_of(joint);
        const T sign = to_world ? T(1) : T(-1), w = at(copy, q);
        const T x = sign * at(copy, q + 1), y = sign * at(copy, q + 2), z = sign * at(copy, q + 3);
        const T tx = 2 * (y * a[2] - z * a[1]), ty = 2 * (z * a[0] - x * a[2]),
                tz = 2 * (x * a[1] - y * a[0]);
        const T out[3] = {a[0] + w * tx + (y * tz - z * ty), a[1] + w * ty + (z * tx - x * tz),
                          a[2] + w * tz + (x * ty - y * tx)};
        std::copy_n(out, 3, a);
    }

    void turn_stored_rate(const BatchJoint& joint, int copy, bool to_world)
    {
        const int row = layout_.v + joint.dof + 3;
        T rate[3] = {at(copy, row), at(copy, row + 1), at(copy, row + 2)};
        turn_rate(joint, copy, to_world, rate);
        for (int k = 0; k < 3; ++k) at(copy, row + k) = rate[k];
    }

    // Numbers whose squares are finite.
    bool can_be(Quantity quantity, const T* its) const
    {
        const T most = sizeof(T) == 4 ? T(1e15) : T(1e60);
        const int size = size_of(quantity);
        if (!std::all_of(its, its + size, [&](T x) { return std::fabs(x) < most; })) return false;
        if (quantity != Quantity::kPositions) return true;
        return std::all_of(model_.joints.begin(), model_.joints.end(), [&](const BatchJoint& joint) {
            return !turns(joint) || length2(its + quaternion_of(joint)) > T(1e-6);
        });
    }

    static T length2(const T* q) { return q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]; }

    void put(Quantity quantity, int copy, const T* values)
    {
        if (quantity == Quantity::kPositions) {
            for (const BatchJoint& joint : model_.joints) put_position(joint, copy, values + joint.position);
            return;
        }
        const int row = row_of(quantity);
        for (int k = 0; k < size_of(quantity); ++k) at(copy, row + k) = values[k];
        if (quantity != Quantity::kVelocities) return;
        for (const BatchJoint& joint : model_.joints)
            if (floats(joint)) turn_stored_rate(joint, copy, true);
    }

    // A floating base keeps the angular velocity that is seen, in its link's axes.
    void put_position(const BatchJoint& joint, int copy, const T* values)
    {
        const int row = layout_.q + joint.position;
        bool changes = false;
        for (int k = 0; k < coordinates(joint.kind); ++k) changes |= at(copy, row + k) != values[k];
        if (!changes) return;
        if (floats(joint)) turn_stored_rate(joint, copy, false);
        for (int k = 0; k < coordinates(joint.kind); ++k) at(copy, row + k) = values[k];
        if (turns(joint)) make_unit(copy, layout_.q + quaternion_of(joint));
        if (floats(joint)) turn_stored_rate(joint, copy, true);
    }

    void make_unit(int copy, int row)
    {
        const T q[4] = {at(copy, row), at(copy, row + 1), at(copy, row + 2), at(copy, row + 3)};
        const T length = std::sqrt(length2(q));
        if (std::fabs(length - 1) > 4 * std::numeric_limits<T>::epsilon())
            for (int k = 0; k < 4; ++k) at(copy, row + k) = q[k] / length;
    }

    void write_bound(int group, int worker)
    {
        const int first = group * lanes_, count = std::min(lanes_, copies_ - first);
        int what = 0;
        for (int q = int(Quantity::kLinkPositions); q < int(Quantity::kCount); ++q)
            if (bound_[std::size_t(q)] || watched_[std::size_t(q)]) what |= what_of(Quantity(q));
        if (what != 0) observe(group, worker, what);
        for (int q = 0; q < int(Quantity::kCount); ++q)
            for (T* array : {bound_[std::size_t(q)], watched_[std::size_t(q)]})
                if (array)
                    copy_out(Quantity(q), first, count, worker,
                             array + std::size_t(first) * std::size_t(size_of(Quantity(q))));
    }

    const Kernels<T>& kernels_;
    ModelView view_;
    GroupLayout layout_;
    ObservedLayout observed_;
    int lanes_, groups_;
    Block state_;
    std::vector<T> numbers_;
    std::vector<T> own_;  // rows of lanes, group by group; empty: all copies share numbers_
    std::vector<Block> work_, observations_;           // of each thread
    std::vector<std::unique_ptr<PairAsker>> askers_;   // of each thread
    std::vector<std::unique_ptr<RayCaster>> casters_;  // of each thread, once rays are cast
    std::array<T*, std::size_t(Quantity::kCount)> bound_{}, watched_{};
    std::vector<std::unique_ptr<Derivatives<T>>> derivatives_;  // of each thread, once asked for
    Crew crew_;
};

}  // namespace

int AnyBatch::size_of(Quantity quantity) const
{
    switch (quantity) {
        case Quantity::kPositions:
            return model_.positions;
        case Quantity::kControls:
            return model_.controls;
        case Quantity::kActivations:
            return model_.filters;
        case Quantity::kForces:
            return model_.impulses();
        case Quantity::kVelocities:
        case Quantity::kApplied:
        case Quantity::kActuatorForces:
        case Quantity::kConstraintForces:
            return model_.velocities;
        case Quantity::kLinkPositions:
            return 3 * int(model_.links.size());
        case Quantity::kLinkTurns:
            return 4 * int(model_.links.size());
        case Quantity::kLinkVelocities:
        case Quantity::kLinkForces:
            return 6 * int(model_.links.size());
        case Quantity::kLinkInertias:
            return 10 * int(model_.links.size());
        case Quantity::kCentre:
            return 3;
        case Quantity::kSensors:
            return model_.sensor_values;
        default:
            return 1;
    }
}

std::unique_ptr<AnyBatch> make_batch(BatchModel model, int copies, bool doubles, int threads, bool is_pinned)
{
    if (doubles) return std::make_unique<Batch<double>>(std::move(model), copies, threads, is_pinned);
    return std::make_unique<Batch<float>>(std::move(model), copies, threads, is_pinned);
}

}  // namespace epode::batch
