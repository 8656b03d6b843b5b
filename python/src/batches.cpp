// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Batches of robots, under epode.Batch, which keeps the arrays that are bound. One thread at a time uses a batch; a step lets others of
// Python go on, and ends early where Ctrl-C was pressed.
#include "batches.h"

#ifdef EPODE_HAVE_ROBOTS

#include "portions.h"

using namespace bound;
using epode::batch::Parameter;
using epode::batch::Quantity;

namespace {

double option(const nb::dict& options, const char* name, double low, double high)
{
    const double value = nb::cast<double>(options[name]);
    if (value >= low && value <= high) return value;
    throw nb::value_error((std::string(name) + " is out of its range").c_str());
}

BoundBatch* make(Model& m, int copies, bool doubles, int threads, const nb::dict& options)
{
    if (m.model.has_errors()) throw nb::value_error("the model has errors: see its report");
    if (copies < 1) throw nb::value_error("1 copy or more is expected");
    if (threads < 0 || threads > 1024) throw nb::value_error("0 to 1024 threads are expected");
    if (!m.prepared) m.prepared = std::make_shared<const Prepared>(m.model);
    epode::batch::BatchModel compiled;
    std::string refusal;
    if (!epode::batch::compile(m.prepared, compiled, refusal)) throw nb::value_error(refusal.c_str());
    auto out = std::make_unique<BoundBatch>();
    const int all = std::max(1, int(std::thread::hardware_concurrency()));
    out->batch = epode::batch::make_batch(std::move(compiled), copies, doubles, threads > 0 ? threads : all,
                                          nb::cast<bool>(options["pinned"]));
    epode::batch::StepOptions& to = out->its().options();
    to.h = option(options, "stepsize", 1e-9, 10), to.erp = option(options, "erp", 0, 1);
    to.most_correction = option(options, "max_correction", 0, 1e9),
    to.reach = option(options, "reach", 0, 1e9);
    to.most_sweeps = int(option(options, "max_sweeps", 1, 1e9));
    if (const double tolerance = option(options, "tolerance", 0, 1e9); tolerance > 0)
        to.tolerance = tolerance;
    return out.release();
}

Quantity quantity_of(int number)
{
    if (number < 0 || number >= int(Quantity::kCount)) throw nb::index_error("no such quantity");
    return Quantity(number);
}

Parameter parameter_of(int number)
{
    if (number < 0 || number >= int(Parameter::kCount)) throw nb::index_error("no such parameter");
    return Parameter(number);
}

// The memory of an array of the batch's own numbers, as many as that.
void* memory_of(const AnyBatch& batch, nb::handle array, size_t numbers)
{
    nb::ndarray<nb::c_contig, nb::device::cpu> view;
    if (!nb::try_cast(array, view, false))
        throw nb::type_error("a contiguous array that may be written to is expected");
    const bool fits = view.dtype() == (batch.number_size() == 8 ? nb::dtype<double>() : nb::dtype<float>());
    if (!fits)
        throw nb::type_error(batch.number_size() == 8 ? "an array of float64 is expected"
                                                      : "an array of float32 is expected");
    if (view.size() != numbers) throw nb::value_error("an array of another size is expected");
    return view.data();
}

// With as many as `count` copies have.
void* memory_of(const AnyBatch& batch, nb::handle array, int size, int first, int count)
{
    if (first < 0 || count < 0 || first > batch.copies() - count) throw nb::index_error("no such copies");
    return memory_of(batch, array, size_t(count) * size_t(size));
}

constexpr const char* kFinite =
    "numbers must be finite, quaternions must have a length, parameters must be in their ranges";

void read_quantity(BoundBatch& b, int quantity, int first, int count, nb::handle array)
{
    const Use use(b);
    const Quantity its = quantity_of(quantity);
    b.its().read(its, first, count, memory_of(b.its(), array, b.its().size_of(its), first, count));
}

void write_quantity(BoundBatch& b, int quantity, int first, int count, nb::handle array)
{
    const Use use(b);
    const Quantity its = quantity_of(quantity);
    if (quantity > int(Quantity::kApplied) && its != Quantity::kActivations)
        throw nb::value_error("only qpos, qvel, ctrl, applied and act can be written");
    const void* from = memory_of(b.its(), array, b.its().size_of(its), first, count);
    if (!b.its().write(its, first, count, from)) throw nb::value_error(kFinite);
}

void read_parameter(BoundBatch& b, int parameter, int first, int count, nb::handle array)
{
    const Use use(b);
    const Parameter its = parameter_of(parameter);
    b.its().read(its, first, count,
                 memory_of(b.its(), array, epode::batch::size_of(b.its().model(), its), first, count));
}

void write_parameter(BoundBatch& b, int parameter, int first, int count, nb::handle array)
{
    const Use use(b);
    const Parameter its = parameter_of(parameter);
    const void* from = memory_of(b.its(), array, epode::batch::size_of(b.its().model(), its), first, count);
    if (!b.its().write(its, first, count, from)) throw nb::value_error(kFinite);
}

// The array is kept by the caller for as long as the batch lives.
void bind(BoundBatch& b, int quantity, nb::object array)
{
    const Use use(b);
    const Quantity its = quantity_of(quantity);
    if (array.is_none()) return b.its().bind(its, nullptr);
    void* memory = memory_of(b.its(), array, b.its().size_of(its), 0, b.its().copies());
    b.its().read(its, 0, b.its().copies(), memory);
    b.its().bind(its, memory);
}

using RayRows = nb::ndarray<const double, nb::shape<-1, 3>, nb::c_contig, nb::device::cpu>;

void cast_rays(BoundBatch& b, int link, int axes, const RayRows& origins, const RayRows& directions,
               double reach, nb::handle ranges, nb::object shapes)
{
    const Use use(b);
    const int rays = int(directions.shape(0));
    if (link < 0 || link >= int(b.its().model().links.size())) throw nb::index_error("no such link");
    void* to = memory_of(b.its(), ranges, rays, 0, b.its().copies());
    nb::ndarray<int, nb::c_contig, nb::device::cpu> numbers;
    if (!shapes.is_none() &&
        (!nb::try_cast(shapes, numbers, false) || numbers.size() != size_t(rays) * size_t(b.its().copies())))
        throw nb::value_error("an array of ints, one a ray, is expected");
    const epode::batch::Rays its{link, rays, epode::batch::RayAxes(axes), origins.data(), directions.data(),
                                 reach};
    const WithoutGil released;
    b.its().cast(its, 0, b.its().copies(), to, shapes.is_none() ? nullptr : numbers.data());
}

void step(BoundBatch& b, int steps)
{
    if (steps < 0) throw nb::value_error("0 steps or more are expected");
    const Use use(b);
    Portions portions(steps);
    do {  // once for no steps too: what was bound is read
        bool good;
        {
            const WithoutGil released;
            good = b.its().step(portions.next());
        }
        if (!good) throw nb::value_error(kFinite);
        if (PyErr_CheckSignals() != 0) throw nb::python_error();
    } while (portions.left() > 0);
}

void reset(BoundBatch& b, nb::object mask)
{
    const Use use(b);
    if (mask.is_none()) return b.its().reset(nullptr);
    nb::ndarray<bool, nb::c_contig, nb::device::cpu> view;
    if (!nb::try_cast(mask, view, false) || view.size() != size_t(b.its().copies()))
        throw nb::value_error("a mask of one bool a copy is expected");
    b.its().reset(reinterpret_cast<const unsigned char*>(view.data()));
}

// Of the copies that the list names, in its order.
std::vector<int> copies_in(const AnyBatch& batch, const nb::list& copies)
{
    std::vector<int> out;
    for (nb::handle its : copies) {
        out.push_back(nb::cast<int>(its));
        if (out.back() < 0 || out.back() >= batch.copies()) throw nb::index_error("no such copy");
    }
    return out;
}

void get_jacobian(BoundBatch& b, int link, nb::list point, nb::list copies, nb::handle to)
{
    const Use use(b);
    if (link < 0 || link >= int(b.its().model().links.size())) throw nb::index_error("no such link");
    const double at[3] = {nb::cast<double>(point[0]), nb::cast<double>(point[1]), nb::cast<double>(point[2])};
    for (const double x : at)
        if (!(x >= -1e9 && x <= 1e9)) throw nb::value_error("a point must be finite and within 1e9");
    const std::vector<int> chosen = copies_in(b.its(), copies);
    void* memory = memory_of(b.its(), to, chosen.size() * 6 * size_t(b.its().model().velocities));
    const WithoutGil released;
    b.its().jacobian(link, at, chosen, memory);
}

void differentiate(BoundBatch& b, bool exact, double distance, nb::list copies,
                   std::vector<epode::batch::ColumnBlock> blocks, std::initializer_list<nb::handle> arrays)
{
    const Use use(b);
    if (!(distance >= 0 && distance <= 0.5)) throw nb::value_error("distance must be from 0 to 0.5");
    if (exact && !b.its().has_exact_derivatives())
        throw nb::value_error(
            "method='differences' is expected of a model with loops or friction against turning");
    const std::vector<int> chosen = copies_in(b.its(), copies);
    auto array = arrays.begin();
    for (epode::batch::ColumnBlock& block : blocks)
        block.to =
            memory_of(b.its(), *array++, chosen.size() * size_t(b.its().tangents()) * size_t(block.columns));
    const WithoutGil released;
    b.its().differentiate(chosen, {exact, distance}, blocks);
}

void linearise(BoundBatch& b, bool exact, double distance, nb::list copies, nb::handle over_state,
               nb::handle over_controls)
{
    using epode::batch::ColumnBlock;
    differentiate(b, exact, distance, copies,
                  {{ColumnBlock::kState, b.its().tangents(), nullptr},
                   {ColumnBlock::kControls, b.its().model().controls, nullptr}},
                  {over_state, over_controls});
}

void linearise_parameter(BoundBatch& b, bool exact, double distance, int parameter, nb::list copies,
                         nb::handle to)
{
    using epode::batch::ColumnBlock;
    const Parameter its = parameter_of(parameter);
    differentiate(b, exact, distance, copies,
                  {{ColumnBlock::kParameter, epode::batch::size_of(b.its().model(), its), nullptr, its}},
                  {to});
}

}  // namespace

#endif

void bind_batches(nb::module_& m)
{
#ifdef EPODE_HAVE_ROBOTS
    nb::class_<BoundBatch>(m, "_Batch")
        .def("__init__",
             [](BoundBatch* self, Model& model, int copies, bool doubles, int threads, nb::dict options) {
                 std::unique_ptr<BoundBatch> made(make(model, copies, doubles, threads, options));
                 new (self) BoundBatch{std::move(made->batch), false};
             })
        .def_prop_ro("copies", [](const BoundBatch& b) { return b.its().copies(); })
        .def_prop_ro("threads", [](const BoundBatch& b) { return b.its().threads(); })
        .def("size", [](const BoundBatch& b, int quantity) { return b.its().size_of(quantity_of(quantity)); })
        .def("sensor",
             [](const BoundBatch& b, int number) {
                 const auto& all = b.its().model().sensors;
                 if (number < 0 || number >= int(all.size())) throw nb::index_error("no such sensor");
                 const auto& its = all[size_t(number)];
                 return nb::make_tuple(its.address, its.values);
             })
        .def("parameter_size",
             [](const BoundBatch& b, int parameter) {
                 return epode::batch::size_of(b.its().model(), parameter_of(parameter));
             })
        .def("read", read_quantity)
        .def("write", write_quantity)
        .def("read_parameter", read_parameter)
        .def("write_parameter", write_parameter)
        .def("bind", bind, nb::arg().none(), nb::arg().none())
        .def("step", step)
        .def("reset", reset, nb::arg().none())
        .def("rays", cast_rays, nb::arg(), nb::arg(), nb::arg(), nb::arg(), nb::arg(), nb::arg(),
             nb::arg().none())
        .def_prop_ro("tangents", [](const BoundBatch& b) { return b.its().tangents(); })
        .def("jacobian", get_jacobian)
        .def("linearise", linearise)
        .def("linearise_parameter", linearise_parameter)
        .def_prop_ro("bad", [](const BoundBatch& b) { return b.its().bad(); });
#else
    static_cast<void>(m);
#endif
}
