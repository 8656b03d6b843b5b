// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A StructureStream of geoms: what their classes need besides numbers.
//   shared objects  meshes, height fields and polyhedra, which several geoms may have. A clone has those of
//                   the original. A file has each of them once, where the first geom that has it comes, and
//                   names it by its number after that.
//   other geoms     that come before, by number.
#pragma once

#include "base/streams/pointer_numbers.h"
#include "base/streams/structure_stream.h"
#include "collide/geom.h"

namespace epode {

class HeightSamples;

class ShapeStream : public StructureStream {
  public:
    using StructureStream::StructureStream;

    // visit(object, stream) saves an object that has not been met before, and loads one: null after a
    // failure, else an object that `destroy` destroys if loading fails later (null: another one owns it).
    template <typename T, typename Visit>
    T* shared(T* object, void (*destroy)(T*), Visit&& visit)
    {
        if (is_clone()) {
            pointer(object);
            return object;
        }
        const int known = saves() && object ? numbers_.find(object) : -1;
        std::uint32_t at = !object ? 0 : std::uint32_t(known >= 0 ? known : objects_.size()) + 1;
        number(at);
        if (saves()) {
            if (object && known < 0 && note(object, kind<T>, nullptr)) visit(object, *this);
            return object;
        }
        if (at == 0 || failed()) return nullptr;
        if (at <= std::uint32_t(objects_.size())) return static_cast<T*>(shared_at(int(at) - 1, kind<T>));
        if (!demand(at == std::uint32_t(objects_.size()) + 1, "a mesh in it is not there")) return nullptr;
        T* const made = visit(object, *this);
        if (!made || note(made, kind<T>, reinterpret_cast<void (*)(void*)>(destroy))) return made;
        if (destroy) destroy(made);
        return nullptr;
    }
    // Of height functions, for what is saved.
    void lend(const HeightSamples& heights) { heights_ = &heights; }
    const HeightSamples* heights() const { return heights_; }

    // A geom that comes before this one, or null.
    void geom(Geom*& one);

    // All geoms so far, in order. False after a failure.
    bool add(Geom& one);
    int find(const Geom& one) const { return geom_numbers_.find(&one); }
    std::span<Geom* const> geoms() const { return geoms_.span(); }

    // What has been loaded is not wanted: geoms have been destroyed before.
    void destroy_shared();

  private:
    struct Object {
        void* object;
        const void* kind;
        void (*destroy)(void*);
    };
    template <typename T>
    static constexpr char kKind = 0;
    template <typename T>
    static constexpr const void* kind = &kKind<T>;

    bool note(const void* object, const void* kind, void (*destroy)(void*));
    void* shared_at(int i, const void* kind);

    const HeightSamples* heights_ = nullptr;
    Array<Object> objects_;
    PointerNumbers numbers_, geom_numbers_;
    Array<Geom*> geoms_;
};

// The structure of a shape that is nothing but sizes (GeomType::structure).
template <typename Shape>
void structure_of_sizes(Geom& geom, ShapeStream& stream)
{
    static_assert(sizeof(Shape) % sizeof(Real) == 0 && alignof(Shape) == alignof(Real));
    auto& shape = static_cast<ShapeGeom<Shape>&>(geom).shape;
    stream.sizes(reinterpret_cast<Real*>(&shape), int(sizeof(Shape) / sizeof(Real)));
}

}  // namespace epode
