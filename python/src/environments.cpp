// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Vectors of environments on a batch, under epode.vector, which describes tasks as tuples (python/epode/vector/task.py) and keeps the
// arrays of results.
#include "batches.h"

#include <nanobind/stl/optional.h>
#include <nanobind/stl/vector.h>

#ifdef EPODE_HAVE_ROBOTS

#include "batch/tasks/environments.h"
#include "batch/tasks/ground.h"

using namespace bound;
using namespace epode::batch;

namespace {

// Robots have such names, too.
using Piece = epode::batch::Piece;
using Start = epode::batch::Start;

struct BoundEnvironments {
    BoundBatch* batch = nullptr;
    nb::object kept;  // the batch and the arrays
    size_t actions = 0;
    std::unique_ptr<Environments> its;
};

template <typename X>
X item(nb::handle tuple, int i)
{
    return nb::cast<X>(tuple[i]);
}

template <typename Enum>
Enum choice(int number, Enum last)
{
    if (number < 0 || number > int(last)) throw nb::value_error("a task has an unknown kind");
    return Enum(number);
}

Piece piece_of(nb::handle t)
{
    Piece out;
    if (t.is_none()) return out;
    out.source = choice(item<int>(t, 0), Piece::Source::kHeight);
    out.quantity = choice(item<int>(t, 1), Quantity(int(Quantity::kCount) - 1));
    out.first = item<int>(t, 2), out.count = item<int>(t, 3);
    out.function = choice(item<int>(t, 4), Piece::Function::kCosine);
    out.offset = item<double>(t, 5), out.scale = item<double>(t, 6);
    out.low = item<double>(t, 7), out.high = item<double>(t, 8);
    for (int k = 0; k < 3; ++k) out.point[k] = item<double>(t, 9 + k);
    out.link = item<int>(t, 12), out.minus = item<int>(t, 13);
    out.command = item<int>(t, 14), out.axes_of = item<int>(t, 15);
    for (nb::handle place : nb::cast<nb::tuple>(t[16]))
        out.places.push_back({item<double>(place, 0), item<double>(place, 1)});
    return out;
}

Term term_of(nb::handle t)
{
    Term out;
    out.kind = choice(item<int>(t, 0), Term::Kind::kGaussian);
    out.piece = piece_of(t[1]);
    out.weight = item<double>(t, 2), out.low = item<double>(t, 3), out.high = item<double>(t, 4);
    out.column = item<int>(t, 5), out.is_reward = item<bool>(t, 6), out.at_reset = item<bool>(t, 7);
    out.width = item<double>(t, 8);
    return out;
}

Range range_of(nb::handle t)
{
    return {piece_of(t[0]), item<double>(t, 1), item<double>(t, 2), item<bool>(t, 3)};
}

Start start_of(nb::handle t)
{
    return {item<bool>(t, 0),  item<bool>(t, 1),  item<bool>(t, 2),   item<int>(t, 3),
            item<Reals>(t, 4), item<Reals>(t, 5), item<double>(t, 6), item<double>(t, 7)};
}

Draw draw_of(nb::handle t)
{
    return {choice(item<int>(t, 0), Parameter(int(Parameter::kCount) - 1)),
            item<bool>(t, 1),
            item<bool>(t, 2),
            item<bool>(t, 3),
            item<double>(t, 4),
            item<double>(t, 5)};
}

Commands commands_of(nb::handle t)
{
    return {item<Reals>(t, 0), item<Reals>(t, 1), item<int>(t, 2), item<double>(t, 3)};
}

Curriculum curriculum_of(nb::handle t)
{
    return {item<int>(t, 0),    item<int>(t, 1),    item<int>(t, 2),
            item<double>(t, 3), item<double>(t, 4), item<double>(t, 5)};
}

template <typename X>
std::vector<X> all_of(const nb::dict& from, const char* name, X (*one)(nb::handle))
{
    std::vector<X> out;
    for (nb::handle its : nb::cast<nb::list>(from[name])) out.push_back(one(its));
    return out;
}

Task task_of(const nb::dict& from)
{
    Task out;
    out.observation = all_of(from, "observation", piece_of), out.terms = all_of(from, "terms", term_of);
    out.healthy = all_of(from, "healthy", range_of), out.starts = all_of(from, "starts", start_of);
    out.draws = all_of(from, "draws", draw_of), out.commands = commands_of(from["commands"]);
    out.curriculum = curriculum_of(from["curriculum"]);
    out.noise = nb::cast<Reals>(from["noise"]), out.choices = nb::cast<Reals>(from["choices"]);
    out.columns = nb::cast<int>(from["columns"]), out.frame_skip = nb::cast<int>(from["frame_skip"]);
    out.time_limit = nb::cast<int>(from["time_limit"]), out.terminates = nb::cast<bool>(from["terminates"]);
    return out;
}

void expect(bool good, const char* what)
{
    if (!good) throw nb::value_error(what);
}

// How many numbers the source of a piece has.
int size_of(const Piece& its, const AnyBatch& batch, size_t actions, size_t commands)
{
    switch (its.source) {
        case Piece::Source::kQuantity:
            return batch.size_of(its.quantity);
        case Piece::Source::kAction:
        case Piece::Source::kActionChange:
            return int(actions);
        case Piece::Source::kCommand:
            return int(commands);
        case Piece::Source::kRow:
            return 1;
        case Piece::Source::kPoint:
        case Piece::Source::kDirection:
            return 3;
        case Piece::Source::kHeight:
            return int(its.places.size());
    }
    return 0;
}

void check_heights(const Piece& its, const AnyBatch& batch)
{
    expect(its.minus < 0 && its.command < 0 && its.axes_of < 0 && its.function == Piece::Function::kNone,
           "of heights neither minus, command, axes_of nor a function can be");
    const Ground ground(batch.model());
    expect(ground.refusal().empty(), ground.refusal().c_str());
}

void check(const Piece& its, const AnyBatch& batch, size_t actions, size_t commands)
{
    const int size = size_of(its, batch, actions, commands), links = int(batch.model().links.size());
    expect(its.command < 0 || its.command <= int(commands) - its.count,
           "a task asks for commands that it has not");
    expect(its.axes_of < links &&
               (its.axes_of < 0 || (its.count <= 3 && its.first <= size - 3 && its.minus < 0)),
           "axes_of: a link, and up to three numbers of a vector are expected");
    expect(its.first >= 0 && its.count >= 0 && its.first <= size - its.count && its.minus <= size - its.count,
           "a task asks for numbers that a copy has not");
    expect(its.link >= 0 && its.link < links, "a task asks for a link that is not there");
    if (its.source == Piece::Source::kHeight) check_heights(its, batch);
}

void check(const Task& its, const AnyBatch& batch, size_t actions)
{
    const size_t commands = its.commands.low.size();
    expect(commands == its.commands.high.size() && its.commands.steps >= 0,
           "commands: as many lows as highs are expected");
    const Curriculum& fields = its.curriculum;
    expect(fields.rows >= 0 && (fields.rows == 0 || (fields.columns >= 1 && fields.first_rows >= 1 &&
                                                     fields.spacing > 0 && batch.model().positions >= 2)),
           "curriculum: rows, columns and first_rows of 1 or more and a spacing above 0 are expected");
    for (const Piece& piece : its.observation) check(piece, batch, actions, commands);
    for (const Range& range : its.healthy) check(range.piece, batch, actions, commands);
    for (const Term& term : its.terms) {
        check(term.piece, batch, actions, commands);
        expect(term.width > 0, "width: a number above 0 is expected");
        expect(term.column >= -1 && term.column < its.columns, "a task has a term of no column");
    }
    for (const Start& start : its.starts) {
        const int size = start.is_velocity ? batch.model().velocities : batch.model().positions;
        expect(start.low.size() == start.high.size() && start.first >= 0 &&
                   start.first <= size - int(start.low.size()),
               "a task draws numbers that a copy has not");
    }
    const auto controls = size_t(batch.model().controls);
    expect(its.choices.empty() || (controls > 0 && its.choices.size() % controls == 0),
           "choices: controls of each are expected");
    expect(its.noise.empty() || its.noise.size() == size_t(its.observation_size()),
           "observation_noise: a number, or one of each of the observation, is expected");
    expect(its.frame_skip >= 1 && its.frame_skip <= 1000000, "frame_skip: 1 or more is expected");
}

template <typename X>
X* array(const nb::dict& arrays, const char* name, size_t size)
{
    nb::ndarray<X, nb::c_contig, nb::device::cpu> view;
    expect(nb::try_cast(arrays[name], view, false) && view.size() == size, name);
    return view.data();
}

template <typename T>
Results results_of(const nb::dict& arrays, size_t n, size_t width, size_t columns)
{
    Results out;
    out.observations = array<T>(arrays, "observations", n * width);
    out.final_observations = array<T>(arrays, "final_observations", n * width);
    out.rewards = array<double>(arrays, "rewards", n);
    out.infos = array<double>(arrays, "infos", n * columns);
    out.final_infos = array<double>(arrays, "final_infos", n * columns);
    out.terminated = array<bool>(arrays, "terminated", n),
    out.truncated = array<bool>(arrays, "truncated", n);
    out.begun = array<bool>(arrays, "begun", n), out.bad = array<bool>(arrays, "bad", n);
    return out;
}

void make(BoundEnvironments* self, nb::object of, nb::dict described, int autoreset, uint32_t first,
          nb::dict arrays)
{
    auto& bound = nb::cast<BoundBatch&>(of);
    const Use use(bound);
    AnyBatch& batch = bound.its();
    Task task = task_of(described);
    const size_t actions = task.choices.empty() ? size_t(batch.model().controls) : 1;
    check(task, batch, actions);
    const auto n = size_t(batch.copies()), width = size_t(task.observation_size()),
               columns = size_t(task.columns);
    const Results results = batch.number_size() == 8 ? results_of<double>(arrays, n, width, columns)
                                                     : results_of<float>(arrays, n, width, columns);
    auto its =
        make_environments(batch, std::move(task), choice(autoreset, Autoreset::kDisabled), first, results);
    new (self) BoundEnvironments{&bound, nb::make_tuple(of, arrays), actions, std::move(its)};
}

using Actions = nb::ndarray<const double, nb::c_contig, nb::device::cpu>;
using Mask = nb::ndarray<const bool, nb::c_contig, nb::device::cpu>;

void step(BoundEnvironments& e, Actions actions)
{
    const Use use(*e.batch);
    expect(actions.size() == size_t(e.batch->its().copies()) * e.actions,
           "actions of another shape are expected");
    std::string problem;
    {
        nb::gil_scoped_release others;
        problem = e.its->step(actions.data());
    }
    if (!problem.empty()) throw nb::value_error(problem.c_str());
}

void reset(BoundEnvironments& e, std::optional<uint64_t> seed, std::optional<Mask> mask)
{
    const Use use(*e.batch);
    expect(!mask || mask->size() == size_t(e.batch->its().copies()), "a mask of one bool a copy is expected");
    nb::gil_scoped_release others;
    e.its->reset(mask ? mask->data() : nullptr, seed ? &*seed : nullptr);
}

}  // namespace

#endif

void bind_environments(nb::module_& m)
{
#ifdef EPODE_HAVE_ROBOTS
    nb::class_<BoundEnvironments>(m, "_Environments")
        .def("__init__", make)
        .def("step", step)
        .def("reset", reset, nb::arg().none(), nb::arg().none());
#else
    static_cast<void>(m);
#endif
}
