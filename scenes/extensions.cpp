// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Names and layouts of ode/ext.h, repeated here by hand because the headers of ODE itself do not have them.
// struct_size guards the layout: the library takes and fills as many fields as it says.
#include "scenes/extensions.h"

#include <algorithm>
#include <fstream>

#include "record/watch/lookup.h"

namespace epode::scenes {

namespace {

struct RawStepReport {
    unsigned struct_size;
    int islands, bodies, joints, rows;
    double residual;
    int iterations, fallbacks, contained_islands;
};

struct RawDiagnosis {
    int kind, severity;
    void* objects[4];
    double figure, threshold;
    int first_step, steps, call;
};

struct RawMaterial {
    unsigned struct_size;
    dReal friction, bounce, bounce_speed;
    dVector3 surface_velocity;
    dReal rolling_friction, compliance, damping_time;
    int friction_rule, bounce_rule, rolling_friction_rule;
};

struct RawContact {
    dGeomID g1, g2;
    dVector3 pos, normal;
    dReal depth, normal_force;
    dVector3 friction_force;
};

template <class Function>
Function find(const char* name)
{
    return reinterpret_cast<Function>(record::library_function(name));
}

using StepFast = int (*)(dWorldID, dReal, int);
using SetMode = void (*)(dWorldID, int);
using SetWarmStarting = void (*)(dWorldID, dReal);
using Step = int (*)(dWorldID, dReal);
using SetSpace = void (*)(dWorldID, dSpaceID);
using GetMaterial = int (*)(dGeomID, RawMaterial*);
using SetMaterial = int (*)(dGeomID, const RawMaterial*);
using GetContacts = int (*)(dWorldID, RawContact*, int);
using Diagnose = int (*)(dWorldID, RawDiagnosis*, int);
using DiagnosisText = int (*)(const RawDiagnosis*, char*, int);
using GetReport = int (*)(dWorldID, RawStepReport*);

StepFast fast_function()
{
    static const StepFast function = find<StepFast>("dWorldStepFast1");
    return function;
}

}  // namespace

namespace {

constexpr dReal kWater = 1000;
constexpr int kAlongZ = 3, kSegments = 32;

using CreateCone = dGeomID (*)(dSpaceID, dReal, dReal);
using CreateOfThree = dGeomID (*)(dSpaceID, dReal, dReal, dReal);
using MassOfCone = void (*)(dMass*, dReal, int, dReal, dReal);
using MassOfEllipsoid = void (*)(dMass*, dReal, dReal, dReal, dReal);
using MassOfTapered = void (*)(dMass*, dReal, int, dReal, dReal, dReal);
using CreateFluid = void* (*)(dWorldID);
using GetTriangles = int (*)(dGeomID, int, dReal*, int);

}  // namespace

dGeomID create_cone(dSpaceID space, double radius, double length, dMass& mass)
{
    const auto create = find<CreateCone>("dCreateCone");
    const auto weigh = find<MassOfCone>("dMassSetCone");
    if (!create || !weigh) return nullptr;
    weigh(&mass, kWater, kAlongZ, dReal(radius), dReal(length));
    return create(space, dReal(radius), dReal(length));
}

dGeomID create_ellipsoid(dSpaceID space, double rx, double ry, double rz, dMass& mass)
{
    const auto create = find<CreateOfThree>("dCreateEllipsoid");
    const auto weigh = find<MassOfEllipsoid>("dMassSetEllipsoid");
    if (!create || !weigh) return nullptr;
    weigh(&mass, kWater, dReal(rx), dReal(ry), dReal(rz));
    return create(space, dReal(rx), dReal(ry), dReal(rz));
}

dGeomID create_tapered_capsule(dSpaceID space, double r1, double r2, double length, dMass& mass)
{
    const auto create = find<CreateOfThree>("dCreateTaperedCapsule");
    const auto weigh = find<MassOfTapered>("dMassSetTaperedCapsule");
    if (!create || !weigh) return nullptr;
    weigh(&mass, kWater, kAlongZ, dReal(r1), dReal(r2), dReal(length));
    return create(space, dReal(r1), dReal(r2), dReal(length));
}

std::vector<dReal> triangles_of(dGeomID geom)
{
    const auto get = find<GetTriangles>("dGeomGetTriangles");
    std::vector<dReal> out;
    if (!get) return out;
    const int count = get(geom, kSegments, nullptr, 0);
    out.resize(9 * std::size_t(count));
    get(geom, kSegments, out.data(), count);
    return out;
}

bool add_water(dWorldID world)
{
    const auto create = find<CreateFluid>("dFluidCreate");
    return create && create(world);
}

bool has_step_fast() { return fast_function() != nullptr; }

int step_fast(dWorldID world, dReal dt, int substeps)
{
    return has_step_fast() ? fast_function()(world, dt, substeps) : 0;
}

bool has_step_hybrid() { return find<Step>("dWorldStepHybrid") != nullptr; }

int step_hybrid(dWorldID world, dReal dt, int substeps)
{
    static const Step function = find<Step>("dWorldStepHybrid");
    static const SetMode set_substeps = find<SetMode>("dWorldSetHybridSubsteps");
    if (!function || !set_substeps) return 0;
    set_substeps(world, substeps);
    return function(world, dt);
}

bool has_world_contacts() { return find<SetSpace>("dWorldSetContactSpace") != nullptr; }

void set_contact_space(dWorldID world, dSpaceID space)
{
    static const SetSpace function = find<SetSpace>("dWorldSetContactSpace");
    if (function) function(world, space);
}

void set_material(dGeomID geom, const dSurfaceParameters& surface)
{
    static const GetMaterial get = find<GetMaterial>("dGeomGetMaterial");
    static const SetMaterial set = find<SetMaterial>("dGeomSetMaterial");
    RawMaterial material{};
    material.struct_size = sizeof material;
    if (!get || !set || !get(geom, &material)) return;
    material.friction = surface.mu;
    if (surface.mode & dContactBounce) {
        material.bounce = surface.bounce;
        material.bounce_speed = surface.bounce_vel;
    }
    set(geom, &material);
}

std::vector<WorldContact> world_contacts(dWorldID world)
{
    static const GetContacts function = find<GetContacts>("dWorldGetContacts");
    if (!function) return {};
    std::vector<RawContact> raw(size_t(function(world, nullptr, 0)));
    function(world, raw.data(), int(raw.size()));
    std::vector<WorldContact> contacts;
    contacts.reserve(raw.size());
    for (const RawContact& from : raw) {
        WorldContact& to = contacts.emplace_back();
        to.geom1 = from.g1;
        to.geom2 = from.g2;
        to.depth = double(from.depth);
        to.normal_force = double(from.normal_force);
        for (int k = 0; k < 3; ++k) {
            to.pos[k] = double(from.pos[k]);
            to.normal[k] = double(from.normal[k]);
            to.friction_force[k] = double(from.friction_force[k]);
        }
    }
    return contacts;
}

bool set_exact_rotation(dWorldID world, bool on)
{
    static const SetMode function = find<SetMode>("dWorldSetExactRotation");
    if (!function) return false;
    function(world, on ? 1 : 0);
    return true;
}

bool set_exact_substeps(dWorldID world, int parts)
{
    static const SetMode function = find<SetMode>("dWorldSetExactSubsteps");
    if (!function) return false;
    function(world, parts);
    return true;
}

bool has_step_threads() { return find<SetMode>("dWorldSetStepThreads") != nullptr; }

bool set_step_threads(dWorldID world, int threads)
{
    static const SetMode function = find<SetMode>("dWorldSetStepThreads");
    if (!function) return false;
    function(world, threads);
    return true;
}

bool request_step_report(dWorldID world, bool on)
{
    static const SetMode function = find<SetMode>("dWorldSetStepReportMode");
    if (!function) return false;
    function(world, on ? 1 : 0);
    return true;
}

std::optional<StepReport> step_report(dWorldID world)
{
    static const GetReport function = find<GetReport>("dWorldGetStepReport");
    if (!function) return std::nullopt;
    RawStepReport raw{};
    raw.struct_size = sizeof raw;
    if (!function(world, &raw)) return std::nullopt;
    StepReport report;
    report.residual = raw.residual;
    report.islands = raw.islands;
    report.bodies = raw.bodies;
    report.joints = raw.joints;
    report.rows = raw.rows;
    report.iterations = raw.iterations;
    report.fallbacks = raw.fallbacks;
    report.contained_islands = raw.contained_islands;
    return report;
}

bool set_diagnosis(dWorldID world, bool on)
{
    static const SetMode function = find<SetMode>("dWorldSetDiagnosisMode");
    if (!function) return false;
    function(world, on ? 1 : 0);
    return true;
}

std::vector<Accusation> diagnosis(dWorldID world, std::size_t max_count)
{
    static const Diagnose diagnose = find<Diagnose>("dWorldDiagnose");
    static const DiagnosisText describe = find<DiagnosisText>("dDiagnosisText");
    if (!diagnose || !describe) return {};
    std::vector<RawDiagnosis> causes(max_count);
    const int found = diagnose(world, causes.data(), int(max_count));
    causes.resize(std::min(max_count, std::size_t(found)));
    std::vector<Accusation> list;
    for (const RawDiagnosis& cause : causes) {
        char text[512];
        describe(&cause, text, sizeof text);
        list.push_back({cause.severity, dBodyID(cause.objects[0]), dBodyID(cause.objects[1]), text});
    }
    return list;
}

bool set_warm_starting(dWorldID world, double factor)
{
    static const SetWarmStarting function = find<SetWarmStarting>("dWorldSetStepWarmStarting");
    if (!function) return false;
    function(world, dReal(factor));
    return true;
}

bool set_step_projection(dWorldID world, int iterations)
{
    static const SetMode function = find<SetMode>("dWorldSetStepProjection");
    if (!function) return false;
    function(world, iterations);
    return true;
}

const char* loaded_library_kind() { return has_world_contacts() ? "Epode" : "ODE"; }

bool has_world_files() { return find<void*>("dWorldSave") != nullptr; }

bool save_world(dWorldID world, dSpaceID space, const std::string& path)
{
    using Save = int (*)(dWorldID, dSpaceID, const char*);
    static const Save save = find<Save>("dWorldSave");
    return save && save(world, space, path.c_str()) == 1;
}

dWorldID load_world(const std::string& path, dSpaceID& space)
{
    using Load = dWorldID (*)(const char*, dSpaceID*);
    static const Load load = find<Load>("dWorldLoad");
    return load ? load(path.c_str(), &space) : nullptr;
}

dSpaceID contact_space(dWorldID world)
{
    using GetSpace = dSpaceID (*)(dWorldID);
    static const GetSpace get = find<GetSpace>("dWorldGetContactSpace");
    return get ? get(world) : nullptr;
}

std::vector<dBodyID> bodies_of(dWorldID world)
{
    using GetBodies = int (*)(dWorldID, dBodyID*, int);
    static const GetBodies get = find<GetBodies>("dWorldGetBodies");
    std::vector<dBodyID> bodies(get ? std::size_t(get(world, nullptr, 0)) : 0);
    if (get) get(world, bodies.data(), int(bodies.size()));
    return bodies;
}

int joint_count(dWorldID world)
{
    using GetJoints = int (*)(dWorldID, dJointID*, int);
    static const GetJoints get = find<GetJoints>("dWorldGetJoints");
    return get ? get(world, nullptr, 0) : 0;
}

std::string loaded_library()
{
    std::ifstream maps("/proc/self/maps");
    for (std::string line; std::getline(maps, line);) {
        const size_t path = line.find('/');
        if (path != std::string::npos && line.find("/libode", path) != std::string::npos)
            return line.substr(path);
    }
    return "statically linked";
}

}  // namespace epode::scenes
