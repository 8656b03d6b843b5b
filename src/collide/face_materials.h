// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The material of a geom with those of its faces: triangles of a mesh, cells of a height field. Numbers of materials are
// bytes; 0 is the geom's own. Most geoms have neither, and most that have a material have no faces with others.
#pragma once

#include "base/array.h"
#include "collide/geom.h"
#include "ode/contacts.h"

namespace epode {

inline constexpr int kMostFaceMaterials = 255;

struct FaceMaterials {
    Array<unsigned char> numbers;  // of the faces
    Array<dMaterial> materials;    // by number, from 1 on
    Array<bool> given;             // which of them the program has given
};

struct GeomMaterial : dMaterial {
    bool is_given = false;           // else it is the default's, and here for the faces alone
    FaceMaterials* faces = nullptr;  // null: none has its own
};

inline const GeomMaterial* own_material(const Geom& geom)
{
    return static_cast<const GeomMaterial*>(geom.material);
}
inline GeomMaterial* own_material(Geom& geom) { return static_cast<GeomMaterial*>(geom.material); }

// How many faces may have materials; 0: none.
int face_count(const Geom& geom);
// The face that is nearest to a point of the world, before others one that looks along the unit vector n or against it; -1: none
// is near, or there is none at all.
int face_at(const Geom& geom, Vec3 at, Vec3 n);

// Gives a geom's materials back.
void drop_material(Geom& geom);

}  // namespace epode
