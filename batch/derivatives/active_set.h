// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Which rows of a solved step act, and K = M^-1 J' E^-1, what v+ loses for a unit error of each (lanes/sensitivity.h). With
// A = Y' Y of all rows, the rows of E over the impulses are
//     normals, singles    A + soft
//     tangents that stick A
//     tangents that slide 1 + mu (t dp_n + p_n bend A).
// A row is scaled by its largest entry, then eliminated with the largest pivot; what is left below the rank's threshold follows from the
// others (four feet of a stiff body), and v+ does not depend on how they share.
#pragma once

#include <memory>
#include <vector>

#include "batch/lanes/active.h"

namespace epode::batch {

template <typename T>
class ActiveRows {
  public:
    // Of a model: how many dofs and impulses there are, and of how many contact slots the first are.
    ActiveRows(int dofs, int impulses, int slots);

    // Rows as the kernel has found them, one behind the other in y and response.
    void find(int count, const FoundRow<T>* rows, const T* y, const T* response);
    const ActiveSet<T>& set() const { return set_; }

  private:
    void choose(int count, const FoundRow<T>* rows);
    void add(int impulse, int found);
    void add_contact(const FoundRow<T>* rows, int found, double scale);
    void fill(const FoundRow<T>* rows, const T* y);
    void bend(int row, double friction, const Slide<T>& slide);
    void solve(const T* response);
    double& at(int row, int column);  // of the table
    bool choose_pivot(int rank);
    void eliminate(int rank);
    void substitute(int rank);
    double product(const T* y, int a, int b) const;

    int dofs_;
    std::vector<int> row_, found_;  // of each impulse; of each row the one that was found
    std::vector<T> slope_, gain_;
    std::unique_ptr<bool[]> follows_;
    std::vector<Slide<T>> slide_;
    std::vector<double> matrix_, scale_, table_;  // E; of its rows; E' and the responses
    std::vector<int> order_;
    ActiveSet<T> set_{};
};

}  // namespace epode::batch
