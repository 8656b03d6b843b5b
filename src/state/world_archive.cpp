// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "state/world_archive.h"

#include <new>

#include "base/memory.h"

namespace epode {
namespace {

History* history_of(const World* world)
{
    if (!world || !world->step_state || !world->step_state->archive) return nullptr;
    return &world->step_state->archive->history;
}

}  // namespace

WorldArchive* archive_of(World& world)
{
    StepState* const kept = step_state(world);
    if (!kept) return nullptr;
    if (kept->archive) return kept->archive;
    void* memory = allocate(sizeof(WorldArchive));
    if (!memory) return nullptr;
    kept->archive = new (memory) WorldArchive(world);
    kept->free_archive = [](WorldArchive* archive) {
        archive->~WorldArchive();
        release(archive, sizeof *archive);
    };
    return kept->archive;
}

bool any_history() { return History::worlds() > 0; }

bool keep_for_history(Body& body)
{
    History* const history = history_of(body.world);
    return history && history->keep(body);
}

bool keep_for_history(Joint& joint, dJointGroupID group)
{
    History* const history = history_of(joint.world);
    return history && history->keep(joint, group);
}

bool keep_for_history(Geom& geom)
{
    return geom.recorder && static_cast<History*>(geom.recorder)->keep(geom);
}

}  // namespace epode
