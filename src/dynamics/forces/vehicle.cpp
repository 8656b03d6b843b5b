// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Settings and memory of vehicles: checks, birth and death, bytes of states and files.
#include "dynamics/forces/vehicle.h"

#include <algorithm>
#include <iterator>
#include <new>

#include "base/check.h"
#include "base/memory.h"
#include "base/objects/structure_edition.h"
#include "base/streams/state_stream.h"
#include "base/streams/structure_stream.h"

namespace epode {
namespace {

static_assert(std::size(dVehicleSettings{}.engine_speeds) == dVehicleMaxTorquePoints &&
              std::size(dVehicleSettings{}.engine_torques) == dVehicleMaxTorquePoints &&
              std::size(dVehicleSettings{}.gear_ratios) == dVehicleMaxGears);

constexpr Real kAny = Real(1e12), kUsualLength = Real(1e6), kMostSteer = Real(1.4);

enum Limit { kFromZero, kAboveZero };

// A number of a structure, and what it may be.
template <typename S>
struct Range {
    Real S::*number;
    Limit limit;
    Real high;
    const char* text;
};

template <typename S, std::size_t kCount>
const char* fault_among(const S& s, const Range<S> (&ranges)[kCount])
{
    for (const Range<S>& range : ranges) {
        const Real x = s.*range.number;
        if (!usable(x) || x > range.high || (range.limit == kAboveZero ? !(x > 0) : x < 0)) return range.text;
    }
    return nullptr;
}

using VS = dVehicleSettings;
constexpr Range<VS> kVehicleRanges[] = {
    {&VS::engine_inertia, kAboveZero, kAny, "engine_inertia (accepted: above 0, at most 1e12 kg m^2)"},
    {&VS::engine_drag, kFromZero, kAny, "engine_drag (accepted: 0 ... 1e12 N m)"},
    {&VS::idle_speed, kFromZero, kAny, "idle_speed (accepted: 0 ... 1e12 rad/s)"},
    {&VS::reverse_ratio, kAboveZero, kUsualLength, "reverse_ratio (accepted: above 0, at most 1e6)"},
    {&VS::final_ratio, kAboveZero, kUsualLength, "final_ratio (accepted: above 0, at most 1e6)"},
    {&VS::shift_time, kFromZero, kUsualLength, "shift_time (accepted: 0 ... 1e6 s)"},
    {&VS::shift_up_speed, kFromZero, kAny, "shift_up_speed (accepted: 0 ... 1e12 rad/s)"},
    {&VS::shift_down_speed, kFromZero, kAny, "shift_down_speed (accepted: 0 ... 1e12 rad/s)"},
    {&VS::clutch_torque, kFromZero, kAny, "clutch_torque (accepted: 0 ... 1e12 N m)"},
    {&VS::lock_torque, kFromZero, kAny, "lock_torque (accepted: 0 ... 1e12 N m)"},
    {&VS::centre_lock_torque, kFromZero, kAny, "centre_lock_torque (accepted: 0 ... 1e12 N m)"},
    {&VS::max_steer, kFromZero, kMostSteer, "max_steer (accepted: 0 ... 1.4 rad)"},
    {&VS::steer_speed, kAboveZero, kAny, "steer_speed (accepted: above 0, at most 1e12 rad/s)"},
    {&VS::ackermann, kFromZero, 1, "ackermann (accepted: 0 ... 1)"},
    {&VS::drag, kFromZero, kAny, "drag (accepted: 0 ... 1e12 N s^2/m^2)"},
    {&VS::downforce, kFromZero, kAny, "downforce (accepted: 0 ... 1e12 N s^2/m^2)"},
    {&VS::lean_frequency, kFromZero, Real(1e3), "lean_frequency (accepted: 0 ... 1000 rad/s)"},
    {&VS::lean_limit, kFromZero, kMostSteer, "lean_limit (accepted: 0 ... 1.4 rad)"}};

using VW = dVehicleWheel;
constexpr Range<VW> kWheelRanges[] = {
    {&VW::radius, kAboveZero, kUsualLength, "radius (accepted: above 0, at most 1e6 m)"},
    {&VW::width, kAboveZero, kUsualLength, "width (accepted: above 0, at most 1e6 m)"},
    {&VW::inertia, kAboveZero, kAny, "inertia (accepted: above 0, at most 1e12 kg m^2)"},
    {&VW::travel, kFromZero, kUsualLength, "travel (accepted: 0 ... 1e6 m)"},
    {&VW::preload, kFromZero, kAny, "preload (accepted: 0 ... 1e12 N)"},
    {&VW::stiffness, kFromZero, kAny, "stiffness (accepted: 0 ... 1e12 N/m)"},
    {&VW::bump_damping, kFromZero, kAny, "bump_damping (accepted: 0 ... 1e12 N s/m)"},
    {&VW::rebound_damping, kFromZero, kAny, "rebound_damping (accepted: 0 ... 1e12 N s/m)"},
    {&VW::stop_stiffness, kFromZero, kAny, "stop_stiffness (accepted: 0 ... 1e12 N/m)"},
    {&VW::anti_roll, kFromZero, kAny, "anti_roll (accepted: 0 ... 1e12 N/m)"},
    {&VW::roll_centre, kFromZero, kUsualLength, "roll_centre (accepted: 0 ... 1e6 m)"},
    {&VW::friction_x, kAboveZero, Real(1e3), "friction_x (accepted: above 0, at most 1000)"},
    {&VW::friction_y, kAboveZero, Real(1e3), "friction_y (accepted: above 0, at most 1000)"},
    {&VW::stiffness_x, kAboveZero, kUsualLength, "stiffness_x (accepted: above 0, at most 1e6)"},
    {&VW::stiffness_y, kAboveZero, kUsualLength, "stiffness_y (accepted: above 0, at most 1e6)"},
    {&VW::sliding, kFromZero, 1, "sliding (accepted: 0 ... 1)"},
    {&VW::nominal_load, kAboveZero, kAny, "nominal_load (accepted: above 0, at most 1e12 N)"},
    {&VW::load_sensitivity, kFromZero, 1, "load_sensitivity (accepted: 0 ... 1)"},
    {&VW::relaxation, kAboveZero, kUsualLength, "relaxation (accepted: above 0, at most 1e6 m)"},
    {&VW::rolling_resistance, kFromZero, Real(1e3), "rolling_resistance (accepted: 0 ... 1000)"},
    {&VW::drive, kFromZero, kUsualLength, "drive (accepted: 0 ... 1e6)"},
    {&VW::brake_torque, kFromZero, kAny, "brake_torque (accepted: 0 ... 1e12 N m)"},
    {&VW::handbrake_torque, kFromZero, kAny, "handbrake_torque (accepted: 0 ... 1e12 N m)"}};

using VC = dVehicleControls;
constexpr Range<VC> kControlRanges[] = {{&VC::throttle, kFromZero, 1, "throttle (accepted: 0 ... 1)"},
                                        {&VC::brake, kFromZero, 1, "brake (accepted: 0 ... 1)"},
                                        {&VC::handbrake, kFromZero, 1, "handbrake (accepted: 0 ... 1)"},
                                        {&VC::clutch, kFromZero, 1, "clutch (accepted: 0 ... 1)"}};

bool is_differential(int d) { return d >= dDifferentialOpen && d <= dDifferentialLocked; }
bool is_switch(int flag) { return flag == 0 || flag == 1; }

bool are_directions(const dVehicleSettings& s)
{
    if (!usable(s.forward, 3) || !usable(s.up, 3)) return false;
    Vec3 forward = load(s.forward), up = load(s.up);
    return normalize(forward) && normalize(up) && length(cross(forward, up)) > Real(1e-3);
}

const char* fault_of_engine(const dVehicleSettings& s)
{
    if (s.torque_points < 2 || s.torque_points > dVehicleMaxTorquePoints)
        return "torque_points (accepted: 2 ... 16)";
    Real before = -1;
    for (int i = 0; i < s.torque_points; ++i) {
        const Real speed = s.engine_speeds[i], torque = s.engine_torques[i];
        if (!usable(speed) || speed > kAny || !(speed > before))
            return "engine_speeds (accepted: 0 ... 1e12 rad/s, each above the one before)";
        if (!usable(torque) || torque < 0 || torque > kAny)
            return "engine_torques (accepted: 0 ... 1e12 N m)";
        before = speed;
    }
    return nullptr;
}

const char* fault_of_gears(const dVehicleSettings& s)
{
    if (s.gears < 1 || s.gears > dVehicleMaxGears) return "gears (accepted: 1 ... 10)";
    for (int i = 0; i < s.gears; ++i)
        if (!usable(s.gear_ratios[i]) || !(s.gear_ratios[i] > 0) || s.gear_ratios[i] > kUsualLength)
            return "gear_ratios (accepted: above 0, at most 1e6)";
    return nullptr;
}

}  // namespace

const dVehicleSettings kDefaultVehicle = {
    .struct_size = sizeof(dVehicleSettings),
    .kind = dVehicleCar,
    .forward = {1, 0, 0},
    .up = {0, 0, 1},
    .torque_points = 5,
    .engine_speeds = {0, 150, 350, 550, 650},
    .engine_torques = {120, 220, 300, 280, 240},
    .engine_inertia = Real(0.2),
    .engine_drag = 60,
    .idle_speed = 90,
    .automatic = 1,
    .gears = 5,
    .gear_ratios = {Real(3.5), Real(2.1), Real(1.45), Real(1.1), Real(0.9)},
    .reverse_ratio = Real(3.3),
    .final_ratio = Real(3.8),
    .shift_time = Real(0.2),
    .shift_up_speed = 580,
    .shift_down_speed = 230,
    .clutch_torque = 700,
    .differential = dDifferentialOpen,
    .lock_torque = 200,
    .centre_differential = dDifferentialOpen,
    .centre_lock_torque = 200,
    .max_steer = Real(0.6),
    .steer_speed = 2,
    .ackermann = 1,
    .drag = Real(0.4),
    .downforce = 0,
    .abs = 0,
    .lean_frequency = 8,
    .lean_limit = Real(0.9),
    .category_bits = ~0ul,
    .collide_bits = ~0ul};

const dVehicleWheel kDefaultWheel = {.struct_size = sizeof(dVehicleWheel),
                                     .cast = dWheelRay,
                                     .position = {0, 0, 0},
                                     .radius = Real(0.33),
                                     .width = Real(0.2),
                                     .inertia = 1,
                                     .axle = 0,
                                     .travel = Real(0.25),
                                     .preload = 0,
                                     .stiffness = 30000,
                                     .bump_damping = 3000,
                                     .rebound_damping = 3000,
                                     .stop_stiffness = 300000,
                                     .anti_roll = 0,
                                     .roll_centre = 0,
                                     .friction_x = Real(1.1),
                                     .friction_y = 1,
                                     .stiffness_x = 18,
                                     .stiffness_y = 14,
                                     .sliding = Real(0.8),
                                     .nominal_load = 4000,
                                     .load_sensitivity = Real(0.05),
                                     .relaxation = Real(0.3),
                                     .rolling_resistance = Real(0.012),
                                     .steer = 0,
                                     .drive = 0,
                                     .brake_torque = 1500,
                                     .handbrake_torque = 0};

const char* fault_of(const dVehicleSettings& s)
{
    if (s.kind < dVehicleCar || s.kind > dVehicleTracked)
        return "kind (accepted: dVehicleCar, dVehicleBike, dVehicleTracked)";
    if (!are_directions(s)) return "forward, up (accepted: finite, of any length but 0, not parallel)";
    if (const char* wrong = fault_of_engine(s)) return wrong;
    if (const char* wrong = fault_of_gears(s)) return wrong;
    if (!is_switch(s.automatic)) return "automatic (accepted: 0, 1)";
    if (!is_switch(s.abs)) return "abs (accepted: 0, 1)";
    if (!is_differential(s.differential) || !is_differential(s.centre_differential))
        return "a differential (accepted: dDifferentialOpen, dDifferentialLimited, dDifferentialLocked)";
    return fault_among(s, kVehicleRanges);
}

const char* fault_of(const dVehicleWheel& w)
{
    if (w.cast < dWheelRay || w.cast > dWheelCylinder)
        return "cast (accepted: dWheelRay, dWheelSphere, dWheelCylinder)";
    for (int i = 0; i < 3; ++i)
        if (!within(w.position[i], kUsualLength)) return "position (accepted: at most 1e6 m)";
    if (w.axle < 0 || w.axle >= dVehicleMaxWheels) return "axle (accepted: 0 ... 31)";
    if (!within(w.steer, 1)) return "steer (accepted: -1 ... 1)";
    return fault_among(w, kWheelRanges);
}

const char* fault_of(const dVehicleControls& c)
{
    if (!within(c.steer, 1)) return "steer (accepted: -1 ... 1)";
    return fault_among(c, kControlRanges);
}

const char* fault_of_axle(const Vehicle& vehicle, const dVehicleWheel& wheel, int i)
{
    if (vehicle.settings.kind != dVehicleCar) return nullptr;
    int others = 0;
    for (int k = 0; k < vehicle.wheel_count; ++k)
        others += k != i && vehicle.wheels[k].settings.axle == wheel.axle;
    return others < 2 ? nullptr : "axle (accepted: one with less than two wheels)";
}

bool make_vehicle(Body& body, const dVehicleSettings& settings)
{
    void* const memory = allocate(sizeof(Vehicle));
    if (!memory) return false;
    body.vehicle = new (memory) Vehicle;
    body.vehicle->settings = settings;
    body.vehicle->engine_speed = settings.idle_speed;
    note_structure_changed();
    return true;
}

void drop_vehicle(Body& body)
{
    if (body.vehicle) release(body.vehicle, sizeof(Vehicle));
    body.vehicle = nullptr;
}

// ---- clones and files ----

namespace {

template <typename S, std::size_t kCount>
void visit_ranges(S& s, const Range<S> (&ranges)[kCount], StructureStream& stream)
{
    for (const Range<S>& range : ranges) stream.real(s.*range.number);
}

void visit_settings(dVehicleSettings& s, StructureStream& stream)
{
    for (int* number :
         {&s.kind, &s.torque_points, &s.automatic, &s.gears, &s.differential, &s.centre_differential, &s.abs})
        stream.number(*number);
    stream.reals(s.forward, 3), stream.reals(s.up, 3);
    stream.reals(s.engine_speeds, dVehicleMaxTorquePoints);
    stream.reals(s.engine_torques, dVehicleMaxTorquePoints);
    stream.reals(s.gear_ratios, dVehicleMaxGears);
    visit_ranges(s, kVehicleRanges, stream);
    std::uint64_t category = s.category_bits, collide = s.collide_bits;
    stream.number(category), stream.number(collide);
    s.category_bits = static_cast<unsigned long>(category),
    s.collide_bits = static_cast<unsigned long>(collide);
    s.struct_size = sizeof s;
}

void visit_wheel(dVehicleWheel& w, StructureStream& stream)
{
    stream.number(w.cast), stream.number(w.axle);
    stream.reals(w.position, 3), stream.real(w.steer);
    visit_ranges(w, kWheelRanges, stream);
    w.struct_size = sizeof w;
}

constexpr const char* kBadVehicle = "a vehicle in it has settings or wheels that it cannot have";

// Unused elements of arrays may be anything in the program's structure, and nothing that a file takes.
dVehicleSettings without_unused(const dVehicleSettings& given)
{
    dVehicleSettings s = given;
    for (int i = s.torque_points; i < dVehicleMaxTorquePoints; ++i)
        s.engine_speeds[i] = s.engine_torques[i] = 0;
    for (int i = s.gears; i < dVehicleMaxGears; ++i) s.gear_ratios[i] = 0;
    return s;
}

}  // namespace

void structure_of_vehicle(Body& body, StructureStream& stream)
{
    dVehicleSettings settings = stream.saves() ? without_unused(body.vehicle->settings) : kDefaultVehicle;
    visit_settings(settings, stream);
    if (!stream.demand(!fault_of(settings), kBadVehicle)) return;
    if (stream.loads() && !stream.demand(body.vehicle || make_vehicle(body, settings), kOutOfMemory)) return;
    Vehicle& vehicle = *body.vehicle;
    int count = vehicle.wheel_count;
    stream.number(count, 0, dVehicleMaxWheels + 1, kBadVehicle);
    for (int i = 0; i < count && !stream.failed(); ++i) {
        dVehicleWheel wheel = stream.saves() ? vehicle.wheels[i].settings : kDefaultWheel;
        visit_wheel(wheel, stream);
        if (stream.saves()) continue;
        if (!stream.demand(!fault_of(wheel) && !fault_of_axle(vehicle, wheel, i), kBadVehicle)) return;
        vehicle.wheels[i].settings = wheel, vehicle.wheel_count = i + 1;
    }
}

// ---- states ----

namespace {

void state_of_wheel(VehicleWheel& w, StateStream& stream)
{
    for (Real* number : {&w.spin, &w.angle, &w.steer, &w.compression, &w.bristle_x, &w.bristle_y, &w.load,
                         &w.force_x, &w.force_y, &w.slip_ratio, &w.slip_angle, &w.slip})
        stream.reals(number, 1);
    stream.reals(&w.ground_pos.x, 3), stream.reals(&w.ground_normal.x, 3);
    w.ground_pose = stream.long_word(w.ground_pose);
    w.ground_side = int(stream.word(std::uint32_t(w.ground_side)));
    w.on_ground =
        stream.index(w.on_ground, 2, "a wheel of the state is on the ground in an unknown way") != 0;
}

void state_of_controls(dVehicleControls& c, StateStream& stream)
{
    for (Real* number : {&c.throttle, &c.brake, &c.handbrake, &c.steer, &c.clutch}) {
        stream.reals(number, 1);
        if (stream.stores()) *number = std::clamp(*number, Real(number == &c.steer ? -1 : 0), Real(1));
    }
}

}  // namespace

void state_of_vehicle(Vehicle& vehicle, StateStream& stream)
{
    constexpr const char* kAnother = "a vehicle of the state has more or fewer wheels than in the world";
    constexpr const char* kBad = "a vehicle of the state is in a gear that it does not have";
    Vehicle v = vehicle;
    const auto count = std::uint32_t(v.wheel_count);
    if (!stream.demand(stream.word(count) == count, kAnother)) return;
    state_of_controls(v.controls, stream);
    for (Real* number : {&v.engine_speed, &v.engine_torque, &v.clutch_torque, &v.steer, &v.speed, &v.lean,
                         &v.curvature, &v.shift_left})
        stream.reals(number, 1);
    const std::uint32_t bits = stream.word(std::uint32_t(v.gear + 1) | std::uint32_t(v.stands) << 8);
    v.gear = int(bits & 255) - 1, v.stands = bits >> 8 & 1;
    if (!stream.demand(bits < 512 && v.gear <= v.settings.gears, kBad)) return;
    for (VehicleWheel& wheel : v.all_wheels()) state_of_wheel(wheel, stream);
    if (!stream.stores()) return;
    for (int i = 0; i < v.wheel_count; ++i) v.wheels[i].ground = vehicle.wheels[i].ground;
    vehicle = v;
}

}  // namespace epode
