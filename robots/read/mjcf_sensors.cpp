// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Sensors: see mjcf.h.
#include "robots/read/mjcf.h"
#include "robots/sensor_kinds.h"

namespace epode::robots {

// Of a distance: two geoms, or all geoms of two bodies.
bool Mjcf::find_sensed_geoms(const Element& element, Sensor& sensor)
{
    const auto find = [&](const std::string& which, std::string& type, std::string& name) {
        type = element.has(("geom" + which).c_str()) ? "geom" : "body";
        name = element.text((type + which).c_str());
        int link = 0;
        return type == "geom" ? model_.any_shape_named(name, link) != nullptr : model_.link_named(name) >= 0;
    };
    if (find("1", sensor.object_type, sensor.object) && find("2", sensor.reference_type, sensor.reference))
        return true;
    reading_.error(element, "<" + sensor.kind + "> of '" + sensor.object + "' and '" + sensor.reference +
                                "', of which one is not there");
    return false;
}

void Mjcf::read_sensor(const Element& element)
{
    Sensor sensor;
    sensor.name = element.text("name"), sensor.kind = element.name(), sensor.line = element.line();
    for (const char* object : {"joint", "site", "body", "objname", "actuator", "tendon", "geom"})
        if (element.has(object)) sensor.object = element.text(object), sensor.attribute = object;
    sensor.object_type = sensor.attribute == "site" ? "site" : element.text("objtype");
    sensor.is_on_child = sensor.kind == "force" || sensor.kind == "torque";
    sensor.reference = element.text("refname"), sensor.reference_type = element.text("reftype");
    if (reading_.number(element, "cutoff", sensor.cutoff) && sensor.cutoff < 0)
        reading_.error(element, "<" + sensor.kind + "> cutoff is below 0");
    if (values_of_geom_sensor(sensor.kind) && !find_sensed_geoms(element, sensor)) return;
    if (sensor.kind == "insidesite") sensor.reference = element.text("site"), sensor.reference_type = "site";
    model_.sensors.push_back(sensor);
    if (values_of(sensor.kind) == 0)
        reading_.note_once(Note::kIgnored, element,
                           "sensors of kind <" + sensor.kind + "> are listed, not computed");
    if (sensor.kind == "touch")
        reading_.note_once(
            Note::kApproximated, element,
            "a touch sensor of a site without a size feels its whole link, in a batch every one");
}

void Mjcf::read_sensors(const Element& section)
{
    for (const Element& element : expand(section)) read_sensor(element);
}

}  // namespace epode::robots
