// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The equations of JointNetwork (joint_network.h) where joints are trees,
//
//   M dv = J^T dp,   J dv + C dp = r,
//
// eliminated from the leaves, as in articulated-body algorithms (Featherstone 2008, chapter 7) but with the rows
// as they are. P_b is the mass matrix of a body b with all that hangs on it; its joint with its parent a has rows
// B and A:
//
//   D = P_b^-1,   Y = D B^T,   Q = (B Y + C)^-1,   T = Q A,   P_a += A^T T
//   q = Q (r - Y^T f_b),   f_a += A^T q                       leaves first
//   dp = q - T dv_a,       dv_b = D f_b + Y dp                root first
//
// Nothing fills in, and the work is proportional to the joints. Four bodies of which none hangs on another are a batch
// (forest_kernels.h): limbs of one figure, or of several. A root that nothing holds is a body without rows. The arithmetic is in double
// whatever Real is.
#pragma once

#include <span>

#include "base/arena.h"
#include "rows/row_system.h"
#include "solve/substeps/forest_kernels.h"
#include "solve/substeps/network_rows.h"

namespace epode {

class JointForest {
  public:
    static constexpr int kMaxRows = 12;  // of a joint
    // Trees that are factored together, small ones until they fill batches: joints [first, last) of the order.
    struct Bundle {
        int first, last;
        int first_link, last_link, first_batch, last_batch;
    };

    void use(const ForestKernels& kernels) { kernels_ = &kernels; }

    // False: out of memory. If there are loops, two joints of the same bodies among them, is_forest() is false.
    bool build(const RowSystem& system, std::span<const NetworkJoint> joints, Arena& arena);
    bool is_forest() const { return is_forest_; }
    std::span<const int> order() const { return {order_.data(), std::size_t(joints_found_)}; }
    std::span<const Bundle> bundles() const { return {bundles_.data(), std::size_t(bundle_count_)}; }

    // Of joints in that order.
    bool prepare(std::span<const NetworkJoint> joints, Arena& arena);
    void factor(const RowSystem& system, std::size_t bundle, std::span<const NetworkJoint> joints,
                std::span<const NetworkRow> rows);
    // x, a number for each row: r becomes dp. Rows out of the factor are not touched.
    void solve(std::size_t bundle, std::span<const NetworkJoint> joints, std::span<double> x);

  private:
    static constexpr int kBody = 24, kWide = 4;  // numbers of a triangle of six, in fours; bodies of a batch
    // A body, and what holds it.
    struct Link {
        int body, parent;  // parent: -1 if it cannot move, or nothing holds the body
        int joint;         // in the order, or -1
        int side;          // of the body in its joint
        int batch;
        int count;  // rows in the factor
        unsigned char row[kMaxRows];
    };
    struct Batch {
        ForestBatch numbers;
        int link[kWide];  // or -1
        int rows;         // most that a lane may have
    };
    bool list_ends(const RowSystem& system, std::span<const NetworkJoint> joints, Arena& arena);
    bool grow(std::span<const NetworkJoint> joints, int body, int joint);
    bool visit(std::span<const NetworkJoint> joints, int body, int joint);
    void add_link(int body, int parent, int joint);
    void end_tree(int first_link, int first_joint);

    bool schedule(std::span<const NetworkJoint> joints, Arena& arena);
    void schedule(Bundle& bundle, std::span<const NetworkJoint> joints);
    int first_open(int batch);
    void enter(int link, int batch, int rows);
    bool take_numbers(Arena& arena);

    static void load_mass(const SolverBody& body, bool inverse, double* to);
    void gather(Batch& batch, std::span<const NetworkJoint> joints, std::span<const NetworkRow> rows);
    void gather_rows(const ForestBatch& batch, int lane, Link& link, std::span<const NetworkRow> rows);
    ForestNode* node(int body, std::size_t else_spare)
    {
        return &nodes_[body < 0 ? seen_.size() + else_spare : std::size_t(body)];
    }
    template <typename F>
    void for_rows(const Bundle& bundle, std::span<const NetworkJoint> joints, F&& f);

    const ForestKernels* kernels_ = forest_kernels().back();
    std::span<Bundle> bundles_;
    std::span<Link> links_;
    std::span<Batch> batches_;
    std::span<ForestNode>
        nodes_;  // by body; then that of lanes without one, and the parent of those that have none
    std::span<ForestLanes> numbers_;
    std::span<int> order_, first_, ends_;
    std::span<int> ready_;  // by body: the first batch after those of what hangs on it
    std::span<int> next_;   // by batch: itself while it takes links
    std::span<unsigned char> seen_;
    int bundle_count_ = 0, links_found_ = 0, joints_found_ = 0, batch_count_ = 0;
    bool is_forest_ = false;
};

}  // namespace epode
