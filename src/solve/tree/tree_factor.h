// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The mass matrix of a tree in joint coordinates and its factor (Featherstone 2008, sections 6.2 and 6.5),
//
//   H = T^T M T + sum j j^T / C = L^T D L,   L unit lower triangular,   H_ki = 0 unless i lies on the chain of k
//
// by composite inertias from the leaves; j, C: rows that only yield (armature, springs, dampers) and move one joint. L fills nothing in.
// Row k of H and L has its entries along the chain, root first. z = D^1/2 L u turns the energy u H u / 2 into z z / 2.
#pragma once

#include "solve/tree/joint_tree.h"

namespace epode {

class TreeFactor {
  public:
    bool prepare(const JointTree& tree, Arena& arena);  // False: out of memory

    // T^T M T of the bodies' inertias, which `inertia(link)` returns about their centres.
    template <typename InertiaOf>
    void assemble(const JointTree& tree, InertiaOf&& inertia);
    // H_ab += x; a and b are dofs of one chain.
    void add(int a, int b, double x)
    {
        if (a < b) std::swap(a, b);
        entry(a, b) += x;
    }
    void factor();

    // D^-1/2 L^-T x, which keeps zeros outside of the chains of x; and back, u = L^-1 D^-1/2 z.
    void to_factor_space(std::span<double> x) const;
    void to_velocities(std::span<double> z) const;
    // x <- H^-1 x
    void solve(std::span<double> x) const { to_factor_space(x), to_velocities(x); }

  private:
    struct Composite {
        Real mass;
        Vec3 moment;   // m c
        Sym3 inertia;  // about O
    };
    double& entry(int k, int i)
    {
        return values_[std::size_t(start_[std::size_t(k)] + depth_[std::size_t(i)])];
    }
    static Composite about_O(Real mass, const Sym3& inertia, Vec3 c);
    void project(const JointTree& tree);

    std::span<double> values_, root_;  // root_: D^-1/2
    std::span<int> start_, depth_, up_;
    std::span<Composite> composites_;
};

struct LinkInertia {
    Real mass;
    Sym3 inertia;
};

template <typename InertiaOf>
void TreeFactor::assemble(const JointTree& tree, InertiaOf&& inertia)
{
    const std::span<const TreeLink> links = tree.links();
    for (std::size_t i = 0; i < links.size(); ++i) {
        const LinkInertia its = inertia(links[i]);
        composites_[i] = about_O(its.mass, its.inertia, links[i].from_root);
    }
    project(tree);
}

}  // namespace epode
