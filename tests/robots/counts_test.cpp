// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// One number too many is refused with its line, in every attribute of MJCF (as MuJoCo 4.0 counts them) and URDF and in every element of
// SDF that holds numbers, whether the reader uses it or not.
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "robots/load.h"

namespace epode::robots {
namespace {

struct NamesRow {
    const char *path, *attributes;
};
// clang-format off
constexpr NamesRow kNames[] = {
#include "robots/read/mjcf_names.inc"
};
struct CountsRow {
    const char* element;
    size_t limit;
    const char* attributes;
};
constexpr CountsRow kCounts[] = {
#include "robots/read/mjcf_counts.inc"
};
// clang-format on

std::vector<std::string> words_of(const std::string& text)
{
    std::istringstream in(text);
    return {std::istream_iterator<std::string>(in), {}};
}

// What is refused in the second line for its count.
std::string refusal(const std::string& path, const std::string& text)
{
    const RobotModel model = load_robot_text(path, text);
    for (const ReportLine& line : model.report)
        if (line.note == Note::kError && line.line == 2 &&
            line.text.find(" at most, not ") != std::string::npos)
            return line.text;
    return {};
}

std::string ones(size_t count)
{
    std::string out = "1";
    for (size_t i = 1; i < count; ++i) out += " 1";
    return out;
}

std::string wanted(const std::string& where, size_t limit)
{
    const std::string text = ones(limit + 1);
    return where + " = '" + text.substr(0, 60) + (text.size() > 60 ? "..." : "") + "', wanted " +
           std::to_string(limit) + (limit == 1 ? " finite number" : " finite numbers") + " at most, not " +
           std::to_string(limit + 1);
}

size_t limit_of(const std::string& element, const std::string& attribute)
{
    for (const std::string& its : {element, std::string()})
        for (const CountsRow& row : kCounts) {
            const auto words = words_of(row.attributes);
            if (row.element == its && std::find(words.begin(), words.end(), attribute) != words.end())
                return row.limit;
        }
    return 0;
}

// The element stands in the second line.
std::string mjcf(const std::string& path, const std::string& attribute, size_t count)
{
    std::string begin = "<mujoco>", end = "</mujoco>", its = path;
    if (path.starts_with("body")) begin += "<worldbody>", end = "</worldbody>" + end;
    for (size_t at; (at = its.find('/')) != std::string::npos; its = its.substr(at + 1)) {
        const std::string name = its.substr(0, at);
        begin += "<" + name + ">", end = "</" + name + ">" + end;
    }
    return begin + "\n<" + its + " " + attribute + "='" + ones(count) + "'/>" + end;
}

TEST(Counts, no_attribute_of_mjcf_takes_one_number_more)
{
    size_t counted = 0;
    for (const NamesRow& row : kNames)
        for (const std::string& attribute : words_of(row.attributes)) {
            const std::string path = row.path, element = path.substr(path.rfind('/') + 1);
            const size_t limit = path.empty() ? 0 : limit_of(element, attribute);
            if (limit == 0) continue;
            ++counted;
            EXPECT_EQ(refusal("r.xml", mjcf(path, attribute, limit + 1)),
                      wanted(element + " " + attribute, limit))
                << path;
            EXPECT_EQ(refusal("r.xml", mjcf(path, attribute, limit)), "") << path;
        }
    EXPECT_GT(counted, 1000u);
}

TEST(Counts, keys_are_counted_by_the_model)
{
    const auto with = [](const std::string& key) {
        return refusal(
            "r.xml",
            "<mujoco><worldbody><body><joint name='j'/><geom size='1'/></body></worldbody><actuator><motor "
            "joint='j'/></actuator><keyframe>\n<key " +
                key + "/></keyframe></mujoco>");
    };
    EXPECT_EQ(with("ctrl='1 1'"), wanted("key ctrl", 1));
    EXPECT_EQ(with("qvel='1 1'"), wanted("key qvel", 1));
    EXPECT_EQ(with("qpos='1' qvel='1' ctrl='1'"), "");
}

TEST(Counts, no_attribute_of_urdf_takes_one_number_more)
{
    struct Case {
        const char* element;
        size_t limit;
        const char* attributes;
    };
    constexpr Case cases[] = {
        {"origin", 3, "xyz rpy"},
        {"axis", 3, "xyz"},
        {"box", 3, "size"},
        {"mesh", 3, "scale"},
        {"color", 4, "rgba"},
        {"sphere", 1, "radius"},
        {"cylinder", 1, "radius length"},
        {"capsule", 1, "radius length"},
        {"mass", 1, "value"},
        {"inertia", 1, "ixx ixy ixz iyy iyz izz"},
        {"limit", 1, "lower upper effort velocity"},
        {"dynamics", 1, "damping friction"},
        {"mimic", 1, "multiplier offset"},
        {"safety_controller", 1, "soft_lower_limit soft_upper_limit k_position k_velocity"},
        {"calibration", 1, "reference_position rising falling"},
        {"lateral_friction", 1, "value"}};
    for (const Case& one : cases)
        for (const std::string& attribute : words_of(one.attributes)) {
            const auto with = [&](size_t count) {
                return refusal("r.urdf", "<robot name='r'><link name='a'><contact>\n<" +
                                             std::string(one.element) + " " + attribute + "='" + ones(count) +
                                             "'/></contact></link></robot>");
            };
            EXPECT_EQ(with(one.limit + 1), wanted(std::string(one.element) + " " + attribute, one.limit));
            EXPECT_EQ(with(one.limit), "");
        }
}

#ifdef EPODE_HAVE_SDF

// The text that stands at @ goes into the second line.
std::string sdf(const std::string& inside, const std::string& text)
{
    const size_t begin = inside.find('@'), end = inside.rfind('<', begin);
    return inside.substr(0, end) + "\n" + inside.substr(end, begin - end) + text + inside.substr(begin + 1);
}

TEST(Counts, no_element_of_sdf_takes_one_number_more)
{
    struct Case {
        const char* element;
        size_t limit;
        const char* inside;
    };
    constexpr Case cases[] = {
        {"mass", 1, "<inertial><mass>@</mass></inertial>"},
        {"ixx", 1, "<inertial><inertia><ixx>@</ixx><iyy>1</iyy><izz>1</izz></inertia></inertial>"},
        {"size", 3, "<collision name='c'><geometry><box><size>@</size></box></geometry></collision>"},
        {"size", 2, "<collision name='c'><geometry><plane><size>@</size></plane></geometry></collision>"},
        {"mu", 1,
         "<collision "
         "name='c'><geometry><sphere><radius>1</radius></sphere></geometry><surface><friction><ode><mu>@</"
         "mu></ode>"
         "</friction></surface></collision>"},
        {"kp", 1,
         "<collision "
         "name='c'><geometry><sphere><radius>1</radius></sphere></geometry><surface><contact><ode><kp>@</"
         "kp></ode>"
         "</contact></surface></collision>"},
        {"linear", 1, "<velocity_decay><linear>@</linear></velocity_decay>"},
        {"max_contacts", 1,
         "<collision "
         "name='c'><max_contacts>@</max_contacts><geometry><sphere><radius>1</radius></sphere></geometry></"
         "collision>"},
        {"xyz", 3,
         "</link><link name='b'></link><joint name='j' "
         "type='revolute'><parent>a</parent><child>b</child><axis><xyz>@</xyz></axis>"
         "</joint><link name='d'>"},
        {"lower", 1,
         "</link><link name='b'></link><joint name='j' "
         "type='revolute'><parent>a</parent><child>b</child><axis><xyz>1 0 0</xyz>"
         "<limit><lower>@</lower><upper>2</upper></limit></axis></joint><link name='d'>"}};
    for (const Case& one : cases) {
        const auto with = [&](size_t count) {
            return refusal("r.sdf", sdf("<sdf version='1.7'><model name='m'><link name='a'>" +
                                            std::string(one.inside) + "</link></model></sdf>",
                                        ones(count)));
        };
        EXPECT_EQ(with(one.limit + 1), wanted(one.element, one.limit)) << one.inside;
        EXPECT_EQ(with(one.limit), "") << one.inside;
    }
}

#endif

}  // namespace
}  // namespace epode::robots
