// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The C functions of batches: see robots/api.h for how arguments are checked.
#include "epode/batch.h"

#include <algorithm>
#include <cmath>
#include <thread>

#include "batch/api/handle.h"

using namespace epode::robots;
using epode::batch::alive;
using epode::batch::AnyBatch;
using epode::batch::are_copies;
using epode::batch::is_parameter;
using epode::batch::Parameter;
using epode::batch::Quantity;

namespace {

bool is_quantity(int quantity) { return quantity >= 0 && quantity < int(Quantity::kCount); }
bool can_be_written(int quantity)
{
    return (quantity >= dBatchPositions && quantity <= dBatchAppliedForces) || quantity == dBatchActivations;
}
bool is_between(dReal x, dReal low, dReal high) { return x >= low && x <= high; }

bool are_good(const dBatchOptions& o)
{
    return o.struct_size == sizeof(dBatchOptions) && (o.doubles == 0 || o.doubles == 1) &&
           (o.pinned == 0 || o.pinned == 1) && o.threads >= 0 && o.threads <= 1024 && o.max_sweeps >= 1 &&
           is_between(o.stepsize, dReal(1e-9), dReal(10)) && is_between(o.erp, 0, 1) &&
           is_between(o.max_correction, 0, dReal(1e9)) && is_between(o.reach, 0, dReal(1e9)) &&
           is_between(o.tolerance, 0, dReal(1e9));
}

void set_options(AnyBatch& batch, const dBatchOptions& from)
{
    epode::batch::StepOptions& to = batch.options();
    to.h = double(from.stepsize), to.erp = double(from.erp), to.most_correction = double(from.max_correction);
    to.reach = double(from.reach), to.most_sweeps = from.max_sweeps;
    if (from.tolerance > 0) to.tolerance = double(from.tolerance);
}

int threads_of(const dBatchOptions& options)
{
    return options.threads > 0 ? options.threads : std::max(1, int(std::thread::hardware_concurrency()));
}

dBatchID create(dxRobotModel& model, int copies, const dBatchOptions& options)
{
    if (!model.prepared) model.prepared = std::make_shared<const Prepared>(model.model);
    epode::batch::BatchModel compiled;
    std::string refusal;
    if (!epode::batch::compile(model.prepared, compiled, refusal)) {
        dMessage(d_ERR_UNKNOWN, "dBatchCreate: refused: %s", refusal.c_str());
        return nullptr;
    }
    auto batch = epode::batch::make_batch(std::move(compiled), copies, options.doubles == 1,
                                          threads_of(options), options.pinned == 1);
    set_options(*batch, options);
    return Handles<dxBatch>::all().add(std::make_unique<dxBatch>(dxBatch{std::move(batch)}));
}

constexpr const char* kParameters = "a batch, a parameter, copies that there are, and an array";
constexpr const char* kBatch = "a batch that is alive";
constexpr const char* kPart = "a batch, a quantity, copies that there are, and an array";

bool is_part(const AnyBatch* batch, int quantity, int first, int count, const void* numbers)
{
    return are_copies(batch, first, count) && is_quantity(quantity) && (numbers || count == 0);
}

}  // namespace

int dBatchOptionsInit(dBatchOptions* options, unsigned struct_size)
{
    CHECK(options && struct_size == sizeof(dBatchOptions), "a structure and its size, sizeof(dBatchOptions)");
    const epode::batch::StepOptions its;
    *options = dBatchOptions{};
    options->struct_size = struct_size, options->max_sweeps = its.most_sweeps;
    options->stepsize = dReal(its.h), options->erp = dReal(its.erp),
    options->max_correction = dReal(its.most_correction);
    options->reach = dReal(its.reach);
    return 1;
}

dBatchID dBatchCreate(dRobotModelID model, int copies, const dBatchOptions* options)
{
    dxRobotModel* its = epode::robots::alive(model);
    CHECK(its && copies >= 1 && (!options || are_good(*options)),
          "a model, 1 copy or more, and NULL or options in their ranges");
    dBatchOptions chosen;
    dBatchOptionsInit(&chosen, sizeof chosen);
    if (options) chosen = *options;
    return guarded(__func__, [&] { return create(*its, copies, chosen); });
}

void dBatchDestroy(dBatchID batch) { check(Handles<dxBatch>::all().remove(batch), __func__, kBatch); }

int dBatchGetNumCopies(dBatchID batch)
{
    const AnyBatch* its = alive(batch);
    CHECK(its, kBatch);
    return its->copies();
}

int dBatchGetNumberSize(dBatchID batch)
{
    const AnyBatch* its = alive(batch);
    CHECK(its, kBatch);
    return its->number_size();
}

int dBatchGetNumThreads(dBatchID batch)
{
    const AnyBatch* its = alive(batch);
    CHECK(its, kBatch);
    return its->threads();
}

int dBatchGetSize(dBatchID batch, int quantity)
{
    const AnyBatch* its = alive(batch);
    CHECK(its && is_quantity(quantity), "a batch and a quantity");
    return its->size_of(Quantity(quantity));
}

int dBatchGetSensor(dBatchID batch, int sensor, int* first)
{
    const AnyBatch* its = alive(batch);
    CHECK(its && sensor >= 0 && sensor < int(its->model().sensors.size()),
          "a batch and the number of a sensor of its model");
    const epode::batch::BatchSensor& found = its->model().sensors[size_t(sensor)];
    if (first) *first = found.address;
    return found.values;
}

int dBatchRead(dBatchID batch, int quantity, int first, int count, void* numbers)
{
    const AnyBatch* its = alive(batch);
    CHECK(is_part(its, quantity, first, count, numbers), kPart);
    its->read(Quantity(quantity), first, count, numbers);
    return 1;
}

int dBatchWrite(dBatchID batch, int quantity, int first, int count, const void* numbers)
{
    AnyBatch* its = alive(batch);
    CHECK(is_part(its, quantity, first, count, numbers), kPart);
    CHECK(can_be_written(quantity), "positions, velocities, controls, applied forces or activations");
    return guarded(__func__, [&] {
        const bool good = its->write(Quantity(quantity), first, count, numbers);
        return int(check(good, "dBatchWrite", "numbers that are finite, and quaternions with a length"));
    });
}

int dBatchGetParameterSize(dBatchID batch, int parameter)
{
    const AnyBatch* its = alive(batch);
    CHECK(its && is_parameter(parameter), "a batch and a parameter");
    return epode::batch::size_of(its->model(), Parameter(parameter));
}

int dBatchReadParameter(dBatchID batch, int parameter, int first, int count, void* numbers)
{
    const AnyBatch* its = alive(batch);
    CHECK(is_parameter(parameter) && is_part(its, 0, first, count, numbers), kParameters);
    its->read(Parameter(parameter), first, count, numbers);
    return 1;
}

int dBatchWriteParameter(dBatchID batch, int parameter, int first, int count, const void* numbers)
{
    AnyBatch* its = alive(batch);
    CHECK(is_parameter(parameter) && is_part(its, 0, first, count, numbers), kParameters);
    return guarded(__func__, [&] {
        const bool good = its->write(Parameter(parameter), first, count, numbers);
        return int(check(good, "dBatchWriteParameter", "numbers that such a parameter can have"));
    });
}

int dBatchBind(dBatchID batch, int quantity, void* numbers)
{
    AnyBatch* its = alive(batch);
    CHECK(its && is_quantity(quantity), "a batch and a quantity");
    if (numbers) its->read(Quantity(quantity), 0, its->copies(), numbers);
    its->bind(Quantity(quantity), numbers);
    return 1;
}

int dBatchStep(dBatchID batch, int steps)
{
    AnyBatch* its = alive(batch);
    CHECK(its && steps >= 0, "a batch, and 0 steps or more");
    return guarded(__func__, [&] {
        const bool good = its->step(steps);
        return int(check(good, "dBatchStep",
                         "bound arrays with numbers that are finite, and quaternions with a length"));
    });
}

int dBatchReset(dBatchID batch, const unsigned char* mask)
{
    AnyBatch* its = alive(batch);
    CHECK(its, kBatch);
    its->reset(mask);
    return 1;
}

int dBatchCastRays(dBatchID batch, int link, int axes, int rays, const dReal* origins,
                   const dReal* directions, dReal max_distance, int first, int count, void* ranges,
                   int* shapes)
{
    AnyBatch* its = alive(batch);
    const bool is_part = its && first >= 0 && count >= 0 && first <= its->copies() - count &&
                         (ranges || count == 0 || rays == 0);
    CHECK(is_part && link >= 0 && link < int(its->model().links.size()),
          "a batch, one of its model's links, copies that there are, and an array of ranges");
    CHECK(axes >= dBatchRaysOfLink && axes <= dBatchRaysUpright && rays >= 0 && is_distance(max_distance),
          "axes that there are, and a count and a distance of 0 or more");
    CHECK(rays == 0 ||
              (directions && are_directions(directions, rays) && (!origins || are_usable(origins, 3 * rays))),
          "finite origins, and finite directions that are not 0");
    return guarded(__func__, [&] {
        std::vector<double> from(3 * size_t(rays)), along(directions, directions + 3 * size_t(rays));
        if (origins) std::copy_n(origins, from.size(), from.begin());
        its->cast({link, rays, epode::batch::RayAxes(axes), from.data(), along.data(), double(max_distance)},
                  first, count, ranges, shapes);
        return 1;
    });
}

int dBatchCountBad(dBatchID batch)
{
    const AnyBatch* its = alive(batch);
    CHECK(its, kBatch);
    return its->bad();
}
