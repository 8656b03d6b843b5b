// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See every_joint.h. Each type is a place and a read function; the table at the foot names them. A reading
// of an index (motors have up to three axes) is written out axis by axis.
#include "every_joint.h"

namespace parity {
namespace {

using Get1 = dReal (*)(dJointID);

void put_numbers(Output& out, const std::string& key, dJointID joint, std::initializer_list<Get1> gets)
{
    std::vector<dReal> values;
    for (const Get1 get : gets) { values.push_back(get(joint)); }
    out.put(key, values.data(), static_cast<int>(values.size()));
}

void put_vectors(Output& out, const std::string& key, dJointID joint, std::initializer_list<Get3> gets)
{
    int i = 0;
    for (const Get3 get : gets) { put_vector(out, key + std::to_string(i++), joint, get); }
}

void place_nothing(dJointID, const JointPlace&) {}
void read_nothing(Output&, const std::string&, dJointID) {}

void place_ball(dJointID j, const JointPlace& a) { dJointSetBallAnchor(j, a.p.x, a.p.y, a.p.z); }
void read_ball(Output& out, const std::string& key, dJointID j)
{
    put_vectors(out, key + ".vector", j, {&dJointGetBallAnchor, &dJointGetBallAnchor2});
}

void place_hinge(dJointID j, const JointPlace& a)
{
    dJointSetHingeAnchor(j, a.p.x, a.p.y, a.p.z);
    dJointSetHingeAxis(j, a.n.x, a.n.y, a.n.z);
}
void read_hinge(Output& out, const std::string& key, dJointID j)
{
    put_vectors(out, key + ".vector", j,
                {&dJointGetHingeAnchor, &dJointGetHingeAnchor2, &dJointGetHingeAxis});
    put_numbers(out, key + ".angles", j, {&dJointGetHingeAngle});
    put_numbers(out, key + ".rates", j, {&dJointGetHingeAngleRate});
}

void place_slider(dJointID j, const JointPlace& a) { dJointSetSliderAxis(j, a.n.x, a.n.y, a.n.z); }
void read_slider(Output& out, const std::string& key, dJointID j)
{
    put_vectors(out, key + ".vector", j, {&dJointGetSliderAxis});
    put_numbers(out, key + ".slide", j, {&dJointGetSliderPosition});
    put_numbers(out, key + ".rates", j, {&dJointGetSliderPositionRate});
}

void place_universal(dJointID j, const JointPlace& a)
{
    dJointSetUniversalAnchor(j, a.p.x, a.p.y, a.p.z);
    dJointSetUniversalAxis1(j, a.n.x, a.n.y, a.n.z);
    dJointSetUniversalAxis2(j, a.m.x, a.m.y, a.m.z);
}
void read_universal(Output& out, const std::string& key, dJointID j)
{
    put_vectors(out, key + ".vector", j,
                {&dJointGetUniversalAnchor, &dJointGetUniversalAnchor2, &dJointGetUniversalAxis1,
                 &dJointGetUniversalAxis2});
    dReal both[2] = {0, 0};
    dJointGetUniversalAngles(j, &both[0], &both[1]);
    put_numbers(out, key + ".angles", j, {&dJointGetUniversalAngle1, &dJointGetUniversalAngle2});
    out.put(key + ".both.angles", both, 2);
    put_numbers(out, key + ".rates", j, {&dJointGetUniversalAngle1Rate, &dJointGetUniversalAngle2Rate});
}

void place_hinge2(dJointID j, const JointPlace& a)
{
    const dVector3 steering = {a.n.x, a.n.y, a.n.z, 0}, wheel = {a.m.x, a.m.y, a.m.z, 0};
    dJointSetHinge2Anchor(j, a.p.x, a.p.y, a.p.z);
    dJointSetHinge2Axes(j, steering, wheel);
}
void read_hinge2(Output& out, const std::string& key, dJointID j)
{
    put_vectors(
        out, key + ".vector", j,
        {&dJointGetHinge2Anchor, &dJointGetHinge2Anchor2, &dJointGetHinge2Axis1, &dJointGetHinge2Axis2});
    put_numbers(out, key + ".angles", j, {&dJointGetHinge2Angle1, &dJointGetHinge2Angle2});
    put_numbers(out, key + ".rates", j, {&dJointGetHinge2Angle1Rate, &dJointGetHinge2Angle2Rate});
}

void place_fixed(dJointID j, const JointPlace&) { dJointSetFixed(j); }

void place_amotor_user(dJointID j, const JointPlace& a)
{
    dJointSetAMotorMode(j, dAMotorUser);
    dJointSetAMotorNumAxes(j, 3);
    dJointSetAMotorAxis(j, 0, 0, a.n.x, a.n.y, a.n.z);
    dJointSetAMotorAxis(j, 1, 1, a.m.x, a.m.y, a.m.z);
    dJointSetAMotorAxis(j, 2, 2, a.s.x, a.s.y, a.s.z);
    dJointSetAMotorAngle(j, 0, 0.3);
    dJointSetAMotorAngle(j, 1, -0.4);
    dJointSetAMotorAngle(j, 2, 0.5);
}
void place_amotor_euler(dJointID j, const JointPlace& a)
{
    dJointSetAMotorMode(j, dAMotorEuler);
    dJointSetAMotorAxis(j, 0, 1, a.n.x, a.n.y, a.n.z);
    dJointSetAMotorAxis(j, 2, 2, a.k.x, a.k.y, a.k.z);
}
void read_amotor(Output& out, const std::string& key, dJointID j)
{
    out.put(key + ".modes",
            {static_cast<double>(dJointGetAMotorMode(j)), static_cast<double>(dJointGetAMotorNumAxes(j))});
    for (int i = 0; i < dJointGetAMotorNumAxes(j); ++i) {
        const std::string n = std::to_string(i);
        dVector3 axis = {0, 0, 0, 0};
        dJointGetAMotorAxis(j, i, axis);
        out.put(key + ".vector" + n, axis, 3);
        out.put(key + ".modes" + n, {static_cast<double>(dJointGetAMotorAxisRel(j, i))});
        out.put(key + n + ".angles", {dJointGetAMotorAngle(j, i)});
        out.put(key + n + ".rates", {dJointGetAMotorAngleRate(j, i)});
    }
}

void place_lmotor(dJointID j, const JointPlace& a)
{
    dJointSetLMotorNumAxes(j, 3);
    dJointSetLMotorAxis(j, 0, 0, a.n.x, a.n.y, a.n.z);
    dJointSetLMotorAxis(j, 1, 1, a.m.x, a.m.y, a.m.z);
    dJointSetLMotorAxis(j, 2, 2, a.s.x, a.s.y, a.s.z);
}
void read_lmotor(Output& out, const std::string& key, dJointID j)
{
    out.put(key + ".modes", {static_cast<double>(dJointGetLMotorNumAxes(j))});
    for (int i = 0; i < 3; ++i) {
        dVector3 axis = {0, 0, 0, 0};
        dJointGetLMotorAxis(j, i, axis);
        out.put(key + ".vector" + std::to_string(i), axis, 3);
    }
}

void place_pr(dJointID j, const JointPlace& a)
{
    dJointSetPRAnchor(j, a.p.x, a.p.y, a.p.z);
    dJointSetPRAxis1(j, a.n.x, a.n.y, a.n.z);
    dJointSetPRAxis2(j, a.m.x, a.m.y, a.m.z);
}
void read_pr(Output& out, const std::string& key, dJointID j)
{
    put_vectors(out, key + ".vector", j, {&dJointGetPRAnchor, &dJointGetPRAxis1, &dJointGetPRAxis2});
    put_numbers(out, key + ".slide", j, {&dJointGetPRPosition});
    put_numbers(out, key + ".angles", j, {&dJointGetPRAngle});
    put_numbers(out, key + ".rates", j, {&dJointGetPRAngleRate});
}

void place_pu(dJointID j, const JointPlace& a)
{
    dJointSetPUAnchor(j, a.p.x, a.p.y, a.p.z);
    dJointSetPUAxis1(j, a.n.x, a.n.y, a.n.z);
    dJointSetPUAxis2(j, a.m.x, a.m.y, a.m.z);
    dJointSetPUAxis3(j, a.s.x, a.s.y, a.s.z);
}
void read_pu(Output& out, const std::string& key, dJointID j)
{
    put_vectors(
        out, key + ".vector", j,
        {&dJointGetPUAnchor, &dJointGetPUAxis1, &dJointGetPUAxis2, &dJointGetPUAxis3, &dJointGetPUAxisP});
    put_numbers(out, key + ".slide", j, {&dJointGetPUPosition});
    dReal both[2] = {0, 0};
    dJointGetPUAngles(j, &both[0], &both[1]);
    put_numbers(out, key + ".angles", j, {&dJointGetPUAngle1, &dJointGetPUAngle2});
    out.put(key + ".both.angles", both, 2);
    put_numbers(out, key + ".rates", j, {&dJointGetPUAngle1Rate, &dJointGetPUAngle2Rate});
}

void place_piston(dJointID j, const JointPlace& a)
{
    dJointSetPistonAnchor(j, a.p.x, a.p.y, a.p.z);
    dJointSetPistonAxis(j, a.n.x, a.n.y, a.n.z);
}
void read_piston(Output& out, const std::string& key, dJointID j)
{
    put_vectors(out, key + ".vector", j,
                {&dJointGetPistonAnchor, &dJointGetPistonAnchor2, &dJointGetPistonAxis});
    put_numbers(out, key + ".slide", j, {&dJointGetPistonPosition});
    put_numbers(out, key + ".angles", j, {&dJointGetPistonAngle});
    put_numbers(out, key + ".rates", j, {&dJointGetPistonPositionRate, &dJointGetPistonAngleRate});
}

void place_dball(dJointID j, const JointPlace& a)
{
    dJointSetDBallAnchor1(j, a.p.x, a.p.y, a.p.z);
    dJointSetDBallAnchor2(j, a.p.x + a.n.x, a.p.y + a.n.y, a.p.z + a.n.z);
}
void read_dball(Output& out, const std::string& key, dJointID j)
{
    put_vectors(out, key + ".vector", j, {&dJointGetDBallAnchor1, &dJointGetDBallAnchor2});
    put_numbers(out, key + ".slide", j, {&dJointGetDBallDistance});
}

void place_dhinge(dJointID j, const JointPlace& a)
{
    dJointSetDHingeAxis(j, a.m.x, a.m.y, a.m.z);
    dJointSetDHingeAnchor1(j, a.p.x, a.p.y, a.p.z);
    dJointSetDHingeAnchor2(j, a.p.x + a.n.x, a.p.y + a.n.y, a.p.z + a.n.z);
}
void read_dhinge(Output& out, const std::string& key, dJointID j)
{
    put_vectors(out, key + ".vector", j,
                {&dJointGetDHingeAnchor1, &dJointGetDHingeAnchor2, &dJointGetDHingeAxis});
    put_numbers(out, key + ".slide", j, {&dJointGetDHingeDistance});
}

// Level anchors and true axes (differences.tsv, D36).
void place_transmission(dJointID j, const JointPlace& a)
{
    dJointSetTransmissionAxis(j, a.n.x, a.n.y, a.n.z);
    dJointSetTransmissionAnchor1(j, a.p.x, a.p.y, a.p.z);
    dJointSetTransmissionAnchor2(j, a.p.x + a.m.x, a.p.y + a.m.y, a.p.z + a.m.z);
    dJointSetTransmissionRatio(j, 1.5);
}
void read_transmission(Output& out, const std::string& key, dJointID j)
{
    put_vectors(out, key + ".vector", j,
                {&dJointGetTransmissionAnchor1, &dJointGetTransmissionAnchor2, &dJointGetTransmissionAxis1,
                 &dJointGetTransmissionAxis2});
    put_numbers(out, key + ".slide", j, {&dJointGetTransmissionRatio, &dJointGetTransmissionBacklash});
    out.put(key + ".modes", {static_cast<double>(dJointGetTransmissionMode(j))});
}

dJointID create_some_contact(dWorldID world, dJointGroupID group)
{
    dContact contact = dContact();
    contact.surface.mode = dContactApprox1;
    contact.surface.mu = 0.6;
    contact.geom.pos[0] = 0.2;
    contact.geom.pos[1] = -0.1;
    contact.geom.normal[2] = 1;
    contact.geom.depth = 0.01;
    return dJointCreateContact(world, group, &contact);
}

}  // namespace

JointPlace random_place(Random& random)
{
    JointPlace a;
    a.p = random.in_cube(1.0);
    a.n = random.direction();
    a.m = perpendicular_to(a.n, random);
    a.k = {a.n.y * a.m.z - a.n.z * a.m.y, a.n.z * a.m.x - a.n.x * a.m.z, a.n.x * a.m.y - a.n.y * a.m.x};
    a.s = random.direction();
    return a;
}

const std::vector<JointKind>& every_joint()
{
    static const std::vector<JointKind> kinds = {
        {"ball", dJointCreateBall, place_ball, read_ball, dJointSetBallParam, dJointGetBallParam, false,
         nullptr, nullptr},
        {"hinge", dJointCreateHinge, place_hinge, read_hinge, dJointSetHingeParam, dJointGetHingeParam, false,
         dJointGetHingeAxis, nullptr},
        {"slider", dJointCreateSlider, place_slider, read_slider, dJointSetSliderParam, dJointGetSliderParam,
         false, nullptr, nullptr},
        {"contact", create_some_contact, place_nothing, read_nothing, nullptr, nullptr, false, nullptr,
         nullptr},
        {"universal", dJointCreateUniversal, place_universal, read_universal, dJointSetUniversalParam,
         dJointGetUniversalParam, false, dJointGetUniversalAxis1, dJointGetUniversalAxis2},
        {"hinge2", dJointCreateHinge2, place_hinge2, read_hinge2, dJointSetHinge2Param, dJointGetHinge2Param,
         true, dJointGetHinge2Axis1, dJointGetHinge2Axis2},
        {"fixed", dJointCreateFixed, place_fixed, read_nothing, dJointSetFixedParam, dJointGetFixedParam,
         false, nullptr, nullptr},
        {"null", dJointCreateNull, place_nothing, read_nothing, nullptr, nullptr, false, nullptr, nullptr},
        {"amotor-user", dJointCreateAMotor, place_amotor_user, read_amotor, dJointSetAMotorParam,
         dJointGetAMotorParam, false, nullptr, nullptr},
        {"amotor-euler", dJointCreateAMotor, place_amotor_euler, read_amotor, dJointSetAMotorParam,
         dJointGetAMotorParam, false, nullptr, nullptr},
        {"lmotor", dJointCreateLMotor, place_lmotor, read_lmotor, dJointSetLMotorParam, dJointGetLMotorParam,
         false, nullptr, nullptr},
        {"plane2d", dJointCreatePlane2D, place_nothing, read_nothing, nullptr, nullptr, false, nullptr,
         nullptr},
        {"pr", dJointCreatePR, place_pr, read_pr, dJointSetPRParam, dJointGetPRParam, false, dJointGetPRAxis2,
         nullptr},
        {"pu", dJointCreatePU, place_pu, read_pu, dJointSetPUParam, dJointGetPUParam, false, dJointGetPUAxis1,
         dJointGetPUAxis2},
        {"piston", dJointCreatePiston, place_piston, read_piston, dJointSetPistonParam, dJointGetPistonParam,
         false, dJointGetPistonAxis, nullptr},
        {"dball", dJointCreateDBall, place_dball, read_dball, dJointSetDBallParam, dJointGetDBallParam, false,
         nullptr, nullptr},
        {"dhinge", dJointCreateDHinge, place_dhinge, read_dhinge, dJointSetDHingeParam, dJointGetDHingeParam,
         false, nullptr, nullptr},
        {"transmission", dJointCreateTransmission, place_transmission, read_transmission,
         dJointSetTransmissionParam, dJointGetTransmissionParam, true, nullptr, nullptr},
    };
    return kinds;
}

void place_at_random(const JointKind& kind, dJointID joint, Random& random)
{
    kind.place(joint, random_place(random));
}

const std::vector<Attach>& attachments_of(const JointKind& kind)
{
    static const std::vector<Attach> two = two_body_attachments(), all = all_attachments();
    return kind.two_bodies ? two : all;
}

}  // namespace parity
