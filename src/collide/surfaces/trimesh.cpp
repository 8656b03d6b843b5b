// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The bond between mesh data and the geoms that use them.
#include "collide/surfaces/trimesh.h"

#include "collide/space.h"

namespace epode {

namespace {

std::atomic<std::uint64_t> g_meshes{0};

class Locked {
  public:
    explicit Locked(SpinLock& lock) : lock_(lock) { lock_.lock(); }
    Locked(const Locked&) = delete;
    Locked& operator=(const Locked&) = delete;
    ~Locked() { lock_.unlock(); }

  private:
    SpinLock& lock_;
};

TrimeshData* data_of(Geom& geom)
{
    const TrimeshGeom* mesh = as_trimesh(geom);
    return mesh ? mesh->shape.data : nullptr;
}

void let_go(void* data, const void*, std::size_t)
{
    static_cast<TrimeshData*>(data)->users.fetch_sub(1, std::memory_order_relaxed);
}

}  // namespace

TrimeshData::TrimeshData() : Numbered(Tag::kTrimeshData)
{
    serial = g_meshes.fetch_add(1, std::memory_order_relaxed) + 1;
}

TrimeshData::~TrimeshData()
{
    while (geoms) {
        TrimeshGeom* geom = geoms;
        geom->use(nullptr);
        mark_changed(*geom);
    }
}

bool TrimeshData::in_use() const
{
    if (users.load(std::memory_order_relaxed) > 0) CallGuard::release_left();
    if (users.load(std::memory_order_relaxed) > 0) return true;
    for (const TrimeshGeom* g = geoms; g; g = g->next_user)
        if (in_locked_space(*g)) return true;
    return false;
}

void TrimeshData::notify_geoms()
{
    for (TrimeshGeom* g = geoms; g; g = g->next_user) mark_changed(*g);
}

void TrimeshGeom::use(TrimeshData* fresh)
{
    if (TrimeshData* old = shape.data) {
        const Locked locked(old->geoms_lock);
        (previous_user ? previous_user->next_user : old->geoms) = next_user;
        if (next_user) next_user->previous_user = previous_user;
    }
    shape.data = fresh;
    next_user = previous_user = nullptr;
    if (!fresh) return;
    const Locked locked(fresh->geoms_lock);
    next_user = fresh->geoms;
    if (next_user) next_user->previous_user = this;
    fresh->geoms = this;
}

TrimeshGeom* as_trimesh(Geom& geom)
{
    return geom.type->number == dTriMeshClass ? static_cast<TrimeshGeom*>(&geom) : nullptr;
}

MeshHold::MeshHold(Geom& geom) : geom_(geom), data_(data_of(geom) ? let_go : nullptr, data_of(geom))
{
    if (TrimeshData* const data = data_of(geom)) data->users.fetch_add(1, std::memory_order_relaxed);
}

}  // namespace epode
