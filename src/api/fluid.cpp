// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Fluids, as C functions.
#include "ode/fluid.h"

#include <optional>

#include "base/float_environment.h"
#include "base/objects/struct_size.h"
#include "collide/types/registry.h"
#include "dynamics/forces/fluid.h"
#include "fluid/water_level.h"
#include "step/fluids.h"
#include "step/step.h"

namespace epode {

template <>
inline constexpr std::size_t kSmallestSize<dFluidSettings> = offsetof(dFluidSettings, drag);

}  // namespace epode

using namespace epode;

namespace {

// What is wrong with the settings, in words; null: nothing.
const char* fault_in(const dFluidSettings& s)
{
    const auto positive = [](dReal x) { return usable(x) && x >= 0; };
    if (!positive(s.density)) return "density must be 0 or more, and finite";
    if (!positive(s.drag) || !positive(s.linear_drag) || !positive(s.angular_drag))
        return "drag, linear_drag and angular_drag must be 0 or more, and finite";
    return usable(s.current, 3) ? nullptr : "current must be finite";
}

// The part of a geom that lies in the fluid.
Immersed submerged(const Fluid& fluid, Geom& geom)
{
    FloatingGeom floating;
    const GeomHold hold(geom, fluid.has_functions());
    if (!floating.take(geom)) return {};
    const Immersed local = floating.under(in_frame(level_at(fluid, floating), floating.pose()));
    if (!(local.volume > 0)) return {};
    const Vec3 centre = floating.pose().to_world(local.centre());
    return holds(fluid, centre) ? Immersed{local.volume, local.volume * centre} : Immersed{};
}

// Functions of the fluid may run outside of a step: its world, and that of what is asked for, stay. Nothing to do if they are busy already.
class FluidCall {
  public:
    explicit FluidCall(const Fluid& fluid, World* other = nullptr)
    {
        if (!fluid.has_functions()) return;
        mark(first_, *fluid.world);
        if (other) mark(second_, *other);
    }

  private:
    static void mark(std::optional<CopyMark>& to, World& world)
    {
        if (!is_busy(world)) to.emplace(world);
    }
    std::optional<CopyMark> first_, second_;
};

int write(const Immersed& part, dReal* volume, dReal* centre)
{
    const bool any = part.volume > 0;
    if (volume) *volume = any ? part.volume : Real(0);
    if (centre) store(centre, part.centre());
    return any;
}

}  // namespace

#define FLUID_OR(...)                           \
    Fluid* const fluid = from_handle<Fluid>(f); \
    EPODE_USER(fluid __VA_OPT__(, ) __VA_ARGS__)
#define IDLE_FLUID_OR(...) \
    FLUID_OR(__VA_ARGS__); \
    EPODE_USER_SAY(!in_step(*fluid->world), busy_text(*fluid->world) __VA_OPT__(, ) __VA_ARGS__)

extern "C" {

int dFluidSettingsInit(dFluidSettings* settings, unsigned struct_size)
{
    EPODE_SIZED_AS(settings, struct_size, 0);
    copy_sized(kDefaultFluidSettings, settings, struct_size);
    return 1;
}

dFluidID dFluidCreate(dWorldID w)
{
    EPODE_WORLD_OR(nullptr);
    EPODE_USER_SAY(!in_step(*world), busy_text(*world), nullptr);
    Fluid* const fluid = create_fluid(*world);
    EPODE_USER_SAY(fluid, kOutOfMemory, nullptr);
    wake_in_fluids(*world);
    return to_handle(fluid);
}

void dFluidDestroy(dFluidID f)
{
    IDLE_FLUID_OR();
    World& world = *fluid->world;
    wake_in_fluids(world);
    destroy_fluid(*fluid);
}

dWorldID dFluidGetWorld(dFluidID f)
{
    FLUID_OR(nullptr);
    return to_handle(fluid->world);
}

int dWorldGetNumFluids(dWorldID w)
{
    EPODE_WORLD_OR(0);
    return world->fluids.size();
}

dFluidID dWorldGetFluid(dWorldID w, int index)
{
    EPODE_WORLD_OR(nullptr);
    EPODE_USER(index >= 0 && index < world->fluids.size(), nullptr);
    return to_handle(world->fluids[index]);
}

int dFluidSetSettings(dFluidID f, const dFluidSettings* settings)
{
    IDLE_FLUID_OR(0);
    EPODE_SIZED(settings, 0);
    const dFluidSettings whole = completed(*settings, kDefaultFluidSettings);
    const char* const fault = fault_in(whole);
    EPODE_USER_SAY(!fault, fault, 0);
    fluid->settings = whole;
    wake_in_fluids(*fluid->world);
    return 1;
}

int dFluidGetSettings(dFluidID f, dFluidSettings* settings)
{
    FLUID_OR(0);
    EPODE_SIZED(settings, 0);
    copy_sized(fluid->settings, settings, settings->struct_size);
    return 1;
}

void dFluidSetPlane(dFluidID f, dReal a, dReal b, dReal c, dReal d)
{
    IDLE_FLUID_OR();
    EPODE_USER(usable(a) && usable(b) && usable(c) && usable(d));
    Vec3 normal{a, b, c};
    EPODE_USER(normalize(normal));
    const Real offset = d / dot(normal, {a, b, c});
    EPODE_USER(usable(offset));
    fluid->normal = normal, fluid->offset = offset;
    wake_in_fluids(*fluid->world);
}

void dFluidGetPlane(dFluidID f, dVector4 plane)
{
    FLUID_OR();
    EPODE_USER(plane);
    store(plane, fluid->normal);
    plane[3] = fluid->offset;
}

void dFluidSetSurface(dFluidID f, dFluidSurface* surface, void* data)
{
    IDLE_FLUID_OR();
    fluid->surface = surface, fluid->surface_data = data;
    wake_in_fluids(*fluid->world);
}

void dFluidSetCurrentFunction(dFluidID f, dFluidCurrent* current, void* data)
{
    IDLE_FLUID_OR();
    fluid->current = current, fluid->current_data = data;
    wake_in_fluids(*fluid->world);
}

void dFluidSetVolume(dFluidID f, dGeomID volume)
{
    IDLE_FLUID_OR();
    const Geom* const geom = volume ? from_handle<Geom>(volume) : nullptr;
    EPODE_USER_SAY(!volume || (geom && bounds_fluids(*geom)),
                   "a fluid's volume must be a box, sphere, capsule, cylinder, ellipsoid or convex hull");
    fluid->volume = volume;
    wake_in_fluids(*fluid->world);
}

dGeomID dFluidGetVolume(dFluidID f)
{
    FLUID_OR(nullptr);
    return from_handle<Geom>(fluid->volume) ? fluid->volume : nullptr;
}

void dFluidSetTime(dFluidID f, dReal time)
{
    IDLE_FLUID_OR();
    EPODE_USER(usable(time));
    fluid->time = time;
}

dReal dFluidGetTime(dFluidID f)
{
    FLUID_OR(0);
    return fluid->time;
}

int dFluidGetSubmerged(dFluidID f, dGeomID g, dReal* volume, dVector3 centre)
{
    const FloatEnvironment floats;
    FLUID_OR(0);
    EPODE_GEOM(geom, g, 0);
    const FluidCall call(*fluid);
    return write(submerged(*fluid, *geom), volume, centre);
}

int dFluidGetSubmergedBody(dFluidID f, dBodyID b, dReal* volume, dVector3 centre)
{
    const FloatEnvironment floats;
    FLUID_OR(0);
    const Body* const body = from_handle<Body>(b);
    EPODE_USER(body, 0);
    const FluidCall call(*fluid, body->world);
    Immersed sum;
    for_each_geom_from(body->first_geom, [&](Geom& geom) { sum.add(submerged(*fluid, geom)); });
    return write(sum, volume, centre);
}

int dBodyGetFluidForce(dBodyID b, dVector3 force, dVector3 torque)
{
    const Body* const body = from_handle<Body>(b);
    EPODE_USER(body, 0);
    if (force) store(force, body->fluid.force);
    if (torque) store(torque, body->fluid.torque);
    return body->fluid.wet;
}

}  // extern "C"
