// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The writer of MJCF, in two files: what a robot is (mjcf.cpp), and what acts on it (mjcf_acting.cpp).
#pragma once

#include "robots/write/text.h"
#include "robots/write/write.h"

namespace epode::robots {

class MjcfWriter {
    using Node = pugi::xml_node;

  public:
    MjcfWriter(const RobotModel& model, const std::string& folder) : model_(model), folder_(folder) {}
    WrittenRobot write();

  private:
    static const char* yes(bool value) { return value ? "true" : "false"; }
    static std::string range_of(double low, double high) { return list_text({low, high}); }
    static bool is_near(const Pose& a, const Pose& b);
    // No two of a kind have one name.
    static void name_it(Node node, Names& names, const std::string& name)
    {
        if (!name.empty()) set(node, "name", names.unique(name, "", 0));
    }
    void name_all();
    void write_option(Node option);
    void write_meshes();
    void write_fields();
    void write_bodies();
    void write_zone(Node site, const Frame& frame);
    void write_pose(Node node, const Pose& pose);
    void write_inertial(Node body, const Link& link);
    void write_joint(Node body, size_t number);
    void write_passive(Node node, const Joint& joint);
    std::string write_geom(Node body, const Shape& shape, bool touches);
    void write_size(Node geom, const Shape& shape);
    void write_closures();
    std::string site_at(int link, const Pose& pose, bool by_place = false);
    void write_couplings();
    void write_tendons();
    void write_tendon(const Tendon& tendon, const std::string& name);
    void write_part(Node tendon, const PathPart& part);
    std::string surface_of(const PathPart& part);
    void write_tendon_equality(const Coupling& coupling);
    void write_ties();
    void write_actuators();
    void write_target(Node actuator, const Actuator& from);
    void write_gains(Node actuator, const Actuator& from, const std::string& kind);
    void write_contacts_and_keys();
    void write_pair(const ShapePair& pair);
    std::string written_geom(const std::string& name) const;
    static void write_softness(Node node, const char* reference, const char* impedance, const Softness& s);
    // The attribute that names what a sensor is on, its type, and the name; no attribute: not to be said.
    struct Sensed {
        std::string attribute, type, object;
    };
    Sensed joint_object(const Sensor& sensor) const;
    Sensed frame_object(const std::string& kind, const std::string& type, const std::string& name) const;
    void write_reference(Node its, const Sensor& sensor) const;
    void write_sensors();
    Sensed geom_object(const std::string& type, const std::string& name, const char* number) const;
    Node write_sensor(const Sensor& sensor, const Sensed& on);
    void write_custom();
    void write_cameras();
    Node tuple(const char* name);
    void note_losses();
    Node body_of(int link, const Shape& shape);
    Node section(const char* name);

    const RobotModel& model_;
    std::string folder_;
    pugi::xml_document document_;
    Node root_;
    std::vector<std::string> links_, joints_, tendons_;
    std::vector<Node> bodies_, still_bodies_;
    std::vector<std::string> still_;  // names of what stands apart
    Names sites_, geoms_, tendon_names_, equality_names_, actuator_names_, key_names_, sensor_names_,
        pair_names_;
    std::vector<std::string> frames_;                   // names of the model's, as written
    std::vector<std::vector<std::string>> geom_names_;  // by link: of what touches, then of looks
    Losses losses_;
};

}  // namespace epode::robots
