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

namespace {

struct Said {
    bool refused;
    int number;
    std::string text;
};

struct Frame {
    Frame* outer;
    std::vector<Said> said;
};
thread_local Frame* frame = nullptr;
thread_local PyObject* waiting = nullptr;  // an exception of a callback

std::mutex mutex;
std::vector<Said> helpers_said;
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
    if (frame) {
        frame->said.push_back({refused, number, text});
        return;
    }
    std::lock_guard lock(mutex);
    helpers_said.push_back({refused, number, text});
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

void read_numbers(nb::handle from, dReal* to, int size, const char* what)
{
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
    if constexpr (std::is_floating_point_v<T>) return sizeof(T) == 8 ? "float64" : "float32";
    else if constexpr (std::is_unsigned_v<T>) return sizeof(T) == 4 ? "uint32" : "uint8";
    else return "int16";
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

nb::object real_array(size_t rows, size_t columns, dReal** data)
{
    dReal* memory = new dReal[rows * std::max<size_t>(columns, 1) + 1]();
    nb::capsule owner(memory, [](void* p) noexcept { delete[] static_cast<dReal*>(p); });
    *data = memory;
    size_t shape[2] = {rows, columns};
    return nb::cast(nb::ndarray<nb::numpy, dReal>(memory, columns ? 2 : 1, shape, owner));
}

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
    *data = reinterpret_cast<void*>(nb::cast<size_t>(array.attr("ctypes").attr("data")));
    return array;
}

Call::Call() { frame = new Frame{frame, {}}; }
Call::~Call()
{
    Frame* mine = frame;
    frame = mine->outer;
    delete mine;
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
    std::vector<Said> said = std::move(frame->said);
    {
        std::lock_guard lock(mutex);
        said.insert(said.end(), helpers_said.begin(), helpers_said.end());
        helpers_said.clear();
    }
    if (waiting && !frame->outer) {
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

Released::Released(const dWorldID* worlds, size_t count) : worlds_(worlds, worlds + count)
{
    {
        std::lock_guard lock(mutex);
        for (dWorldID world : worlds_) busy.push_back({world, std::this_thread::get_id()});
        busy_count.store(int(busy.size()), std::memory_order_release);
    }
    state_ = PyEval_SaveThread();
}
Released::~Released()
{
    PyEval_RestoreThread(state_);
    std::lock_guard lock(mutex);
    for (dWorldID world : worlds_) {
        auto it = std::find_if(busy.begin(), busy.end(), [&](const Busy& one) {
            return one.world == world && one.thread == std::this_thread::get_id();
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
using Kept = std::map<std::pair<const void*, int>, nb::object>;
Kept& all_kept()
{
    static Kept* objects = new Kept;  // outlives the interpreter: the library may still point into it
    return *objects;
}
}  // namespace

void keep(const void* owner, int place, nb::object object) { all_kept()[{owner, place}] = std::move(object); }
nb::object kept(const void* owner, int place)
{
    auto it = all_kept().find({owner, place});
    return it == all_kept().end() ? nb::none() : it->second;
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
