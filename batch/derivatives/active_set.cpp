// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See active_set.h.
#include "batch/derivatives/active_set.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace epode::batch {

namespace {

// Of the largest impulse, what counts as a bound reached; of a row scaled to 1, the least pivot.
template <typename T>
constexpr double kReached = sizeof(T) == 4 ? 1e-5 : 1e-9;
template <typename T>
constexpr double kLeastPivot = sizeof(T) == 4 ? 1e-4 : 1e-10;

}  // namespace

template <typename T>
ActiveRows<T>::ActiveRows(int dofs, int impulses, int slots)
    : dofs_(dofs),
      row_(std::size_t(impulses)),
      slope_(row_.size()),
      follows_(new bool[row_.size() + 1]()),
      slide_(std::size_t(slots))
{}

template <typename T>
void ActiveRows<T>::find(int count, const FoundRow<T>* rows, const T* y, const T* response)
{
    choose(count, rows);
    fill(rows, y);
    solve(response);
    set_ = {int(found_.size()), row_.data(), slope_.data(), follows_.get(), slide_.data(), gain_.data()};
}

template <typename T>
void ActiveRows<T>::add(int impulse, int found)
{
    row_[std::size_t(impulse)] = int(found_.size());
    found_.push_back(found);
}

template <typename T>
void ActiveRows<T>::choose(int count, const FoundRow<T>* rows)
{
    std::fill(row_.begin(), row_.end(), -1);
    found_.clear();
    double largest = 0;
    for (int i = 0; i < count; ++i) largest = std::max(largest, std::fabs(double(rows[i].value)));
    const double scale = kReached<T> * largest;
    for (int i = 0; i < count; ++i) {
        const FoundRow<T>& row = rows[i];
        slope_[std::size_t(row.impulse)] = row.slope, follows_[std::size_t(row.impulse)] = row.has_gap;
        if (row.is_contact) {
            add_contact(rows + i, i, scale);
            i += 2;
        } else if (row.mass > 0 && row.value - row.low > scale && row.high - row.value > scale) {
            add(row.impulse, i);
        }
    }
}

template <typename T>
void ActiveRows<T>::add_contact(const FoundRow<T>* rows, int found, double scale)
{
    const double n = double(rows[0].value);
    if (!(rows[0].mass > 0) || !(n > scale)) return;
    const int impulse = rows[0].impulse;
    add(impulse, found);
    const double s = double(rows[1].value), t = double(rows[2].value), u = double(rows[1].velocity),
                 w = double(rows[2].velocity), speed = std::sqrt(u * u + w * w),
                 radius = double(rows[0].friction) * n;
    Slide<T>& slide = slide_[std::size_t(impulse / 3)];
    slide.slides = speed > 0 && std::sqrt(s * s + t * t) >= radius - std::max(scale, kReached<T> * radius);
    if (radius == 0 && !slide.slides) return;  // no friction, and nothing that it would resist
    add(impulse + 1, found + 1), add(impulse + 2, found + 2);
    if (!slide.slides) return;
    const double x = u / speed, y = w / speed;
    slide.n = rows[0].value, slide.u0[0] = T(u), slide.u0[1] = T(w), slide.turn[0] = T(x),
    slide.turn[1] = T(y);
    slide.bend[0] = T((1 - x * x) / speed), slide.bend[1] = T(-x * y / speed),
    slide.bend[2] = T((1 - y * y) / speed);
}

template <typename T>
double ActiveRows<T>::product(const T* y, int a, int b) const
{
    const T *one = y + std::ptrdiff_t(a) * dofs_, *other = y + std::ptrdiff_t(b) * dofs_;
    double sum = 0;
    for (int i = 0; i < dofs_; ++i) sum += double(one[i]) * double(other[i]);
    return sum;
}

template <typename T>
void ActiveRows<T>::fill(const FoundRow<T>* rows, const T* y)
{
    const int n = int(found_.size());
    matrix_.assign(std::size_t(n) * std::size_t(n), 0);
    for (int r = 0; r < n; ++r)
        for (int c = 0; c <= r; ++c)
            matrix_[std::size_t(r * n + c)] = matrix_[std::size_t(c * n + r)] =
                product(y, found_[std::size_t(r)], found_[std::size_t(c)]);
    for (int r = 0; r < n; ++r) {
        const FoundRow<T>& row = rows[found_[std::size_t(r)]];
        const int direction = row.is_contact ? row.impulse % 3 : 0;
        if (direction == 0) matrix_[std::size_t(r * n + r)] += double(row.soft);
        if (direction == 1 && slide_[std::size_t(row.impulse / 3)].slides)
            bend(r, double(row.friction), slide_[std::size_t(row.impulse / 3)]);
    }
}

// Both tangents of a contact that slides; its normal is the row before them.
template <typename T>
void ActiveRows<T>::bend(int r, double friction, const Slide<T>& slide)
{
    const int n = int(found_.size());
    double *first = &matrix_[std::size_t(r * n)], *second = first + n;
    const double radius = friction * double(slide.n);
    for (int c = 0; c < n; ++c) {
        const double a = first[c], b = second[c];
        first[c] = radius * (double(slide.bend[0]) * a + double(slide.bend[1]) * b);
        second[c] = radius * (double(slide.bend[1]) * a + double(slide.bend[2]) * b);
    }
    first[r] += 1, second[r + 1] += 1;
    first[r - 1] += friction * double(slide.turn[0]), second[r - 1] += friction * double(slide.turn[1]);
}

// K E = W, W the responses as columns: E' K' = W', with W' at the side of E'. A row of E is a column of E'.
template <typename T>
void ActiveRows<T>::solve(const T* response)
{
    const int n = int(found_.size());
    table_.assign(std::size_t(n) * std::size_t(n + dofs_), 0);
    scale_.resize(std::size_t(n)), order_.resize(std::size_t(n));
    for (int c = 0; c < n; ++c) {
        const double* its = &matrix_[std::size_t(c * n)];
        double largest = 0;
        for (int r = 0; r < n; ++r) largest = std::max(largest, std::fabs(its[r]));
        scale_[std::size_t(c)] = largest > 0 ? 1 / largest : 0, order_[std::size_t(c)] = c;
        for (int r = 0; r < n; ++r) at(r, c) = its[r] * scale_[std::size_t(c)];
    }
    for (int r = 0; r < n; ++r)
        for (int i = 0; i < dofs_; ++i)
            at(r, n + i) = double(response[std::ptrdiff_t(found_[std::size_t(r)]) * dofs_ + i]);
    int rank = 0;
    while (rank < n && choose_pivot(rank)) eliminate(rank++);
    substitute(rank);
}

template <typename T>
double& ActiveRows<T>::at(int r, int c)
{
    return table_[std::size_t(r) * (found_.size() + std::size_t(dofs_)) + std::size_t(c)];
}

// The largest of what is left comes to the diagonal. False: it is too small.
template <typename T>
bool ActiveRows<T>::choose_pivot(int rank)
{
    const int n = int(found_.size());
    int row = rank, column = rank;
    for (int r = rank; r < n; ++r)
        for (int c = rank; c < n; ++c)
            if (std::fabs(at(r, c)) > std::fabs(at(row, column))) row = r, column = c;
    if (!(std::fabs(at(row, column)) > kLeastPivot<T>)) return false;
    if (row != rank) std::swap_ranges(&at(row, 0), &at(row, 0) + n + dofs_, &at(rank, 0));
    if (column == rank) return true;
    for (int r = 0; r < n; ++r) std::swap(at(r, column), at(r, rank));
    std::swap(order_[std::size_t(column)], order_[std::size_t(rank)]);
    return true;
}

template <typename T>
void ActiveRows<T>::eliminate(int rank)
{
    const int n = int(found_.size());
    const double inverse = 1 / at(rank, rank);
    for (int r = rank + 1; r < n; ++r) {
        const double factor = at(r, rank) * inverse;
        if (factor == 0) continue;
        for (int c = rank; c < n + dofs_; ++c) at(r, c) -= factor * at(rank, c);
    }
}

// K, whose rows beyond the rank count nothing.
template <typename T>
void ActiveRows<T>::substitute(int rank)
{
    const int n = int(found_.size());
    gain_.assign(std::size_t(dofs_) * std::size_t(n), T(0));
    for (int i = 0; i < dofs_; ++i)
        for (int r = rank; r-- > 0;) {
            double sum = at(r, n + i);
            for (int c = r + 1; c < rank; ++c) sum -= at(r, c) * at(c, n + i);
            at(r, n + i) = sum / at(r, r);
            const int its = order_[std::size_t(r)];
            gain_[std::size_t(i * n + its)] = T(at(r, n + i) * scale_[std::size_t(its)]);
        }
}

template class ActiveRows<float>;
template class ActiveRows<double>;

}  // namespace epode::batch
