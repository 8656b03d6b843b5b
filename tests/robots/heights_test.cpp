// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// MJCF's height fields: where rays meet them, also of fields that stand anyhow; where balls come to rest; files of both kinds, and files that
// are none.
#include <gtest/gtest.h>
#include <ode/ext.h>

#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <random>

#include "png_files.h"
#include "robots/build.h"
#include "robots/load.h"
#include "robots/write/write.h"
#include "same_model.h"

namespace {

using namespace epode::robots;
namespace fs = std::filesystem;

constexpr bool kSingle = sizeof(dReal) == 4;
constexpr double kNear = kSingle ? 1e-5 : 1e-12;

std::string with_field(const std::string& asset, const std::string& geom = "", const std::string& more = "")
{
    return "<mujoco><compiler angle='radian'/><asset>\n<hfield name='h' " + asset +
           "/></asset><worldbody>\n<geom type='hfield' hfield='h' " + geom + "/>" + more +
           "</worldbody></mujoco>";
}

std::string list_of(const std::vector<double>& values)
{
    std::string out;
    for (double value : values) out += std::to_string(value) + " ";
    return out;
}

// Texts run from the largest y down.
std::string elevation(int rows, int columns, const std::vector<double>& from_the_top)
{
    return "nrow='" + std::to_string(rows) + "' ncol='" + std::to_string(columns) + "' elevation='" +
           list_of(from_the_top) + "'";
}

struct Folder {
    Folder() { fs::create_directories(path); }
    ~Folder() { fs::remove_all(path); }
    fs::path path = fs::temp_directory_path() / ("epode_heights_" + std::to_string(std::random_device()()));
    std::string robot() const { return (path / "robot.xml").string(); }
    void write(const std::string& name, const std::string& bytes) const
    {
        std::ofstream(path / name, std::ios::binary) << bytes;
    }
};

std::string binary_field(std::int32_t rows, std::int32_t columns, const std::vector<float>& from_below)
{
    std::string out(8 + 4 * from_below.size(), '\0');
    std::memcpy(out.data(), &rows, 4), std::memcpy(out.data() + 4, &columns, 4);
    std::memcpy(out.data() + 8, from_below.data(), 4 * from_below.size());
    return out;
}

class Heights : public testing::Test {
  protected:
    Heights()
    {
        dInitODE2(0);
        world = dWorldCreate();
        space = dHashSpaceCreate(nullptr);
        dWorldSetGravity(world, 0, 0, dReal(-9.81));
        dWorldSetContactSpace(world, space);
    }
    ~Heights() override
    {
        robot.reset();
        dSpaceDestroy(space);
        dWorldDestroy(world);
        dCloseODE();
    }
    void load(const std::string& text, const std::string& path = "robot.xml", const LoadOptions& options = {})
    {
        robot.reset();
        model = load_robot_text(path, text, options);
        ASSERT_FALSE(model.has_errors()) << model.report[0].text;
        robot = std::make_unique<Robot>(std::make_shared<const Prepared>(model), world, space, Pose{},
                                        std::vector<double>());
    }
    // Where a ray from a point along a direction meets the first geom; -1: nowhere.
    double distance(Vec from, Vec along) const
    {
        const dGeomID ray = dCreateRay(nullptr, 100);
        dGeomRaySet(ray, dReal(from.x), dReal(from.y), dReal(from.z), dReal(along.x), dReal(along.y),
                    dReal(along.z));
        dGeomRaySetClosestHit(ray, 1);
        dContactGeom hit;
        const int hits = dCollide(ray, robot->geoms()[0], 1, &hit, sizeof hit);
        dGeomDestroy(ray);
        return hits ? double(hit.depth) : -1;
    }
    double height_at(double x, double y) const { return 50 - distance({x, y, 50}, {0, 0, -1}); }

    dWorldID world;
    dSpaceID space;
    RobotModel model;
    std::unique_ptr<Robot> robot;
};

// Two triangles a cell, which meet in the corners of the least and the largest x and y.
double between(const HeightField& field, double x, double y)
{
    const double u = (x + field.half_x) / (2 * field.half_x) * (field.columns - 1),
                 v = (y + field.half_y) / (2 * field.half_y) * (field.rows - 1);
    const int i = std::min(int(u), field.columns - 2), j = std::min(int(v), field.rows - 2);
    const auto at = [&](int row, int column) {
        return field.top * field.samples[size_t(row * field.columns + column)];
    };
    const double a = u - i, b = v - j, low = at(j, i), high = at(j + 1, i + 1);
    const double side = a > b ? at(j, i + 1) : at(j + 1, i);
    return a > b ? low + a * (side - low) + b * (high - side) : low + b * (side - low) + a * (high - side);
}

TEST_F(Heights, of_a_slope_are_those_of_the_text)
{
    // From 0 at x = -2 to 3 at x = 2, whatever y; samples of any scale.
    load(with_field("size='2 1 3 0.1' " + elevation(2, 3, {10, 15, 20, 10, 15, 20})));
    for (double x : {-1.9, -0.4, 0.0, 0.7, 1.9}) EXPECT_NEAR(height_at(x, 0.3), 3 * (x + 2) / 4, 10 * kNear);
    EXPECT_EQ(distance({2.1, 0, 50}, {0, 0, -1}), -1) << "outside of it is nothing";
}

TEST_F(Heights, of_texts_begin_at_the_largest_y)
{
    load(with_field("size='1 1 1 0.1' " + elevation(2, 2, {1, 1, 0, 0})));
    EXPECT_NEAR(height_at(0, 0.9), 0.95, 10 * kNear);
}

TEST_F(Heights, that_all_are_the_same_or_not_stated_are_0)
{
    load(with_field("size='1 1 1 0.1' " + elevation(2, 2, {7, 7, 7, 7})));
    EXPECT_NEAR(height_at(0.2, 0.3), 0, 10 * kNear);
    load(with_field("size='1 1 1 0.1' nrow='5' ncol='4'"));
    EXPECT_NEAR(height_at(0.2, 0.3), 0, 10 * kNear);
}

// Rays from above in the field's own frame, wherever that stands.
TEST_F(Heights, are_met_by_rays_wherever_the_field_stands)
{
    std::mt19937 random(5);
    std::uniform_real_distribution<double> any(0, 1);
    for (int i = 0; i < 10; ++i) {
        std::vector<double> samples(size_t(7 * 5));
        for (double& sample : samples) sample = any(random);
        load(with_field("size='2 3 0.8 0.1' " + elevation(7, 5, samples),
                        "pos='1 -2 0.5' euler='" + list_of({any(random), any(random), any(random)}) + "'"));
        const Pose pose = model.links[0].shapes[0].pose;
        for (int k = 0; k < 50; ++k) {
            const double x = 3.98 * (any(random) - 0.5), y = 5.98 * (any(random) - 0.5);
            const double found = 5 - distance(pose * Vec{x, y, 5}, rotate(pose.q, {0, 0, -1}));
            EXPECT_NEAR(found, between(model.fields[0], x, y), 100 * kNear) << x << " " << y;
        }
    }
}

TEST_F(Heights, have_the_box_of_their_size)
{
    load(with_field("size='2 3 0.8 0.1' " + elevation(2, 2, {0, 1, 0, 1}), "pos='1 0 5'"));
    dReal box[6];
    dGeomGetAABB(robot->geoms()[0], box);
    const double wanted[6] = {-1, 3, -3, 3, 5, 5.8};
    for (int i = 0; i < 6; ++i)
        if (i != 4) { EXPECT_NEAR(box[i], wanted[i], kSingle ? 1e-4 : 1e-9) << i; }
    EXPECT_LE(double(box[4]), 5 - 0.1 + kNear);
}

// A ball of radius R rests on the two sides of a right-angled valley, its centre sqrt(2) R above the bottom; on a plane R above.
TEST_F(Heights, hold_balls_at_rest)
{
    const std::string ball = "<body pos='0.3 0.2 1'><freejoint/><geom size='0.2'/></body>";
    load(with_field("size='1 1 1 0.1' " + elevation(2, 3, {1, 0, 1, 1, 0, 1}), "", ball));
    for (int i = 0; i < 3000; ++i) dWorldStep(world, dReal(0.002));
    const dReal* at = dBodyGetPosition(robot->body(1));
    EXPECT_NEAR(at[0], 0, 1e-3);
    EXPECT_NEAR(at[2], std::sqrt(2.0) * 0.2, 1e-3);
    load(with_field("size='1 1 1 0.1' nrow='3' ncol='3'", "pos='0 0 0.25'", ball));
    for (int i = 0; i < 1500; ++i) dWorldStep(world, dReal(0.002));
    EXPECT_NEAR(dBodyGetPosition(robot->body(1))[2], 0.45, 1e-3);
}

// Boxes, capsules, cylinders, ellipsoids and meshes touch them, too.
TEST_F(Heights, hold_every_kind_of_shape)
{
    for (const char* geom :
         {"type='box' size='0.1 0.1 0.2'", "type='capsule' size='0.1 0.1'", "type='cylinder' size='0.1 0.2'",
          "type='ellipsoid' size='0.3 0.3 0.2'", "type='mesh' mesh='m'"}) {
        load(
            "<mujoco><asset><hfield name='h' size='1 1 1 0.1' nrow='9' ncol='9'/>"
            "<mesh name='m' vertex='-1 -1 -1 1 -1 -1 -1 1 -1 1 1 -1 -1 -1 1 1 -1 1 -1 1 1 1 1 1' scale='0.1 "
            "0.1 0.2'/></asset><worldbody><geom type='hfield' hfield='h'/><body pos='0.03 0.02 "
            "0.22'><freejoint/><geom " +
            std::string(geom) + "/></body></worldbody></mujoco>");
        for (int i = 0; i < 500; ++i) dWorldStep(world, dReal(0.002));
        EXPECT_NEAR(dBodyGetPosition(robot->body(1))[2], 0.2, 2e-3) << geom;
    }
}

TEST_F(Heights, stand_on_static_bodies_merged_or_not)
{
    const std::string text =
        "<mujoco><asset><hfield name='h' size='1 1 1 0.1' nrow='3' ncol='3'/></asset><worldbody>"
        "<body pos='0 0 2'><geom type='hfield' hfield='h' pos='0 0 0.5'/><geom type='hfield' hfield='h' "
        "pos='5 0 "
        "0'/></body></worldbody></mujoco>";
    LoadOptions apart;
    apart.keep_fixed = true;
    for (const LoadOptions& options : {LoadOptions(), apart}) {
        load(text, "robot.xml", options);
        EXPECT_NEAR(height_at(0.1, 0.2), 2.5, 10 * kNear);
        EXPECT_EQ(model.fields.size(), 1u);
        EXPECT_EQ(robot->geoms().size(), 2u);
    }
}

TEST_F(Heights, of_files_are_those_of_the_same_text)
{
    const Folder folder;
    folder.write("a.png", grey_png(3, 2, {0, 50, 100, 200, 150, 250}));
    folder.write("a.hf", binary_field(2, 3, {200, 150, 250, 0, 50, 100}));
    load(with_field("size='1 2 3 0.1' " + elevation(2, 3, {0, 50, 100, 200, 150, 250})));
    const HeightField wanted = model.fields[0];
    for (const std::string& file : {std::string("a.png"), std::string("a.hf")}) {
        load(with_field("size='1 2 3 0.1' file='" + file + "'"), folder.robot());
        ASSERT_EQ(model.fields[0].samples.size(), 6u);
        for (size_t i = 0; i < 6; ++i)
            EXPECT_NEAR(model.fields[0].samples[i], wanted.samples[i], 1e-12) << file << " " << i;
        EXPECT_TRUE(model.report.empty());
    }
}

TEST_F(Heights, are_written_and_read_again)
{
    const Folder folder;
    folder.write("a.png", grey_png(2, 2, {0, 50, 100, 200}));
    for (const std::string& asset : {elevation(3, 2, {0.1, 0.7, -0.3, 5, 2, 1}),
                                     std::string("nrow='4' ncol='3'"), std::string("file='a.png'")}) {
        load(with_field("size='1 2 3 0.1' " + asset, "pos='1 2 3' euler='0.1 0.2 0.3'"), folder.robot());
        const RobotModel again =
            load_robot_text(folder.robot(), write_mjcf(model, folder.path.string()).text);
        const std::vector<std::string> found = differences(model, again);
        EXPECT_TRUE(found.empty()) << found[0];
    }
    const WrittenRobot urdf = write_urdf(model, folder.path.string());
    EXPECT_NE(std::find(urdf.lost.begin(), urdf.lost.end(), "URDF has no height field"), urdf.lost.end());
}

void expect_error(const std::string& text, const std::string& path, const std::string& wanted)
{
    const RobotModel model = load_robot_text(path, text);
    ASSERT_TRUE(model.has_errors()) << wanted;
    const auto its = std::find_if(model.report.begin(), model.report.end(), [&](const ReportLine& line) {
        return line.note == Note::kError && line.text.find(wanted) != std::string::npos;
    });
    ASSERT_NE(its, model.report.end()) << "wanted '" << wanted << "', got: " << model.report[0].text;
    EXPECT_EQ(its->line, wanted.find("there is no") == 0 ? 3 : 2) << wanted;
    EXPECT_EQ(its->file, path);
}

TEST_F(Heights, that_are_none_are_errors_with_their_line)
{
    const std::pair<std::string, const char*> broken[] = {
        {"nrow='3' ncol='3'", "wants a size of four numbers"},
        {"size='1 1 1' nrow='3' ncol='3'", "size = '1 1 1', wanted 4 finite numbers"},
        {"size='1 1 1 0' nrow='3' ncol='3'", "size that is not positive"},
        {"size='-1 1 1 1' nrow='3' ncol='3'", "size that is not positive"},
        {"size='1 1 1 1'", "0 rows of 0 samples"},
        {"size='1 1 1 1' nrow='1' ncol='3'", "1 rows of 3 samples"},
        {"size='1 1 1 1' nrow='2.5' ncol='3'", "2.5 rows"},
        {"size='1 1 1 1' nrow='-3' ncol='-3'", "-3 rows"},
        {"size='1 1 1 1' nrow='1e300' ncol='1e300'", "1e+300 rows"},
        {"size='1 1 1 1' nrow='100000' ncol='100000'", "at most 16777216"},
        {"size='1 1 1 1' nrow='2' ncol='2' elevation='1 2 3'", "wanted 4 finite numbers"},
        {"size='1 1 1 1' nrow='2' ncol='2' elevation='1 2 3 nan'", "wanted 4 finite numbers"},
        {"size='1 1 1 1' file='nowhere.png'", "'nowhere.png' is not to be found"},
        {"size='1 1 1 1' file='../../../../../../etc/hostname'", "outside the folders that may be read"}};
    const Folder folder;
    for (const auto& [asset, wanted] : broken) expect_error(with_field(asset), folder.robot(), wanted);
    expect_error(
        with_field("size='1 1 1 1' nrow='2' ncol='2'", "hfield='other'")
            .replace(with_field("size='1 1 1 1' nrow='2' ncol='2'", "hfield='other'").find("hfield='h'"), 10,
                     ""),
        folder.robot(), "there is no height field 'other'");
}

// All fields of a robot together are no larger than one may be.
TEST_F(Heights, of_many_fields_are_limited_together)
{
    std::string assets, geoms;
    for (const char* name : {"a", "b"}) {
        assets += std::string("<hfield size='1 1 1 1' nrow='3000' ncol='3000' name='") + name + "'/>";
        geoms += std::string("<geom type='hfield' hfield='") + name + "'/>";
    }
    const RobotModel found = load_robot_text(
        "robot.xml", "<mujoco><asset>" + assets + "</asset><worldbody>" + geoms + "</worldbody></mujoco>");
    ASSERT_TRUE(found.has_errors());
    EXPECT_NE(found.report[0].text.find("is one too many"), std::string::npos) << found.report[0].text;
}

TEST_F(Heights, whose_files_lie_are_errors)
{
    const std::vector<float> four{1, 2, 3, 4};
    const std::string good = grey_png(2, 2, {1, 2, 3, 4});
    std::string wide = good, endless = good;
    wide[16] = '\x7f', endless.resize(45);
    const std::pair<std::string, std::string> files[] = {
        {"", "is too short"},
        {binary_field(2, 3, four), "has 24 bytes; its 2 rows of 3 samples take 32"},
        {binary_field(-2, -2, four), "-2 rows"},
        {binary_field(1 << 16, 1 << 16, four), "at most 16777216"},
        {binary_field(2, 2, {1, 2, NAN, 4}), "not finite"},
        {binary_field(2, 2, {1, 2, INFINITY, 4}), "not finite"}};
    const std::pair<std::string, std::string> pictures[] = {
        {"", "is no PNG"},
        {"nothing of the kind, though long enough", "is no PNG"},
        {wide, "2 rows of 2130706434 samples"},
        {endless, "is a broken PNG"}};
    const Folder folder;
    for (const auto& [bytes, wanted] : files) {
        folder.write("a.hf", bytes);
        expect_error(with_field("size='1 1 1 1' file='a.hf'"), folder.robot(), wanted);
    }
    for (const auto& [bytes, wanted] : pictures) {
        folder.write("a.png", bytes);
        expect_error(with_field("size='1 1 1 1' file='a.png'"), folder.robot(), wanted);
    }
}

}  // namespace
