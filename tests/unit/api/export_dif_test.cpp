// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What dWorldExportDIF writes beyond what Debian's library can be compared with: every type of joint, geoms
// that it has no words for, commas where Lua wants them, numbers that read back, refusals. (Values of the
// common part: tests/parity, dif_*.)
#include <gtest/gtest.h>

#include <algorithm>
#include <clocale>
#include <cmath>
#include <cstdlib>

#include "message_recorder.h"

#pragma GCC diagnostic ignored "-Wdeprecated-declarations"  // transforms are part of the interface

namespace {

std::string exported(dWorldID world, const char* prefix)
{
    FILE* file = std::tmpfile();
    if (!file) return "";
    dWorldExportDIF(world, file, prefix);
    std::rewind(file);
    std::string text;
    for (int c; (c = std::fgetc(file)) != EOF;) text += char(c);
    std::fclose(file);
    return text;
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

struct TwoBodies {
    dWorldID world = dWorldCreate();
    dBodyID a = dBodyCreate(world), b = dBodyCreate(world);
    TwoBodies() { dBodySetPosition(b, 1, 2, 3); }
    ~TwoBodies() { dWorldDestroy(world); }
};

// Every line of a table is a field with a comma, an opening or a closing; levels fit.
void expect_lua(const std::string& text)
{
    int depth = 0;
    std::size_t from = text.find('\n') + 1;
    for (std::size_t end; (end = text.find('\n', from)) != std::string::npos; from = end + 1) {
        std::string line = text.substr(from, end - from);
        const std::size_t first = line.find_first_not_of('\t');
        line = first == std::string::npos ? "" : line.substr(first);
        if (line.empty()) continue;
        if (line == "}" || line == "},") --depth;
        EXPECT_EQ(int(first), depth) << line;
        if (line.back() == '{') {
            ++depth;
        } else if (depth > 0) {
            EXPECT_EQ(line.back(), ',') << line;
        }
        EXPECT_EQ(std::count(line.begin(), line.end(), '{') - (line.back() == '{'),
                  std::count(line.begin(), line.end(), '}') - (line == "}" || line == "},"))
            << line;
    }
    EXPECT_EQ(depth, 0);
}

using Create = dJointID (*)(dWorldID, dJointGroupID);

TEST(ExportDif, every_type_of_joint_has_a_name_and_its_parts)
{
    const std::pair<Create, const char*> kinds[] = {
        {dJointCreateBall, "ball_joint"},
        {dJointCreateHinge, "hinge_joint"},
        {dJointCreateSlider, "slider_joint"},
        {dJointCreateUniversal, "universal_joint"},
        {dJointCreateHinge2, "ODE_hinge2_joint"},
        {dJointCreateFixed, "fixed_joint"},
        {dJointCreateNull, "null_joint"},
        {dJointCreateAMotor, "ODE_angular_motor_joint"},
        {dJointCreateLMotor, "ODE_linear_motor_joint"},
        {dJointCreatePlane2D, "ODE_plane2d_joint"},
        {dJointCreatePR, "PR_joint"},
        {dJointCreatePU, "PU_joint"},
        {dJointCreatePiston, "piston_joint"},
        {dJointCreateDBall, "double_ball_joint"},
        {dJointCreateDHinge, "double_hinge_joint"},
        {dJointCreateTransmission, "transmission_joint"},
    };
    for (const auto& [create, name] : kinds) {
        TwoBodies two;
        dJointAttach(create(two.world, nullptr), two.a, two.b);
        create(two.world, nullptr);  // without bodies
        const std::string text = exported(two.world, "p_");
        // Newest first: the second body is body 0.
        EXPECT_TRUE(has(text, std::string("p_joint[1] = dynamics.") + name +
                                  " {\n\tworld = p_world,\n"
                                  "\tbody = {p_body[1],p_body[0]},\n"))
            << text;
        EXPECT_TRUE(has(text, "\tbody = {},\n"));
        expect_lua(text);
    }
}

TEST(ExportDif, writes_what_the_original_has_no_words_for)
{
    TwoBodies two;
    const dJointID rod = dJointCreateDBall(two.world, nullptr);
    dJointAttach(rod, two.a, two.b);
    dJointSetDBallAnchor1(rod, 0, 0, 0);
    dJointSetDBallAnchor2(rod, 1, 2, 5);
    dJointSetDBallDistance(rod, 4);
    const dJointID gear = dJointCreateTransmission(two.world, nullptr);
    dJointAttach(gear, two.a, two.b);
    dJointSetTransmissionBacklash(gear, dReal(0.25));
    dBodySetKinematic(two.a);
    dBodyAddForce(two.b, 0, 2, 0);
    dContact contact{};
    contact.surface.mode = dContactRolling | dContactMotionN;
    contact.surface.mu = 1;
    contact.surface.rho = dReal(0.5);
    contact.surface.motionN = 3;
    contact.geom.normal[2] = 1;
    dJointAttach(dJointCreateContact(two.world, nullptr, &contact), two.a, nullptr);
    const dJointID fixed = dJointCreateFixed(two.world, nullptr);
    dJointAttach(fixed, two.a, two.b);
    dJointSetFixed(fixed);
    const dGeomID outer = dCreateGeomTransform(nullptr), inner = dCreateSphere(nullptr, 2);
    dGeomTransformSetGeom(outer, inner);
    dGeomTransformSetCleanup(outer, 1);
    dGeomSetBody(outer, two.b);
    const std::string text = exported(two.world, nullptr);
    expect_lua(text);
    EXPECT_TRUE(has(text, "\tanchor2 = {0,0,2},\n\tdistance = 4,\n"));
    EXPECT_TRUE(has(text, "\tbacklash = 0.25,\n"));
    EXPECT_TRUE(has(text, "\t\tkinematic = 1,\n"));
    EXPECT_TRUE(has(text, "\t\tfacc = {0,2,0},\n"));
    EXPECT_TRUE(has(text, "\trho = 0.5,\n\tmotionN = 3,\n"));
    EXPECT_TRUE(has(text, "\tqrel = {1,0,0,0},\n\toffset = {-1,-2,-3},\n"));
    EXPECT_TRUE(has(text,
                    "\t\t\ttype = \"transform\",\n\t\t\tgeom = {\n\t\t\t\ttype = \"sphere\",\n"
                    "\t\t\t\tradius = 2,\n\t\t\t},\n"));
    EXPECT_TRUE(has(text, "\nworld = dynamics.world {")) << "no prefix";
    dGeomDestroy(outer);
}

TEST(ExportDif, numbers_read_back_whatever_the_locale)
{
    TwoBodies two;
    const dReal x = dReal(1) / 3, y = dReal(-1e-7), z = dReal(12345678.5);
    dBodySetPosition(two.a, x, y, z);
    const char* const chosen = std::setlocale(LC_NUMERIC, "de_DE.UTF-8");
    const std::string text = exported(two.world, "");
    std::setlocale(LC_NUMERIC, "C");
    const std::string key = "body[1] = dynamics.body {\n\tworld = world,\n\tpos = {";
    ASSERT_TRUE(has(text, key)) << text << (chosen ? chosen : "no such locale here");
    const char* at = text.c_str() + text.find(key) + key.size();
    for (const dReal wanted : {x, y, z}) {
        char* end = nullptr;
        const double got = std::strtod(at, &end);
        ASSERT_NE(end, at);
        // 15 digits in double precision, all of a float in single.
        EXPECT_NEAR(dReal(got), wanted, sizeof(dReal) == 8 ? 1e-14 * std::fabs(wanted) : 0);
        at = end + 1;
    }
}

dWorldID g_world;
FILE* g_file;

TEST(ExportDif, refuses_bad_arguments_and_a_world_in_a_step)
{
    MessageRecorder messages;
    TwoBodies two;
    dWorldExportDIF(nullptr, stdout, "x");
    dWorldExportDIF(two.world, nullptr, "x");
    EXPECT_EQ(messages.take(),
              "2: Bad argument(s) in dWorldExportDIF()|2: Bad argument(s) in dWorldExportDIF()");
    g_world = two.world;
    g_file = std::tmpfile();
    ASSERT_TRUE(g_file);
    dBodySetMovedCallback(two.a, [](dBodyID) { dWorldExportDIF(g_world, g_file, ""); });
    EXPECT_EQ(dWorldStep(two.world, dReal(0.01)), 1);
    EXPECT_EQ(messages.take(), "2: Invalid operation during a step in dWorldExportDIF()");
    EXPECT_EQ(std::ftell(g_file), 0);
    std::fclose(g_file);
}

}  // namespace
