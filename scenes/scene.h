// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A scene is a world, a space and everything in them, built by a recipe, stepped the way the guide's "typical
// simulation code" does it: collide, make contact joints, step, empty the contact group. It speaks only the
// public C API, so the same binary runs on any libode.so.8. A recipe is plain data and one function rather
// than a subclass: a scene then is one file, one build function and one line in scenes.inc. What the last
// step did (contacts, times) stays readable until the next one; measure.h judges it.
#pragma once

#include <ode/ode.h>

#include <cstdint>
#include <deque>
#include <functional>
#include <string>
#include <vector>

namespace epode::scenes {

enum class Stepper { kExact, kQuick, kFast, kHybrid };
constexpr Stepper kSteppers[] = {Stepper::kExact, Stepper::kQuick, Stepper::kFast, Stepper::kHybrid};
const char* name_of(Stepper stepper);
bool stepper_named(const std::string& name, Stepper& stepper);
// The message where there is none of that name.
std::string no_such_stepper(const std::string& name);
// dWorldStepFast1 and dWorldStepHybrid are not in every library; the other two are.
bool available(Stepper stepper);

class Scene;

struct Recipe {
    const char* name;
    const char* description;
    double dt;
    double seconds;
    Stepper stepper;  // in ODE's way, on any library: exact for mechanisms, quick for many bodies in contact
    void (*build)(Scene&);
};

// How a scene is stepped where nobody says otherwise: as the guide recommends (docs/guide/steppers.md).
// Mechanisms exactly; many bodies in contact, as in games, in substeps with world-managed contacts,
// or where the library has none of that, in ODE's way.
struct Setting {
    Stepper stepper;
    bool world_contacts;
};
Setting recommended(const Recipe& recipe);

struct ContactRecord {
    dGeomID geom1, geom2;
    double pos[3];
    double normal[3];  // into geom1
    double depth;
    double force[3];  // on the body of geom1, N, where forces were asked for
};

struct JointRecord {
    dJointID joint;
    double reference[3];  // origin of body 2 (or of the world) seen from body 1 when the joint was made
};

// What whoever watches may turn while the scene runs: an axis, a control.
struct Dial {
    std::string name;
    const char* unit;
    double low, high;
    std::function<double()> value;
    std::function<void(double)> turn;
};

// Where a picture is best taken from; not set: the viewer frames the shapes itself.
struct View {
    bool set = false;
    double eye[3] = {0, 0, 0};
    double target[3] = {0, 0, 0};
    dBodyID follow = nullptr;  // eye and target move over the floor with this body
};

struct StepTimes {
    double collide_ms = 0, step_ms = 0, empty_ms = 0;
    double total_ms() const { return collide_ms + step_ms + empty_ms; }
};

// dInitODE2 and dCloseODE as a pair. One lives in main(), around every scene.
class Runtime {
  public:
    Runtime();
    ~Runtime();
    Runtime(const Runtime&) = delete;
    Runtime& operator=(const Runtime&) = delete;
};

class Scene {
  public:
    explicit Scene(const Recipe& recipe, std::uint32_t seed = 1);
    ~Scene();
    Scene(const Scene&) = delete;
    Scene& operator=(const Scene&) = delete;

    const Recipe& recipe() const { return recipe_; }
    dWorldID world() const { return world_; }
    dSpaceID space() const { return space_; }
    std::uint32_t seed() const { return seed_; }
    double time() const { return time_; }
    // For whoever puts the bodies back to where they were at that time.
    void set_time(double time) { time_ = time; }

    // For recipes; build.h has the comfortable forms.
    void add_body(dBodyID body) { bodies_.push_back(body); }
    void add_geom(dGeomID geom) { geoms_.push_back(geom); }
    void add_joint(dJointID joint);
    void before_step(std::function<void(double time, double dt)> hook) { hooks_.push_back(std::move(hook)); }

    // All in order of creation. Geoms include the static ones.
    const std::vector<dBodyID>& bodies() const { return bodies_; }
    const std::vector<dGeomID>& geoms() const { return geoms_; }
    const std::vector<JointRecord>& joints() const { return joints_; }

    // Sweeps of dWorldQuickStep, substeps of dWorldStepFast1 and dWorldStepHybrid; the exact stepper has
    // none. 0: the defaults, 20 and 4.
    void set_iterations(int iterations) { iterations_ = iterations; }
    // The world finds its contacts itself (ode/contacts.h) from now on, with materials in place of `surface`.
    // False, and why: the library cannot, or the scene makes contacts that the world would not.
    bool manage_contacts(std::string& problem);
    bool manages_contacts() const { return world_contacts_; }
    // Whether contact records tell the forces of the step; it costs a little time.
    void want_forces(bool wanted) { want_forces_ = wanted; }
    // False when the library reports that the step failed.
    bool step(Stepper stepper, double dt);

    const std::vector<ContactRecord>& contacts() const { return contacts_; }
    const StepTimes& times() const { return times_; }

    // How contacts are made: every contact starts as `surface`, then `on_contact` may change it or, by false,
    // refuse it.
    dSurfaceParameters surface{};
    int contacts_per_pair = 4;
    int contact_copies = 1;
    std::function<bool(dGeomID, dGeomID, dContact&)> on_contact;

    // What the recipe knows about its own physics, for whoever judges the run.
    bool isolated = false;      // nothing acts but its own bodies: momentum must stay
    bool conservative = false;  // no friction, no motor, no impact: the motion itself keeps energy
    // For scenes that say so: dWorldStep turns bodies exactly and divides its step into so many parts, where
    // the library can. Then the exact stepper keeps what the motion keeps.
    void step_precisely(int parts);
    int precise_parts() const { return parts_; }  // 0: as ODE does
    std::vector<dBodyID> tracked;
    View view;
    std::vector<Dial> dials;

  private:
    static void near_callback(void* scene, dGeomID geom1, dGeomID geom2);
    void collide_pair(dGeomID geom1, dGeomID geom2);
    void make_contact(dBodyID body1, dBodyID body2, dContact& contact);
    int advance(Stepper stepper, double dt);
    void read_forces();
    void set_materials();
    void read_world_contacts();

    const Recipe& recipe_;
    std::uint32_t seed_;
    dWorldID world_;
    dSpaceID space_;
    dJointGroupID contact_group_;
    double time_ = 0;
    int iterations_ = 0;
    bool world_contacts_ = false;
    int parts_ = 0;
    size_t materials_ = 0;  // geoms that have theirs
    std::vector<dBodyID> bodies_;
    std::vector<dGeomID> geoms_;
    std::vector<JointRecord> joints_;
    std::vector<std::function<void(double, double)>> hooks_;
    std::vector<ContactRecord> contacts_;
    bool want_forces_ = false;
    std::deque<dJointFeedback> feedback_;  // of contacts_, one each; the library holds their addresses
    StepTimes times_;
};

// Every recipe of scenes.inc, in that order.
const std::vector<const Recipe*>& all_recipes();
// One more that find_recipe knows, of the program's own: a robot from a file. It must outlive all its scenes.
void add_recipe(const Recipe& recipe);
// Null when there is no scene of that name.
const Recipe* find_recipe(const std::string& name);
// All names, a space before each: for messages.
std::string scene_names();
// The same as a list.
std::vector<std::string> scene_list();

}  // namespace epode::scenes
