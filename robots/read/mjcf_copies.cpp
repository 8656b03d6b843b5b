// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// <replicate>: what is in it stands in the model several times, copy i moved by the i-th power of (offset, euler), with a number behind
// each of its names; of one in another the inner number comes first. Actuators, sensors, equalities and exclusions of names that are
// copied are copied, too. All of it as XML, in frames, before anything is read.
#include <algorithm>
#include <cstring>

#include "robots/numbers.h"
#include "robots/read/mjcf.h"

namespace epode::robots {

namespace {

constexpr int kMaxCopied = 200'000;

// "07" of 7 among 12.
std::string number_among(int i, int count)
{
    const std::string last = std::to_string(count - 1), its = std::to_string(i);
    return std::string(last.size() - its.size(), '0') + its;
}

std::string text_of_list(std::initializer_list<double> values)
{
    std::string out;
    for (double value : values) out += (out.empty() ? "" : " ") + text_of(value);
    return out;
}

bool is_reference(const char* attribute)
{
    static const std::set<std::string> words{"joint",   "jointinparent", "site",      "body",    "geom",
                                             "joint1",  "joint2",        "site1",     "site2",   "body1",
                                             "body2",   "geom1",         "geom2",     "refsite", "objname",
                                             "refname", "cranksite",     "slidersite"};
    return words.count(attribute) > 0;
}

void add_behind(pugi::xml_attribute attribute, const std::string& suffix)
{
    attribute.set_value((attribute.value() + suffix).c_str());
}

}  // namespace

// A copy of an element and of all in it, with the suffix behind names.
void Mjcf::copy_element(const Element& from, pugi::xml_node to, const std::string& suffix)
{
    if (++copied_ > kMaxCopied) return;
    if (from.name() == "replicate") return copy_times(from, to, suffix);
    pugi::xml_node its = to.append_child(from.node.name());
    for (const pugi::xml_attribute& attribute : from.node.attributes()) {
        pugi::xml_attribute copy = its.append_copy(attribute);
        if (std::strcmp(attribute.name(), "name") != 0) continue;
        std::vector<std::string>& known = copies_[attribute.value()];
        if (std::find(known.begin(), known.end(), suffix) == known.end()) known.push_back(suffix);
        add_behind(copy, suffix);
    }
    for (const Element& child : from.children()) copy_element(child, its, suffix);
}

void Mjcf::copy_times(const Element& replicate, pugi::xml_node to, const std::string& suffix)
{
    double number = 0;
    reading_.number(replicate, "count", number);
    if (!(number >= 1 && number <= kMaxCopied))
        return reading_.error(replicate, "<replicate> wants a count of 1 or more");
    const int count = int(number);
    Pose step, pose;
    Vec angles;
    reading_.vec(replicate, "offset", step.p);
    if (reading_.vec(replicate, "euler", angles)) step.q = turn_of_euler(angles);
    for (int i = 0; i < count && copied_ <= kMaxCopied; ++i, pose = pose * step) {
        pugi::xml_node frame = to.append_child("frame");
        frame.append_attribute("pos").set_value(text_of_list({pose.p.x, pose.p.y, pose.p.z}).c_str());
        frame.append_attribute("quat").set_value(
            text_of_list({pose.q.w, pose.q.x, pose.q.y, pose.q.z}).c_str());
        if (replicate.has("childclass")) frame.append_copy(replicate.node.attribute("childclass"));
        for (const Element& child : replicate.children())
            copy_element(child, frame, replicate.text("sep") + number_among(i, count) + suffix);
    }
}

// The frames in place of a <replicate>.
void Mjcf::replicate(const Element& element, std::vector<Element>& out)
{
    auto& frames = replicas_[element.node.internal_object()];
    if (!frames) {
        frames = std::make_unique<pugi::xml_document>();
        copy_times(element, *frames, "");
        if (copied_ > kMaxCopied) reading_.error(element, "copies of more than 200000 elements");
    }
    for (pugi::xml_node frame : frames->children()) out.push_back({frame, element.document});
}

// An element of a section, or copies of it where it names what was copied.
void Mjcf::copy_user(const Element& element, std::vector<Element>& out)
{
    const std::vector<std::string>* suffixes = nullptr;
    for (const pugi::xml_attribute& attribute : element.node.attributes())
        if (const auto found = copies_.find(attribute.value());
            is_reference(attribute.name()) && found != copies_.end())
            suffixes = &found->second;
    if (!suffixes) return out.push_back(element);
    auto& its = replicas_[element.node.internal_object()];
    if (!its) {
        its = std::make_unique<pugi::xml_document>();
        for (const std::string& suffix : *suffixes) {
            pugi::xml_node copy = its->append_copy(element.node);
            for (pugi::xml_attribute attribute : copy.attributes())
                if (std::strcmp(attribute.name(), "name") == 0 ||
                    (is_reference(attribute.name()) && copies_.count(attribute.value())))
                    add_behind(attribute, suffix);
        }
    }
    for (pugi::xml_node copy : its->children()) out.push_back({copy, element.document});
}

}  // namespace epode::robots
