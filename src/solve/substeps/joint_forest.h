// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The equations of JointNetwork (joint_network.h) where joints are trees,
//
//   M dv = J^T dp,   J dv + C dp = r,
//
// eliminated from the leaves, as in articulated-body algorithms (Featherstone 2008, chapter 7) but with the rows
// as they are. P_b is the mass matrix of a body b with all that hangs on it; its joint with its parent a has rows
// J_b and J_a. With L L^T = P_b:
//
//   W = L^-1 J_b^T,   K = W^T W + C = G G^T,   U = G^-1 J_a,   P_a += U^T U
//   z = L^-1 f_b,     g = G^-1 (r - W^T z),    f_a += U^T g          leaves first
//   dp = G^-T (g - U dv_a),   dv_b = L^-T (z + W dp)                 root first
//
// Nothing fills in, and the work is proportional to the joints: a body with many limbs costs what they cost
// one by one, and a tree whose rows change is factored alone. The arithmetic is in double whatever Real is.
#pragma once

#include <span>

#include "base/arena.h"
#include "rows/row_system.h"
#include "solve/substeps/network_rows.h"

namespace epode {

class JointForest {
  public:
    static constexpr int kMaxRows = 12;  // of a joint
    // Joints [first, last) of the order, parents before children; root: the body that nothing holds, or -1.
    struct Tree {
        int first, last, root;
    };

    // False: out of memory. If there are loops, two joints of the same bodies among them, is_forest() is false.
    bool build(const RowSystem& system, std::span<const NetworkJoint> joints, Arena& arena);
    bool is_forest() const { return is_forest_; }
    std::span<const int> order() const { return order_; }
    std::span<const Tree> trees() const { return {trees_.data(), std::size_t(tree_count_)}; }

    // Of joints in that order.
    bool prepare(std::span<const NetworkJoint> joints, Arena& arena);
    void factor(const RowSystem& system, std::size_t tree, std::span<const NetworkJoint> joints,
                std::span<const NetworkRow> rows);
    // x, a number for each row: r becomes dp. Rows out of the factor are not touched.
    void solve(std::size_t tree, std::span<const NetworkJoint> joints, std::span<double> x);

  private:
    static constexpr int kBody = 21;  // lower triangle of six
    struct Link {
        int body, parent;  // parent: -1 if it cannot move
        int side;          // of the body in its joint
        int count;         // rows in the factor
        unsigned char row[kMaxRows];
        double *L, *W, *G, *U;
        double z[6];
    };
    // What is computed of a body.
    struct Node {
        double P[kBody], f[6], dv[6];
    };

    bool list_ends(const RowSystem& system, std::span<const NetworkJoint> joints, Arena& arena);
    bool grow(std::span<const NetworkJoint> joints, int body, int joint);
    bool visit(std::span<const NetworkJoint> joints, int body, int joint);
    void add_link(int body, int parent, int joint);
    void load_mass(const SolverBody& body, Node& node) const;
    void factor_link(Link& link, std::span<const NetworkRow> rows);
    void hand_on(const Link& link, std::span<const NetworkRow> rows);
    void eliminate(Link& link, double* x);
    void substitute(Link& link, double* x);

    std::span<Tree> trees_;
    std::span<Link> links_;
    std::span<Node> nodes_;  // by body
    std::span<double> numbers_, roots_;
    std::span<int> order_, first_, ends_;
    std::span<unsigned char> seen_;
    int tree_count_ = 0, links_found_ = 0;
    bool is_forest_ = false;
};

}  // namespace epode
