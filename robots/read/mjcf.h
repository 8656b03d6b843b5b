// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The reader of MJCF, in nine files: the document (compiler, assets, includes), copies, what is attached of other files, the tree of bodies, height fields, tendons, and what acts on it
// (actuators, contacts, keys; equalities; sensors). Sections may stand in any order and be divided over files, so
// they are collected first and read in the order in which they need each other.
#pragma once

#include <array>
#include <memory>
#include <optional>

#include "robots/inertia.h"
#include "robots/mass_factor.h"
#include "robots/read/mjcf_defaults.h"
#include "robots/read/mjcf_names.h"

namespace epode::robots {

class Mjcf {
  public:
    Mjcf(const Element& root, Reading& reading)
        : root_(root), reading_(reading), model_(reading.model), names_(reading)
    {}
    void read();

  private:
    struct Compiler {
        bool degrees = true, autolimits = true, balance = false, strip_path = false, align_free = false;
        std::string from_geoms = "auto", euler = "xyz", mesh_dir, asset_dir;
        int low_group = 0, high_group = 5;
        double total_mass = -1, bound_mass = 0, bound_inertia = 0;
    };
    // What a body hands down, and a frame on the way.
    struct Scope {
        int link = 0;
        Pose pose;
        std::string childclass;
        int depth = 0;
    };
    struct Asset {
        Element element;
        std::string file, inertia;  // of a mesh: legacy, exact, convex or shell
        Vec scale{1, 1, 1};
        Pose reference;  // what of the file is the mesh's frame
        Pose placed;     // of the scaled mesh in the geom's frame
        int mesh = -1;
        bool tried = false;
    };

    struct Field {
        Element element;
        std::string file;
        int number = -1;
        bool tried = false;
    };

    struct ModelFile {
        Element element;
        std::string file;
        std::shared_ptr<RobotModel> model;
        int mesh = -1, field = -1;  // where its meshes and height fields are among ours
    };

    // Children with the files that they include in place.
    std::vector<Element> expand(const Element& element);
    void include(const Element& element, std::vector<Element>& out);
    std::string path_of(const Element& element) const;  // as mjcf_names.h has it, through includes
    // mjcf_copies.cpp
    void copy_element(const Element& from, pugi::xml_node to, const std::string& suffix);
    void copy_times(const Element& replicate, pugi::xml_node to, const std::string& suffix);
    void replicate(const Element& element, std::vector<Element>& out);
    void copy_user(const Element& element, std::vector<Element>& out);
    // mjcf_attach.cpp
    struct Attached;
    std::shared_ptr<const RobotModel> model_of_file(const Element& where, ModelFile& asset);
    void attach(const Element& element, const Scope& scope);
    void take_frames(const std::vector<int>& links, const std::string& prefix, const RobotModel& other,
                     const Pose& of_world);
    void finish_attached();

    void read_compiler(const Element& element);
    void read_option(const Element& element);
    void read_flag(const Element& flag);
    bool is_off(const char* flag) const { return off_.count(flag) > 0; }
    void switch_off();
    void read_custom(const Element& section);
    void read_assets(const Element& section);
    std::string asset_file(const Element& element) const;
    void set_total_mass();
    void set_springs();
    const MassFactor& masses();
    void read_defaults(const Element& section) { defaults_.read(section, reading_); }
    void read_world(const Element& section) { read_bodies(section, {}); }
    void read_sections(const std::vector<Element>& sections, const char* name,
                       void (Mjcf::*action)(const Element&));
    void note_other_sections(const std::vector<Element>& sections);

    // mjcf_bodies.cpp
    void read_bodies(const Element& body, const Scope& scope);
    void read_own(const std::vector<Element>& children, const Scope& scope, Inertia& of_geoms,
                  Inertia* inertial);
    void read_children(const std::vector<Element>& children, const Scope& scope);
    void read_inertial(const Attributes& attributes, const Pose& frame, Inertia& out);
    void read_joint(const Attributes& attributes, const Scope& scope);
    void read_site(const Attributes& attributes, const Scope& scope);
    void read_camera(const Attributes& attributes, const Scope& scope);
    void read_color(const Attributes& attributes, Shape& shape);
    void read_free_joint(const Attributes& attributes, const Scope& scope);
    bool fits_others(const Attributes& attributes, JointKind kind, const Scope& scope);
    bool read_range(const Attributes& attributes, Joint& joint);
    void read_passive(const Attributes& attributes, Joint& joint);
    // The first coefficient of a force's polynomial, not below 0.
    void coefficient(const Attributes& attributes, const char* name, double& out);
    void read_softness(const Attributes& attributes, const std::array<const char*, 2>& names,
                       Softness& softness);
    void read_friction(const Attributes& attributes, Shape& shape);
    void read_geom(const Attributes& attributes, const Scope& scope, Inertia& of_geoms);
    bool read_size(const Attributes& attributes, const std::string& type, Shape& shape);
    bool read_mesh(const Attributes& attributes, const std::string& type, Shape& shape);
    bool has_good_size(const Attributes& attributes, const std::string& type, Shape& shape);
    void add_mass(const Attributes& attributes, const Shape& shape, Inertia& of_geoms);
    Inertia unit_inertia(const Attributes& attributes, const Shape& shape) const;
    void finish_link(Link& link, const Inertia& of_geoms, const Inertia* inertial);
    Pose pose_of(const Attributes& attributes);
    Quat turn_of_euler(Vec angles) const;
    int inline_mesh(const Asset& asset, bool counts_folds);
    void place(Asset& asset);
    Asset* mesh_named(const std::string& name, const Element& where);
    const Frame* site_named(const std::string& name) const;  // null: none
    bool has_no_place(const Element& element);

    // mjcf_heights.cpp
    bool read_field(const Attributes& attributes, Shape& shape);
    int make_field(const Field& asset);
    bool read_samples(const Field& asset, HeightField& field, std::string& problem);
    bool read_elevation(const Element& element, HeightField& field, std::string& problem);

    // mjcf_tendons.cpp
    void read_tendons(const Element& section);
    void read_terms(const Element& element, Tendon& tendon);
    void read_path(const Element& element, Tendon& tendon);
    bool read_surface(const Element& element, PathPart& part);
    void read_tendon(const Attributes& attributes, Tendon& tendon);

    // mjcf_actions.cpp
    void read_actuators(const Element& section);
    void read_actuator(const Attributes& attributes);
    bool find_target(const Attributes& attributes, Actuator& actuator);
    bool find_site(const Attributes& attributes, Actuator& actuator);
    bool find_crank(const Attributes& attributes, Actuator& actuator);
    void note_wrench(const Element& element);
    bool find_body(const Attributes& attributes, Actuator& actuator);
    bool find_direction(const Attributes& attributes, Actuator& actuator);
    void read_gains(const Attributes& attributes, Actuator& actuator);
    void check_servo(const Attributes& attributes);
    void read_activation(const Attributes& attributes, Actuator& actuator);
    void read_filter(const Attributes& attributes, Actuator& actuator);
    double damping_of(const Actuator& actuator, double ratio);
    void read_muscle(const Attributes& attributes, Actuator& actuator);
    void find_lengths(const Attributes& attributes, Actuator& actuator);
    double acceleration_of(const Actuator& actuator);
    std::vector<double> moment_of(const Actuator& actuator);
    void read_cylinder(const Attributes& attributes, Actuator& actuator);
    void read_general_gains(const Attributes& attributes, Actuator& actuator);
    void read_contacts(const Element& section);
    bool find_touching(const Element& element, const char* attribute, int& link);
    void read_pair(const Attributes& attributes);
    void read_pair_friction(const Attributes& attributes, ShapePair& pair);
    void check_key(const Element& element);
    void read_keys(const Element& section);
    void read_mocap(const Element& element, Start& start);

    // mjcf_equalities.cpp
    void read_equalities(const Element& section);
    bool names_one_twice(const Element& element);
    void read_closure(const Attributes& attributes, bool weld);
    bool join_sites(const Element& element, Closure& closure);
    bool join_bodies(const Attributes& attributes, Closure& closure);
    void read_joint_equality(const Attributes& attributes);
    void read_tendon_equality(const Attributes& attributes);
    bool read_curve(const Attributes& attributes, std::array<double, 5>& curve);
    bool read_line(const Attributes& attributes, std::array<double, 2>& line, Coupling& coupling);
    void read_tie(const Attributes& attributes, int one, int two);

    // mjcf_sensors.cpp
    void read_sensors(const Element& section);
    void read_sensor(const Element& element);
    bool find_sensed_geoms(const Element& element, Sensor& sensor);

    bool list(const Attributes& attributes, const char* name, size_t least, size_t largest,
              std::vector<double>& out);
    bool number(const Attributes& attributes, const char* name, double& out);
    bool vec(const Attributes& attributes, const char* name, Vec& out);
    // A limit is on if said so, which wants a range, or if the compiler decides and there is a range of other ends: "0 0" is none.
    bool is_limited(const Attributes& attributes, const char* flag, const char* range) const;
    double angle(double value) const;

    Element root_;
    Reading& reading_;
    RobotModel& model_;
    Compiler compiler_;
    Defaults defaults_;
    std::set<std::string> off_;  // flags that an option has disabled
    std::map<std::string, Asset> assets_;
    std::map<std::string, Field> fields_;
    std::map<std::string, ModelFile> models_;                // of files that bodies are attached from
    std::map<std::string, std::array<float, 4>> materials_;  // their colours
    std::vector<std::shared_ptr<Attached>> attached_;
    std::map<std::string, std::unique_ptr<Document>> documents_;
    std::vector<std::string> including_;
    size_t includes_ = 0, actuators_ = 0;  // in the files
    std::map<std::string, std::vector<std::string>>
        copies_;  // of names that are replicated, what stands behind them
    std::map<const void*, std::unique_ptr<pugi::xml_document>> replicas_;  // by what was copied
    int copied_ = 0;
    MjcfNames names_;
    std::map<const Document*, std::string> places_;  // of included files: the path of what includes them
    std::map<int, std::array<double, 2>> springs_;   // time constant and damping ratio, by joint
    std::optional<MassFactor> masses_;
    bool touches_ = true;  // no contacts: geoms are looks
};

}  // namespace epode::robots
