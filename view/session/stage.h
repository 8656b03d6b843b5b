// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What can be looked at: the things of a world and a stretch of its states, one after each step. A running
// scene and a recording both become this, so that whatever draws, plots or scrubs knows one form only. States
// are numbered from the beginning of the run; of a long run only the last ones are kept, as many as fit into
// a given number of bytes.
#pragma once

#include <deque>

#include "record/file/recording.h"
#include "scenes/vectors.h"

namespace epode::view {

using scenes::Turn;
using scenes::Vec;

inline Vec vec(const record::Vec3& v) { return {v[0], v[1], v[2]}; }
inline Vec vec(const float* v) { return {double(v[0]), double(v[1]), double(v[2])}; }
inline Turn turn_of(const record::Quat& q) { return {q[0], q[1], q[2], q[3]}; }
inline Vec place(const record::Pose& pose, Vec local)
{
    return vec(pose.pos) + scenes::rotate(turn_of(pose.turn), local);
}

// Solver figures; recordings do not have them.
struct Figures {
    double residual = -1;  // below 0: not known
    double collide_ms = 0, step_ms = 0, empty_ms = 0;
};

struct State {
    record::Step step;
    Figures figures;
    unsigned long random = 0;  // dRandGetSeed after the step; ODE's own quick stepper shuffles by it
};

// One state, unfolded: everything by its number.
struct Moment {
    struct PlacedGeom {
        std::uint32_t number;
        std::int32_t body;   // record::kNobody: static
        record::Pose world;  // planes, too, have one; it is the identity
    };
    const record::Step* step = nullptr;
    std::vector<const record::BodyState*> bodies;  // null where the body does not live now
    std::vector<bool> asleep;
    std::vector<PlacedGeom> geoms;      // those that live
    std::vector<std::uint32_t> joints;  // those that live
};

class Stage : public record::Sink {
  public:
    // 0: keep all.
    explicit Stage(size_t most_bytes = 0) : most_bytes_(most_bytes) {}

    bool empty() const { return states_.empty(); }
    size_t first() const { return first_; }
    size_t last() const { return first_ + states_.size() - 1; }
    const State& at(size_t number) const { return states_[number - first_]; }
    State& at(size_t number) { return states_[number - first_]; }
    Moment moment(size_t number) const;

    // Forgets the states after this one.
    void cut_after(size_t number);

    const record::Info& about() const { return about_; }
    const std::vector<record::Shape>& shapes() const { return shapes_; }
    const std::vector<record::Body>& bodies() const { return bodies_; }
    const std::vector<record::Geom>& geoms() const { return geoms_; }
    const std::vector<record::Joint>& joints() const { return joints_; }

    void info(const record::Info& info) override { record::add(info, about_); }
    void calls(const record::CallBlock&) override {}  // not to be seen
    void shape(const record::Shape& shape) override { shapes_.push_back(shape); }
    void body(const record::Body& body) override;
    void geom(const record::Geom& geom) override;
    void joint(const record::Joint& joint) override;
    void gone(record::ObjectKind kind, std::uint32_t number) override;
    void moved(std::uint32_t geom, std::int32_t body, const record::Pose& pose) override;
    void step(const record::Step& step) override;

  private:
    std::uint32_t next() const { return std::uint32_t(first_ + states_.size()); }

    size_t most_bytes_, bytes_ = 0, first_ = 0;
    record::Info about_;
    std::vector<record::Shape> shapes_;
    std::vector<record::Body> bodies_;
    std::vector<record::Geom> geoms_;
    std::vector<record::Joint> joints_;
    std::vector<record::Life> body_lives_, geom_lives_, joint_lives_;
    std::vector<record::Move> moves_;
    std::deque<State> states_;
};

}  // namespace epode::view
