// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What every bound call shares: typed handles, arrays in and out, refusals that become exceptions, and worlds that
// are busy in a step on another thread.
//
// A handle cannot be made from a number, so every pointer that reaches the library came from it, and the library
// recognises those that are dead or of the wrong kind. Its messages are collected while a call runs: those of the
// calling thread by that thread, those of the engine's helpers by whichever call ends next.
#pragma once

#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>
#include <nanobind/stl/string.h>

#include <cstring>
#include <vector>

#include <ode/ext.h>
#include <ode/ode.h>

#include "gil.h"

namespace nb = nanobind;
using namespace nb::literals;

template <typename P>
struct Handle {
    P p = nullptr;
    bool operator==(const Handle& other) const { return p == other.p; }
};
using WorldHandle = Handle<dWorldID>;
using BodyHandle = Handle<dBodyID>;
using JointHandle = Handle<dJointID>;
using GroupHandle = Handle<dJointGroupID>;
using FluidHandle = Handle<dFluidID>;
using HeightsHandle = Handle<dHeightfieldDataID>;
using MeshHandle = Handle<dTriMeshDataID>;
using GeomHandle = Handle<dGeomID>;
struct SpaceHandle : GeomHandle {};

template <typename P>
P get(const Handle<P>* handle)
{
    return handle ? handle->p : nullptr;
}
inline dSpaceID space_of(const SpaceHandle* handle)
{
    return handle ? reinterpret_cast<dSpaceID>(handle->p) : nullptr;
}

template <typename P>
nb::object wrapped(P p)
{
    return p ? nb::cast(Handle<P>{p}) : nb::none();
}
nb::object wrapped(dSpaceID space);
nb::object wrapped(dGeomID geom);  // a space, if it is one

// Some numbers from Python: a sequence, or an array of any shape, of one of two sizes.
template <int N>
struct Numbers {
    dReal v[N] = {};
};
void read_numbers(nb::handle from, dReal* to, int size, const char* what);

template <int N>
Numbers<N> numbers(nb::handle from, const char* what)
{
    Numbers<N> result;
    read_numbers(from, result.v, N, what);
    return result;
}

// A contiguous array of T that lives as long as this does; what is none is converted (or, if it is to be written
// to, refused).
template <typename T>
struct Array {
    nb::object owner;
    T* data = nullptr;
    size_t size = 0;
    std::vector<size_t> shape;
};
template <typename T>
Array<const T> array_in(nb::handle from);

// 1 ... capacity numbers; those that are not given become 0.
void read_some(nb::handle from, dReal* to, int capacity, const char* what);

// New arrays.
nb::object array_of(const dReal* v, int count);
nb::object matrix_of(const dReal* v);                              // 3 x 3, from rows of four
nb::object real_array(size_t rows, size_t columns, dReal** data);  // to be filled; no columns: one dimension
nb::object real_table(size_t rows, size_t columns, dReal** data);  // two, whatever it holds
nb::object empty_records(nb::handle dtype, size_t count, void** data);  // structured, dtype from module.cpp

// A message of the library.
struct Said {
    bool refused;
    int number;
    std::string text;
};

// One call: collects messages, refuses worlds that are busy elsewhere, throws in done().
class Call {
  public:
    Call();
    ~Call();
    static void say(Said said);  // to the innermost call of this thread, or to the next one that ends
    Call(const Call&) = delete;
    Call& operator=(const Call&) = delete;
    void uses(dWorldID world);
    void uses(dBodyID body);
    void uses(dJointID joint);
    void uses(dGeomID geom);
    void uses(dSpaceID space) { uses(reinterpret_cast<dGeomID>(space)); }
    template <typename P>
    void uses(P)
    {}
    bool silent() const { return said_.empty(); }
    void done();  // throws what was refused, or an exception of a callback

  private:
    Call* outer_;
    std::vector<Said> said_;
};

// Whether any world is in a step on another thread.
bool any_is_busy();

// The worlds of a step, marked busy, and the interpreter's lock released, while this lives.
class Released {
  public:
    Released(const dWorldID* worlds, size_t count);  // the array outlives this
    ~Released();

  private:
    const dWorldID* worlds_;
    size_t count_;
    PyThreadState* state_;
};

// An exception of a callback: kept, raised when the call that led there ends. True while one waits.
void keep_exception();
bool exception_waits();

// Objects that the library points to: kept under the object that points to them, until another one takes the place.
// They are let go when the owner is destroyed, or with its world, if its history may bring the owner back.
void keep(const void* owner, int place, nb::object object, dWorldID world = nullptr);
nb::object kept(const void* owner, int place);
void forget(const void* owner);
void forget_world(dWorldID gone);
void forget_dead(bool (*dead)(const void* owner, int place));
void forget_joints();  // those of a group are gone
// A copy of a world calls the same functions of fluids, which are kept for it, and none that knows geoms of the original.
void adopt_functions(dWorldID from, dWorldID copy);

void install_handlers();
void set_exceptions(nb::object refused, nb::object dead, nb::object busy, nb::object warning);

void bind_structures(nb::module_& m);
void bind_functions(nb::module_& m);
void bind_written(nb::module_& m);
void bind_arrays(nb::module_& m);
void bind_shapes(nb::module_& m);
void bind_callbacks(nb::module_& m);
void bind_assemblies(nb::module_& m);
void bind_command(nb::module_& m);
void bind_robots(nb::module_& m);
void bind_batches(nb::module_& m);
void bind_environments(nb::module_& m);
void bind_decomposition(nb::module_& m);
