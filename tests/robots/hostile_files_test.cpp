// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Files that are broken or mean harm: each is refused with its line and a reason, nothing outside the roots is read,
// and no mutation of a good file crashes. EPODE_ROBOT_MUTATIONS: how many of each file (scripts/nightly: 100,000 in all).
#include <epode/robots.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <random>

#include "glb_files.h"
#include "mutate.h"
#include "png_files.h"
#include "robots/build.h"
#include "robots/load.h"
#include "robots/write/write.h"
#include "tests/comma_locale.h"

namespace {

using namespace epode::robots;

const std::string kModels = EPODE_MODELS;

std::string errors_of(const RobotModel& model)
{
    std::string out;
    for (const ReportLine& line : model.report)
        if (line.note == Note::kError) out += std::to_string(line.line) + ": " + line.text + "\n";
    return out;
}

void expect_error(const std::string& text, const std::string& wanted, const LoadOptions& options = {})
{
    const std::string errors = errors_of(load_robot_text(kModels + "/text.xml", text, options));
    EXPECT_NE(errors.find(wanted), std::string::npos) << "wanted '" << wanted << "', got: " << errors;
}

std::string urdf(const std::string& inside) { return "<robot name='r'>\n" + inside + "</robot>"; }
const std::string kMass =
    "<inertial><mass value='1'/><inertia ixx='1' iyy='1' izz='1' ixy='0' ixz='0' iyz='0'/></inertial>";
std::string link(const std::string& name, const std::string& inside = kMass)
{
    return "<link name='" + name + "'>" + inside + "</link>\n";
}
std::string joint(const std::string& name, const std::string& parent, const std::string& child,
                  const std::string& more = "")
{
    return "<joint name='" + name + "' type='continuous'><parent link='" + parent + "'/><child link='" +
           child + "'/>" + more + "</joint>\n";
}

TEST(HostileFiles, broken_xml_is_refused_with_its_line)
{
    expect_error("<robot>\n<link", "at line 2");
    expect_error("", "No document element");
    expect_error("<other/>", "the root element is <other>");
}

// Found by the fuzzer: a radius of 1e120 m makes a mass beyond all numbers.
TEST(HostileFiles, masses_beyond_all_numbers_are_refused)
{
    LoadOptions from_shapes;
    from_shapes.inertia_from_shapes = from_shapes.repair = true;
    const std::string huge =
        "<collision><geometry><cylinder radius='1e120' length='1'/></geometry></collision>";
    expect_error(urdf(link("a") + link("b", huge) + joint("j", "a", "b")), "link 'b' has a number beyond 1e",
                 from_shapes);
    const std::string heavy =
        "<inertial><origin xyz='1e40 0 0'/><mass value='1e300'/><inertia ixx='1e300' iyy='1e300' izz='1e300' "
        "ixy='0' "
        "ixz='0' iyz='0'/></inertial>";
    expect_error(urdf(link("a") + link("b", heavy) + joint("j", "a", "b")), "link 'b' is beyond 1e");
}

// Of a value that is put in place of @.
void expect_sizes(const std::string& text, const std::string& wanted)
{
    const auto with = [&](const char* value) {
        std::string out = text;
        for (size_t at; (at = out.find('@')) != std::string::npos;) out.replace(at, 1, value);
        return errors_of(load_robot_text(kModels + "/text.xml", out));
    };
    EXPECT_EQ(with("1"), "") << text;
    for (const char* value : {"1e33", "1e101", "1e160", "1e308"})
        EXPECT_NE(with(value).find(wanted + " has a number beyond 1e"), std::string::npos)
            << value << " in " << text << " got: " << with(value);
}

TEST(HostileFiles, numbers_beyond_the_limit_are_refused_everywhere)
{
    const auto mjcf = [](const std::string& joint, const std::string& geom, const std::string& more) {
        return "<mujoco><worldbody><body name='b'><joint name='j' " + joint +
               "/><geom type='sphere' size='0.1' " + geom + "/><site name='s'/></body></worldbody>" + more +
               "</mujoco>";
    };
    const std::string motor = "<actuator><position name='m' joint='j' ";
    expect_sizes(
        "<mujoco><worldbody><body name='b' pos='@ 0 0'><joint/><geom type='sphere' size='0.1'/></body>"
        "</worldbody></mujoco>",
        "link 'b'");
    expect_sizes(mjcf("axis='0 1 0'", "pos='0 0 @'", ""), "link 'b'");
    for (const char* name : {"pos='0 0 @'", "stiffness='@'", "springref='@' stiffness='1'", "ref='@'"})
        expect_sizes(mjcf(name, "", ""), "joint 'j'");
    expect_sizes(mjcf("", "", motor + "kp='@'/></actuator>"), "actuator 'm'");
    expect_sizes(mjcf("", "", motor + "gear='@'/></actuator>"), "actuator 'm'");
    expect_sizes(mjcf("", "", "<option gravity='0 0 @'/>"), "gravity or the medium");
    expect_sizes(urdf(link("a") + link("b") + joint("j", "a", "b", "<origin xyz='0 @ 0'/>")), "link 'b'");
}

TEST(RobotFiles, limits_beyond_the_limit_of_numbers_are_none)
{
    const RobotModel model = load_robot_text(
        kModels + "/text.xml", urdf(link("a") + link("b") +
                                    "<joint name='j' type='revolute'><parent link='a'/><child link='b'/>"
                                    "<limit lower='-1e300' upper='1.7976931348623157e+308' effort='1e300' "
                                    "velocity='1e300'/></joint>"));
    EXPECT_EQ(errors_of(model), "");
    ASSERT_EQ(model.joints.size(), 2u);
    EXPECT_EQ(model.joints[1].low, -kInfinity);
    EXPECT_EQ(model.joints[1].high, kInfinity);
    EXPECT_EQ(model.joints[1].max_force, kInfinity);
}

TEST(HostileFiles, entities_are_refused)
{
    expect_error("<!DOCTYPE r [<!ENTITY a 'aaaa'><!ENTITY b '&a;&a;'>]><robot/>", "entities of its own");
}

TEST(HostileFiles, trees_that_are_none_are_refused)
{
    expect_error(urdf(link("a") + link("a")), "3: a second link 'a'");
    expect_error(urdf(link("a") + link("b")), "2 links that are nobody's child");
    expect_error(urdf(link("a") + joint("j", "a", "c")),
                 "3: joint 'j' names the link 'c', which is not there");
    expect_error(urdf(link("a") + link("b") + link("c") + joint("j", "b", "c") + joint("k", "c", "b")),
                 "no joint connects to the root 'a'");
    expect_error(urdf(link("a") + link("b") + joint("j", "a", "b") + joint("k", "a", "b")),
                 "child of two joints");
    expect_error(urdf(""), "0 links");
}

TEST(HostileFiles, numbers_that_are_none_are_refused)
{
    expect_error(urdf(link("a") + link("b") + joint("j", "a", "b", "<axis xyz='0 0 nan'/>")),
                 "4: axis xyz = '0 0 nan', wanted 3 finite numbers");
    expect_error(urdf(link("a") + link("b") + joint("j", "a", "b", "<axis xyz='0 0'/>")), "wanted 3");
    expect_error(urdf(link("a") + link("b") + joint("j", "a", "b", "<axis xyz='0 0 0'/>")),
                 "an axis of no usable length");
    expect_error(urdf(link("a") + link("b") + joint("j", "a", "b", "<dynamics damping='-1'/>")),
                 "negative damping");
    expect_error(urdf(link("a") + link("b") + joint("j", "a", "b", "<mimic joint='nobody'/>")),
                 "mimics 'nobody'");
}

TEST(HostileFiles, inertias_that_no_body_has_are_named_and_mended)
{
    const std::string bad =
        "<inertial><mass value='1'/><inertia ixx='1' iyy='1' izz='5' ixy='0' ixz='0' iyz='0'/></inertial>";
    const std::string text = urdf(link("a") + link("b", bad) + joint("j", "a", "b"));
    expect_error(text, "3: the inertia of link 'b' has a moment larger than the sum of the others");
    LoadOptions repair;
    repair.repair = true;
    EXPECT_EQ(errors_of(load_robot_text("x.urdf", text, repair)), "");
}

TEST(HostileFiles, a_moving_link_without_mass_has_two_ways_out)
{
    const std::string text =
        urdf(link("a") + link("b", "<collision><geometry><sphere radius='0.1'/></geometry></collision>") +
             joint("j", "a", "b"));
    expect_error(text, "the moving link 'b' has no mass");
    LoadOptions options;
    options.inertia_from_shapes = true;
    EXPECT_EQ(errors_of(load_robot_text("x.urdf", text, options)), "");
    options = {};
    options.missing_mass = 0.2;
    EXPECT_EQ(errors_of(load_robot_text("x.urdf", text, options)), "");
}

TEST(HostileFiles, a_missing_mesh_names_the_places)
{
    const std::string shape =
        "<collision><geometry><mesh filename='package://nowhere/a.stl'/></geometry></collision>";
    expect_error(urdf(link("a", kMass + shape)), kModels + "/nowhere/a.stl");
}

// A secret two folders above the robot is neither a mesh nor an include.
TEST(HostileFiles, nothing_outside_the_roots_is_read)
{
    namespace fs = std::filesystem;
    const fs::path top =
        fs::temp_directory_path() / ("epode_roots_" + std::to_string(std::random_device()()));
    fs::create_directories(top / "a/b");
    std::ofstream(top / "secret.xml") << "<mujocoinclude><worldbody/></mujocoinclude>";
    const std::string include = "<mujoco><include file='../../secret.xml'/><worldbody/></mujoco>";
    const std::string path = (top / "a/b/r.xml").string();
    const std::string outside = "outside the folders that may be read";
    EXPECT_NE(errors_of(load_robot_text(path, include)).find(outside), std::string::npos);
    fs::create_symlink(top / "secret.xml", top / "a/b/link.xml");
    EXPECT_NE(errors_of(load_robot_text(path, "<mujoco><include file='link.xml'/><worldbody/></mujoco>"))
                  .find(outside),
              std::string::npos);
    LoadOptions options;
    options.roots = {top.string()};
    EXPECT_EQ(errors_of(load_robot_text(path, include, options)), "");
    fs::remove_all(top);
}

// A name without a folder, and one whose package lies above the folder that is worked in, as a shell gives them.
TEST(RobotFiles, names_count_from_the_folder_that_is_worked_in)
{
    namespace fs = std::filesystem;
    const fs::path before = fs::current_path();
    fs::current_path(kModels);
    for (const char* name : {"walker.xml", "./walker.xml", "hand.xml", "arm.urdf", "geared.sdf"})
        EXPECT_EQ(errors_of(load_robot(name)), "") << name;
    const fs::path top =
        fs::temp_directory_path() / ("epode_package_" + std::to_string(std::random_device()()));
    fs::create_directories(top / "mine/urdf"), fs::create_directories(top / "mine/meshes");
    fs::copy(kModels + "/meshes", top / "mine/meshes");
    std::string mesh;
    for (const fs::directory_entry& entry : fs::directory_iterator(top / "mine/meshes"))
        if (entry.path().extension() == ".stl") mesh = entry.path().filename().string();
    ASSERT_NE(mesh, "");
    std::ofstream(top / "mine/urdf/r.urdf")
        << urdf(link("a", kMass + "<collision><geometry><mesh filename='package://mine/meshes/" + mesh +
                              "'/></geometry></collision>"));
    fs::current_path(top / "mine/urdf");
    EXPECT_EQ(errors_of(load_robot("r.urdf")), "");
    fs::current_path(before);
    fs::remove_all(top);
}

// Defaults of a position servo are turned into a general one's by their texts, and reports have numbers.
TEST(RobotFiles, are_read_the_same_where_the_locale_has_commas)
{
    const std::string servo =
        "<mujoco><default><position kp='2.5' kv='0.5'/></default><worldbody><body name='b'><joint name='j' "
        "limited='true' range='0.5 1.25'/><geom type='sphere' "
        "size='0.1'/></body></worldbody><actuator><general "
        "name='g' joint='j'/></actuator></mujoco>";
    const std::string wrong = urdf(
        link("a") + "<link name='b'><inertial><mass value='-0.5'/></inertial></link>" + joint("j", "a", "b"));
    const auto texts = [&] {
        const RobotModel model = load_robot_text(kModels + "/text.xml", servo);
        return errors_of(model) + write_mjcf(model, kModels).text + write_urdf(model, kModels).text +
               errors_of(load_robot_text(kModels + "/text.urdf", wrong));
    };
    const std::string wanted = texts();
    const epode::CommaLocale locale;
    if (!locale.is_there()) GTEST_SKIP() << "localedef makes no de_DE.UTF-8";
    EXPECT_EQ(texts(), wanted);
}

TEST(HostileFiles, includes_in_circles_are_refused)
{
    namespace fs = std::filesystem;
    const fs::path top =
        fs::temp_directory_path() / ("epode_circle_" + std::to_string(std::random_device()()));
    fs::create_directories(top);
    std::ofstream(top / "a.xml") << "<mujoco><include file='b.xml'/></mujoco>";
    std::ofstream(top / "b.xml") << "<mujocoinclude><include file='a.xml'/></mujocoinclude>";
    EXPECT_NE(errors_of(load_robot((top / "a.xml").string())).find("includes itself"), std::string::npos);
    fs::remove_all(top);
}

TEST(HostileFiles, depth_is_limited)
{
    std::string text = "<mujoco><worldbody>";
    for (int i = 0; i < 100'000; ++i) text += "<body>";
    expect_error(text + "</worldbody></mujoco>", "");
    std::string closed = "<mujoco><worldbody>";
    for (int i = 0; i < 600; ++i) closed += "<body>";
    for (int i = 0; i < 600; ++i) closed += "</body>";
    expect_error(closed + "</worldbody></mujoco>", "deeper than");
}

int mutations()
{
    const char* given = std::getenv("EPODE_ROBOT_MUTATIONS");
    return given ? std::max(1, std::atoi(given)) : 400;
}

std::string contents_of(const std::string& path)
{
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

void ignore_message(int, const char*, va_list) {}

// What is saved of a robot that was read can be read, and what was read of it can be saved and read again.
void expect_written_is_read(const RobotModel& model, const std::string& source)
{
    for (const bool as_urdf : {false, true}) {
        RobotModel from = model;
        for (int round = 0; round < 2; ++round) {
            const WrittenRobot written = as_urdf ? write_urdf(from, kModels) : write_mjcf(from, kModels);
            from = load_robot_text(kModels + (as_urdf ? "/written.urdf" : "/written.xml"), written.text);
            EXPECT_EQ(errors_of(from), "") << "written:\n" << written.text << "\nof:\n" << source;
            if (from.has_errors()) break;
        }
    }
}

TEST(HostileFiles, mutated_robots_do_not_crash)
{
    dInitODE2(0);
    dSetMessageHandler(&ignore_message);
    dSetErrorHandler(&ignore_message);
    dSetDebugHandler(&ignore_message);
    for (const char* name : {"arm.urdf", "walker.xml", "fourbar.xml", "hand.xml"}) {
        const std::string path = kModels + "/" + name, text = contents_of(path);
        ASSERT_FALSE(text.empty());
        std::mt19937 random(7);
        int good = 0;
        for (int i = 0; i < mutations(); ++i) {
            const std::string changed = mutated(text, random);
            RobotModel model = load_robot_text(path, changed);
            if (model.has_errors()) continue;
            ++good;
            expect_written_is_read(model, changed);
            const dWorldID world = dWorldCreate();
            const dSpaceID space = dHashSpaceCreate(nullptr);
            {
                const auto prepared = std::make_shared<const Prepared>(std::move(model));
                const Robot robot(prepared, world, space, {}, {});
                for (int step = 0; step < 2; ++step) dWorldStep(world, dReal(0.01));
            }
            dSpaceDestroy(space);
            dWorldDestroy(world);
        }
        EXPECT_GT(good, 0) << name;
    }
    dSetMessageHandler(nullptr);
    dSetErrorHandler(nullptr);
    dSetDebugHandler(nullptr);
    dCloseODE();
}

// A robot that names a mesh of its own: the mesh's bytes are mutated.
TEST(HostileFiles, mutated_meshes_do_not_crash)
{
    namespace fs = std::filesystem;
    const fs::path top =
        fs::temp_directory_path() / ("epode_meshes_" + std::to_string(std::random_device()()));
    fs::create_directories(top);
    const std::string collada =
        R"(<COLLADA><asset><unit meter="0.01"/><up_axis>Y_UP</up_axis></asset><library_geometries>
<geometry id="g"><mesh><source id="s"><float_array id="f" count="12">0 0 0 1 0 0 0 1 0 0 0 1</float_array></source>
<vertices id="v"><input semantic="POSITION" source="#s"/></vertices><polylist count="4"><input semantic="VERTEX" source="#v"
offset="0"/><vcount>3 3 3 3</vcount><p>0 2 1 0 1 3 1 2 3 0 3 2</p></polylist></mesh></geometry></library_geometries>
<library_visual_scenes><visual_scene id="z"><node><translate>1 2 3</translate><instance_geometry url="#g"/></node></visual_scene>
</library_visual_scenes></COLLADA>)";
    std::string binary(84, '\0');
    binary[80] = 4;
    for (int i = 0; i < 50; ++i) binary += std::string("\0\0\x80\x3f", 4);
    const std::pair<std::string, std::string> meshes[] = {
        {"m.stl", contents_of(kModels + "/meshes/cube.stl")},
        {"m.obj", contents_of(kModels + "/meshes/cube.obj")},
        {"m.dae", collada},
        {"m.glb", tetrahedron_glb()},
        {"m.stl", binary}};
    for (const auto& [name, bytes] : meshes) {
        const std::string robot = urdf(
            link("a", kMass + "<collision><geometry><mesh filename='" + name + "'/></geometry></collision>"));
        std::mt19937 random(11);
        for (int i = 0; i < mutations(); ++i) {
            std::ofstream(top / name, std::ios::binary) << (i == 0 ? bytes : mutated(bytes, random));
            const RobotModel model = load_robot_text((top / "r.urdf").string(), robot);
            if (i == 0 && name != "m.stl") { EXPECT_EQ(errors_of(model), "") << name; }
        }
    }
    fs::remove_all(top);
}

// The same of height fields.
TEST(HostileFiles, mutated_heights_do_not_crash)
{
    namespace fs = std::filesystem;
    const fs::path top =
        fs::temp_directory_path() / ("epode_fields_" + std::to_string(std::random_device()()));
    fs::create_directories(top);
    std::vector<unsigned char> pixels;
    for (int i = 0; i < 30; ++i) pixels.push_back(static_cast<unsigned char>(i * i));
    std::string binary("\5\0\0\0\6\0\0\0", 8);
    for (int i = 0; i < 30; ++i) binary += std::string("\0\0\x80", 3) + (i % 2 ? '\x3f' : '\x40');
    const std::pair<std::string, std::string> fields[] = {{"m.png", grey_png(6, 5, pixels)},
                                                          {"m.bin", binary}};
    for (const auto& [name, bytes] : fields) {
        const std::string robot =
            "<mujoco><asset><hfield name='h' size='1 1 1 1' file='" + name +
            "'/></asset><worldbody><geom type='hfield' hfield='h'/></worldbody></mujoco>";
        std::mt19937 random(13);
        for (int i = 0; i < mutations(); ++i) {
            std::ofstream(top / name, std::ios::binary) << (i == 0 ? bytes : mutated(bytes, random));
            const RobotModel model = load_robot_text((top / "r.xml").string(), robot);
            if (i == 0) { EXPECT_EQ(errors_of(model), "") << name; }
            for (const HeightField& field : model.fields)
                for (const double sample : field.samples) ASSERT_TRUE(sample >= 0 && sample <= 1);
        }
    }
    fs::remove_all(top);
}

}  // namespace
