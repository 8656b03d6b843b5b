// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Plays a sequence: each operation is one random number, from which it draws what to do and with which of the
// objects that are alive, so any part of a sequence is a sequence again and a failing one can be cut down.
// Before each call the model says whether the guide allows it; a call that is refused against the rules or
// accepted against them is a failure, and so is every difference that check() finds between the books.
// Inside callbacks locks decide as well; there the library's answer is taken, and only the books compared.
#pragma once

#include <cstdint>
#include <string>

#include "script.h"

namespace epode::sequences {

class Dice {
  public:
    explicit Dice(std::uint64_t seed) : state_(seed) {}
    std::uint64_t next();
    int below(int n) { return n <= 1 ? 0 : int((next() >> 33) % std::uint64_t(n)); }
    bool chance(int percent) { return below(100) < percent; }
    double between(double low, double high) { return low + (high - low) * double(next() >> 40) / 16777216; }

  private:
    std::uint64_t state_;
};

struct JointKind {
    int type;  // dJointType
    const char* create_name;
    dJointID (*create)(dWorldID, dJointGroupID);
    const char* set_name;
    void (*set)(dJointID, int, dReal);  // a parameter; null: none
    const char* place_name[3];
    void (*place[3])(dJointID, dReal, dReal, dReal);  // anchor, axes; null: none
    bool needs_two;
};

struct ShapeKind;

class Player {
  public:
    Player();
    ~Player();
    Player(const Player&) = delete;
    Player& operator=(const Player&) = delete;

    // False: something is wrong, see complaint().
    bool play(std::uint64_t operation);
    bool tear_down(std::uint64_t seed);  // everything, in a random order
    bool check();                        // library and model say the same
    const std::string& complaint() const { return complaint_; }

    Script script;
    Model model;
    int calls = 0;    // operations played, those inside callbacks included
    int refused = 0;  // of them refused, as the rules want

    // From the C callbacks.
    void near(dGeomID a, dGeomID b);
    void moved();

  private:
    using Operation = void (Player::*)(Dice&);
    struct Entry {
        Operation run;
        int weight;
    };
    static const Entry kEntries[];

    void fail(const char* format, ...);
    bool in_callback() const { return depth_ > 0; }

    // Runs a call; true when it was not refused. `legal`: what the rules say.
    template <typename Run>
    bool attempt(bool legal, const char* what, Run&& run);

    template <typename Run>
    auto take(Run&& run);
    bool refused_last() const { return last_refused_; }

    template <typename T>
    static T* any(const std::vector<T*>& list, Dice& dice)
    {
        return list.empty() ? nullptr : list[std::size_t(dice.below(int(list.size())))];
    }
    Geom* any_space(Dice& dice);
    Geom* any_shape(Dice& dice);
    static bool space_open(const Geom* space) { return !space || space->is_space; }

    void create_world(Dice&);
    void destroy_world(Dice&);
    void tune_world(Dice&);
    void create_body(Dice&);
    void destroy_body(Dice&);
    void place_body(Dice&);
    void push_body(Dice&);
    void tune_body(Dice&);
    void sleep_body(Dice&);
    void create_joint(Dice&);
    void attach_joint(Dice&);
    void tune_joint(Dice&);
    void watch_joint(Dice&);
    void destroy_joint(Dice&);
    void use_group(Dice&);
    void create_geom(Dice&);
    void create_space(Dice&);
    void change_space(Dice&);
    void tune_space(Dice&);
    void set_geom_body(Dice&);
    void place_geom(Dice&);
    void tune_geom(Dice&);
    void offset_geom(Dice&);
    void hold_geom(Dice&);
    void destroy_geom(Dice&);
    void use_field(Dice&);
    void use_mesh(Dice&);
    void collide(Dice&);
    void collide_two(Dice&);
    void step(Dice&);
    void use_states(Dice&);
    void copy_world(Dice&);
    void extend_world(Dice&);
    void step_worlds(Dice&);
    void extend_joint(Dice&);
    void couple(Dice&);
    void extend_geom(Dice&);
    void ask_space(Dice&);
    void strike_body(Dice&);
    void wet_world(Dice&);
    void drive_body(Dice&);
    void walk_through(Dice&);
    void shape_contacts(Dice&);
    void call_the_dead(Dice&);
    void call_nothing(Dice&);
    void check_everything(Dice&);

    void shape(Geom& geom, Dice& dice);
    void adopt_contacts(World& world, Group* group);
    void run_once(Dice& dice);
    void check_invariants();  // of the library's insides

    void check_worlds();
    void check_bodies();
    void check_joints();
    void check_geoms();
    void check_spaces();
    void check_islands(World& world);
    void learn(World& world);
    bool dies(Dice& dice, int kind);

    std::string complaint_;
    int depth_ = 0;
    bool last_refused_ = false;
    Dice* near_dice_ = nullptr;    // of the collision in progress
    World* near_world_ = nullptr;  // its contacts' world; null: none are made
    Group* near_group_ = nullptr;
    Dice* moved_dice_ = nullptr;
    int freedom_ = 0;  // operations that callbacks of this operation may still run
};

extern const JointKind kJointKinds[];
extern const int kJointKindCount;

}  // namespace epode::sequences
