// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The C functions of derivatives of batches.
#include <numeric>

#include "batch/api/handle.h"

using namespace epode::batch;

namespace {

constexpr const char* kDerivative =
    "a batch, a method, a distance from 0 to 0.5, copies that there are, and arrays";

bool is_asked(const AnyBatch* batch, int method, dReal distance, int first, int count)
{
    return are_copies(batch, first, count) && (method == dBatchDifferences || method == dBatchExact) &&
           distance >= 0 && distance <= dReal(0.5);
}

std::vector<int> copies_from(int first, int count)
{
    std::vector<int> out(static_cast<std::size_t>(count));
    std::iota(out.begin(), out.end(), first);
    return out;
}

bool is_point(const dReal* point)
{
    return !point ||
           std::all_of(point, point + 3, [](dReal x) { return x >= dReal(-1e9) && x <= dReal(1e9); });
}

int differentiate(AnyBatch& batch, const char* function, const DerivativeOptions& how, int first, int count,
                  const std::vector<ColumnBlock>& blocks)
{
    if (!check(!how.exact || batch.has_exact_derivatives(), function,
               "dBatchDifferences, for a model with loops or friction against turning"))
        return 0;
    return guarded(function, [&] {
        batch.differentiate(copies_from(first, count), how, blocks);
        return 1;
    });
}

}  // namespace

int dBatchJacobian(dBatchID batch, int link, const dReal* point, int first, int count, void* values)
{
    AnyBatch* its = alive(batch);
    CHECK(are_copies(its, first, count) && (values || count == 0) && is_point(point) && link >= 0 &&
              link < int(its->model().links.size()),
          "a batch, a link that it has, NULL or a point, copies that there are, and an array");
    const double at[3] = {point ? double(point[0]) : 0, point ? double(point[1]) : 0,
                          point ? double(point[2]) : 0};
    return guarded(__func__, [&] {
        its->jacobian(link, at, copies_from(first, count), values);
        return 1;
    });
}

int dBatchGetTangentSize(dBatchID batch)
{
    const AnyBatch* its = alive(batch);
    CHECK(its, "a batch that is alive");
    return its->tangents();
}

int dBatchLinearise(dBatchID batch, int method, dReal distance, int first, int count, void* a, void* b)
{
    AnyBatch* its = alive(batch);
    CHECK(is_asked(its, method, distance, first, count) && (a || count == 0) &&
              (b || count == 0 || its->model().controls == 0),
          kDerivative);
    return differentiate(
        *its, __func__, {method == dBatchExact, double(distance)}, first, count,
        {{ColumnBlock::kState, its->tangents(), a}, {ColumnBlock::kControls, its->model().controls, b}});
}

int dBatchLineariseParameter(dBatchID batch, int method, dReal distance, int parameter, int first, int count,
                             void* values)
{
    AnyBatch* its = alive(batch);
    CHECK(is_asked(its, method, distance, first, count) && is_parameter(parameter) &&
              (values || count == 0 || size_of(its->model(), Parameter(parameter)) == 0),
          "a batch, a method, a distance from 0 to 0.5, a parameter, copies that there are, and an array");
    const auto which = Parameter(parameter);
    return differentiate(*its, __func__, {method == dBatchExact, double(distance)}, first, count,
                         {{ColumnBlock::kParameter, size_of(its->model(), which), values, which}});
}
