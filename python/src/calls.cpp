// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Collecting messages: each thread in a call has a list of its own. A message from a thread that is in no call (a
// helper of a step) goes to a common list, which the next call that ends empties. Nested calls (a callback that calls
// back) have lists of their own.
#include "calls.h"

#include <algorithm>
#include <atomic>
#include <cstdarg>
#include <cstdio>
#include <exception>
#include <map>
#include <mutex>
#include <thread>
#include <utility>

namespace {

thread_local Call* innermost = nullptr;
thread_local PyObject* waiting = nullptr;  // an exception of a callback

std::mutex mutex;
std::vector<Said> helpers_said;
std::atomic<bool> helpers_spoke{false};
struct Busy {
    dWorldID world;
    std::thread::id thread;
};
std::vector<Busy> busy;
std::atomic<int> busy_count{0};

PyObject *refused_error = nullptr, *dead_error = nullptr, *busy_error = nullptr, *warning = nullptr;

void collect(bool refused, int number, const char* format, va_list arguments)
{
    char text[2000];
    vsnprintf(text, sizeof text, format, arguments);
    Call::say({refused, number, text});
}

void on_refusal(int number, const char* format, va_list arguments)
{
    collect(true, number, format, arguments);
}
void on_message(int number, const char* format, va_list arguments)
{
    collect(false, number, format, arguments);
}

[[noreturn]] void raise(const Said& said)
{
    bool dead =
        said.text.find("destroyed") != std::string::npos || said.text.find("dead") != std::string::npos;
    nb::object error = nb::borrow(dead ? dead_error : refused_error)(said.text);
    error.attr("number") = said.number;
    PyErr_SetObject(reinterpret_cast<PyObject*>(Py_TYPE(error.ptr())), error.ptr());
    throw nb::python_error();
}

// The world that a geom's space belongs to, if that is the contact space of a busy one.
dGeomID outermost(dGeomID geom)
{
    while (dGeomID space = reinterpret_cast<dGeomID>(dGeomGetSpace(geom))) geom = space;
    return geom;
}

bool stepped_elsewhere(bool (*concerned)(dWorldID, const void*), const void* what)
{
    std::lock_guard lock(mutex);
    return std::any_of(busy.begin(), busy.end(), [&](const Busy& one) {
        return one.thread != std::this_thread::get_id() && concerned(one.world, what);
    });
}

// Python runs without the mutex: making an exception may collect garbage, and a world among it calls back.
void refuse_busy(bool (*concerned)(dWorldID, const void*), const void* what)
{
    if (busy_count.load(std::memory_order_acquire) == 0 || !stepped_elsewhere(concerned, what)) return;
    PyErr_SetString(busy_error, "the world is in a step on another thread");
    throw nb::python_error();
}

}  // namespace

nb::object wrapped(dSpaceID space)
{
    return space ? nb::cast(SpaceHandle{{reinterpret_cast<dGeomID>(space)}}) : nb::none();
}
nb::object wrapped(dGeomID geom)
{
    if (!geom) return nb::none();
    return dGeomIsSpace(geom) ? wrapped(reinterpret_cast<dSpaceID>(geom)) : nb::cast(GeomHandle{geom});
}

namespace {

// Tuples and lists of floats, the common case, without a detour through numpy.
bool read_sequence(nb::handle from, dReal* to, Py_ssize_t size)
{
    bool tuple = PyTuple_CheckExact(from.ptr());
    if (!tuple && !PyList_CheckExact(from.ptr())) return false;
    if ((tuple ? PyTuple_Size(from.ptr()) : PyList_Size(from.ptr())) != size) return false;
    for (Py_ssize_t i = 0; i < size; ++i) {
        PyObject* one = tuple ? PyTuple_GetItem(from.ptr(), i) : PyList_GetItem(from.ptr(), i);
        if (!PyFloat_Check(one)) return false;
        to[i] = PyFloat_AsDouble(one);
    }
    return true;
}

}  // namespace

void read_numbers(nb::handle from, dReal* to, int size, const char* what)
{
    if (read_sequence(from, to, size)) return;
    // A vector of three may have its padding; a 3 x 3 matrix comes with or without.
    nb::object flat = nb::module_::import_("numpy").attr("asarray")(from, "float64");
    size_t count = nb::cast<size_t>(flat.attr("size"));
    bool padded = size == 12 && count == 9;
    if (!padded && count != size_t(size) && !(size == 3 && count == 4)) {
        std::string text = std::string(what) + ": " + std::to_string(size) + " numbers expected, not " +
                           std::to_string(count);
        throw nb::value_error(text.c_str());
    }
    nb::object array = nb::module_::import_("numpy").attr("ascontiguousarray")(flat);
    auto view = nb::cast<nb::ndarray<const double, nb::c_contig, nb::device::cpu>>(array);
    if (padded)
        for (int i = 0; i < 3; ++i) std::copy_n(view.data() + 3 * i, 3, to + 4 * i);
    else
        std::copy_n(view.data(), std::min<size_t>(count, size_t(size)), to);
}

namespace {

// As numpy calls it.
template <typename T>
const char* name_of()
{
    if constexpr (std::is_floating_point_v<T>)
        return sizeof(T) == 8 ? "float64" : "float32";
    else if constexpr (std::is_unsigned_v<T>)
        return sizeof(T) == 4 ? "uint32" : "uint8";
    else
        return "int16";
}

}  // namespace

template <typename T>
Array<const T> array_in(nb::handle from)
{
    nb::object array = nb::module_::import_("numpy").attr("ascontiguousarray")(from, name_of<T>());
    auto view = nb::cast<nb::ndarray<const T, nb::c_contig, nb::device::cpu>>(array);
    Array<const T> result{array, view.data(), view.size(), {}};
    for (size_t i = 0; i < view.ndim(); ++i) result.shape.push_back(view.shape(i));
    return result;
}
template Array<const double> array_in<double>(nb::handle);
template Array<const float> array_in<float>(nb::handle);
template Array<const unsigned> array_in<unsigned>(nb::handle);
template Array<const short> array_in<short>(nb::handle);
template Array<const unsigned char> array_in<unsigned char>(nb::handle);

void read_some(nb::handle from, dReal* to, int capacity, const char* what)
{
    const Array<const double> given = array_in<double>(from);
    if (given.size < 1 || given.size > size_t(capacity)) {
        std::string text = std::string(what) + ": 1 ... " + std::to_string(capacity) +
                           " numbers expected, not " + std::to_string(given.size);
        throw nb::value_error(text.c_str());
    }
    std::fill_n(to, capacity, 0);
    std::copy_n(given.data, given.size, to);
}

namespace {

nb::object shaped(size_t dimensions, size_t rows, size_t columns, dReal** data)
{
    dReal* memory = new dReal[rows * std::max<size_t>(columns, 1) + 1];
    nb::capsule owner(memory, [](void* p) noexcept { delete[] static_cast<dReal*>(p); });
    *data = memory;
    size_t shape[2] = {rows, columns};
    return nb::cast(nb::ndarray<nb::numpy, dReal>(memory, dimensions, shape, owner));
}

}  // namespace

nb::object real_array(size_t rows, size_t columns, dReal** data)
{
    return shaped(columns ? 2 : 1, rows, columns, data);
}

nb::object real_table(size_t rows, size_t columns, dReal** data) { return shaped(2, rows, columns, data); }

nb::object array_of(const dReal* v, int count)
{
    if (!v) return nb::none();
    dReal* data;
    nb::object result = real_array(size_t(count), 0, &data);
    std::copy_n(v, count, data);
    return result;
}

nb::object matrix_of(const dReal* v)
{
    if (!v) return nb::none();
    dReal* data;
    nb::object result = real_array(3, 3, &data);
    for (int i = 0; i < 3; ++i) std::copy_n(v + 4 * i, 3, data + 3 * i);
    return result;
}

nb::object empty_records(nb::handle dtype, size_t count, void** data)
{
    nb::object array = nb::module_::import_("numpy").attr("zeros")(count, dtype);
    Py_buffer view;
    if (PyObject_GetBuffer(array.ptr(), &view, PyBUF_WRITABLE) != 0) throw nb::python_error();
    *data = view.buf;
    PyBuffer_Release(&view);  // the array stays where it is
    return array;
}

Call::Call() : outer_(innermost) { innermost = this; }
Call::~Call() { innermost = outer_; }
void Call::say(Said said)
{
    if (innermost) {
        innermost->said_.push_back(std::move(said));
        return;
    }
    std::lock_guard lock(mutex);
    helpers_said.push_back(std::move(said));
    helpers_spoke.store(true, std::memory_order_release);
}

void Call::uses(dWorldID world)
{
    refuse_busy([](dWorldID busy_one, const void* what) { return busy_one == what; }, world);
}
void Call::uses(dBodyID body)
{
    if (busy_count.load(std::memory_order_acquire) && body) uses(dBodyGetWorld(body));
}
void Call::uses(dJointID joint)
{
    if (busy_count.load(std::memory_order_acquire) == 0 || !joint) return;
    for (int i = 0; i < 2; ++i)
        if (dBodyID body = dJointGetBody(joint, i)) uses(body);
}
void Call::uses(dGeomID geom)
{
    if (busy_count.load(std::memory_order_acquire) == 0 || !geom) return;
    if (dBodyID body = dGeomGetBody(geom)) uses(body);
    refuse_busy(
        [](dWorldID world, const void* what) {
            dSpaceID space = dWorldGetContactSpace(world);
            return space && outermost(reinterpret_cast<dGeomID>(space)) == what;
        },
        outermost(geom));
}

void Call::done()
{
    std::vector<Said> said = std::move(said_);
    if (helpers_spoke.exchange(false, std::memory_order_acquire)) {
        std::lock_guard lock(mutex);
        said.insert(said.end(), helpers_said.begin(), helpers_said.end());
        helpers_said.clear();
    }
    if (waiting && !outer_) {
        PyObject* error = waiting;
        waiting = nullptr;
        PyErr_SetObject(reinterpret_cast<PyObject*>(Py_TYPE(error)), error);
        Py_DECREF(error);
        throw nb::python_error();
    }
    for (const Said& one : said) {
        if (one.refused) raise(one);
        if (PyErr_WarnEx(warning, one.text.c_str(), 1) < 0) throw nb::python_error();
    }
}

bool any_is_busy() { return busy_count.load(std::memory_order_acquire) > 0; }

Released::Released(const dWorldID* worlds, size_t count) : worlds_(worlds), count_(count)
{
    {
        std::lock_guard lock(mutex);
        for (size_t i = 0; i < count; ++i) busy.push_back({worlds[i], std::this_thread::get_id()});
        busy_count.store(int(busy.size()), std::memory_order_release);
    }
    state_ = PyEval_SaveThread();
}
Released::~Released()
{
    or_wait_for_the_end([this] { PyEval_RestoreThread(state_); });
    std::lock_guard lock(mutex);
    for (size_t i = 0; i < count_; ++i) {
        auto it = std::find_if(busy.begin(), busy.end(), [&](const Busy& one) {
            return one.world == worlds_[i] && one.thread == std::this_thread::get_id();
        });
        busy.erase(it);
    }
    busy_count.store(int(busy.size()), std::memory_order_release);
}

void keep_exception()
{
    PyObject *type, *value, *trace;
    PyErr_Fetch(&type, &value, &trace);
    PyErr_NormalizeException(&type, &value, &trace);
    if (value && trace) PyException_SetTraceback(value, trace);
    Py_XDECREF(type);
    Py_XDECREF(trace);
    if (waiting)
        Py_XDECREF(value);
    else
        waiting = value;
}
bool exception_waits() { return waiting; }

namespace {
struct Kept {
    nb::object object;
    dWorldID world;
};
using AllKept = std::map<std::pair<const void*, int>, Kept>;
AllKept& all_kept()
{
    static AllKept* objects = new AllKept;  // outlives the interpreter: the library may still point into it
    return *objects;
}

// What is let go is released at the end: it may call back.
template <typename Gone>
void let_go(const Gone& gone)
{
    std::vector<nb::object> released;
    AllKept& all = all_kept();
    for (auto it = all.begin(); it != all.end();) {
        if (!gone(it->first.first, it->first.second, it->second.world)) {
            ++it;
            continue;
        }
        released.push_back(std::move(it->second.object));
        it = all.erase(it);
    }
}

// A world with a history may bring its objects back.
bool returns(dWorldID world) { return world && dWorldGetHistory(world) > 0; }
}  // namespace

void keep(const void* owner, int place, nb::object object, dWorldID world)
{
    Kept before = std::exchange(all_kept()[{owner, place}], {std::move(object), world});
}
nb::object kept(const void* owner, int place)
{
    auto it = all_kept().find({owner, place});
    return it == all_kept().end() ? nb::none() : it->second.object;
}
void forget(const void* owner)
{
    let_go([&](const void* one, int, dWorldID world) { return one == owner && !returns(world); });
}
void forget_dead(bool (*dead)(const void* owner, int place))
{
    let_go([&](const void* one, int place, dWorldID world) { return !returns(world) && dead(one, place); });
}
void forget_world(dWorldID gone)
{
    let_go([&](const void*, int, dWorldID world) { return world == gone; });
}

void install_handlers()
{
    dSetErrorHandler(on_refusal);
    dSetDebugHandler(on_refusal);
    dSetMessageHandler(on_message);
}

void set_exceptions(nb::object refused, nb::object dead, nb::object busy_one, nb::object warned)
{
    refused_error = refused.release().ptr();
    dead_error = dead.release().ptr();
    busy_error = busy_one.release().ptr();
    warning = warned.release().ptr();
}
