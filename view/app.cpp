// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See app.h. Mouse: left drag turns, right or middle drag shifts, the wheel comes closer, a double click
// picks, a drag with Ctrl pulls at what was under the pointer, in the plane that faces the viewer.
#include "view/app.h"

#include <imgui.h>

#include <cmath>
#include <cstdio>

#include "view/overlays.h"
#include "view/session/playback.h"

namespace epode::view {

namespace {

int scene_number(const std::string& name)
{
    const auto& all = scenes::all_recipes();
    for (size_t i = 0; i < all.size(); ++i) {
        if (name == all[i]->name) return int(i);
    }
    return -1;
}

std::unique_ptr<Session> open_scene(const scenes::Recipe& recipe, const ViewOptions& options,
                                    std::string& problem)
{
    LiveOptions live;
    const scenes::Setting setting = scenes::recommended(recipe);  // what `epode run` does
    live.stepper = setting.stepper, live.world_contacts = options.stepper.empty() && setting.world_contacts;
    if (!options.stepper.empty() && !scenes::stepper_named(options.stepper, live.stepper)) {
        problem = scenes::no_such_stepper(options.stepper);
        return nullptr;
    }
    if (!scenes::available(live.stepper)) {
        problem = "the library has no stepper '" + std::string(scenes::name_of(live.stepper)) + "'";
        return nullptr;
    }
    live.dt = options.dt > 0 ? options.dt : recipe.dt;
    live.iterations = options.iterations;
    live.threads = options.threads;
    live.diagnose = options.diagnose;
    live.seed = options.seed;
    return std::make_unique<Live>(recipe, live);
}

}  // namespace

bool App::open(const std::string& what, std::string& problem)
{
    std::unique_ptr<Session> session;
    if (what.ends_with(".epr")) {
        session = Playback::open(what, problem);
        if (session && !problem.empty()) note_ = problem, note_until_ = clock_ + 10;
    } else if (const scenes::Recipe* recipe = scenes::find_recipe(what)) {
        session = open_scene(*recipe, options_, problem);
    } else {
        problem =
            "there is no scene '" + what + "', nor does it end in .epr. Scenes:" + scenes::scene_names();
    }
    if (!session) return false;
    session->paused = session_ ? session_->paused : options_.paused;
    session->speed = session_ ? session_->speed : 1;
    session_ = std::move(session);
    what_ = what;
    drawing_.forget();
    picked_ = record::kNobody;
    picked_geom_ = record::kNoGeom;
    following_ = false;
    look_from_scene();
    return true;
}

void App::look_at_everything()
{
    following_ = false;
    const viewer::Picture picture = drawing_.picture(*session_, record::kNobody);
    if (!picture.shapes.empty())
        orbit_.look_like(viewer::frame_shapes(picture.shapes, float(Orbit::kAspect)));
}

void App::look_from_scene()
{
    Live* live = session_->live();
    if (!live || !live->scene().view.set) {
        look_at_everything();
        return;
    }
    const scenes::View& view = live->scene().view;
    orbit_.look({view.eye[0], view.eye[1], view.eye[2]}, {view.target[0], view.target[1], view.target[2]});
    follow_from_start(*live);
    hold_what_moves();
}

// A view that follows a body has been composed around the origin.
void App::follow_from_start(Live& live)
{
    const scenes::View& view = live.scene().view;
    if (!view.follow) return;
    const auto& bodies = live.scene().bodies();
    for (size_t i = 0; i < bodies.size(); ++i) {
        if (bodies[i] == view.follow) {
            const Vec at = vec(session_->moment().bodies[i]->pose.pos);
            orbit_.shift({at.x, at.y, 0});
        }
    }
}

void App::hold_what_moves()
{
    std::vector<Vec> points;
    for (const record::BodyState* body : session_->moment().bodies) {
        if (body && std::isfinite(scenes::length(vec(body->pose.pos)))) points.push_back(vec(body->pose.pos));
    }
    orbit_.hold(points);
}

void App::follow()
{
    const Moment now = session_->moment();
    if (!following_ || picked_ < 0 || !now.bodies[size_t(picked_)]) return;
    const Vec at = vec(now.bodies[size_t(picked_)]->pose.pos);
    if (std::isfinite(scenes::length(at))) orbit_.shift(at - followed_);
    followed_ = at;
}

void App::key(const std::string& name, bool repeated)
{
    const ActionRow* row = action_of(name);
    if (row && (!repeated || row->repeats)) act(row->action);
}

bool* App::switch_of(Action action)
{
    Switches& s = drawing_.switches;
    switch (action) {
        case Action::kGeoms:
            return &s.geoms;
        case Action::kWireframe:
            return &s.wireframe;
        case Action::kAxes:
            return &s.body_axes;
        case Action::kJoints:
            return &s.joints;
        case Action::kJointAxes:
            return &s.joint_axes;
        case Action::kLimits:
            return &s.limits;
        case Action::kContacts:
            return &s.contacts;
        case Action::kForces:
            return &s.forces;
        case Action::kBoxes:
            return &s.boxes;
        case Action::kShadows:
            return &s.shadows;
        case Action::kPanels:
            return &panels_;
        case Action::kHelp:
            return &help_;
        default:
            return nullptr;
    }
}

void App::act(Action action)
{
    if (bool* on = switch_of(action)) {
        *on = !*on;
        return;
    }
    Session& session = *session_;
    switch (action) {
        case Action::kPause:
            session.paused = !session.paused;
            break;
        case Action::kStep:
            session.paused = true;
            session.step();
            break;
        case Action::kStepBack:
            session.paused = true;
            session.step_back();
            break;
        case Action::kRestart:
            session.restart();
            break;
        case Action::kStart:
            session.paused = true;
            session.seek(session.stage().first());
            break;
        case Action::kEnd:
            session.paused = true;
            session.seek(session.stage().last());
            break;
        case Action::kFaster:
            session.faster();
            break;
        case Action::kSlower:
            session.slower();
            break;
        case Action::kRealTime:
            session.speed = 1;
            break;
        case Action::kNextScene:
            other_scene(1);
            break;
        case Action::kPreviousScene:
            other_scene(-1);
            break;
        case Action::kQuit:
            quit_ = true;
            break;
        case Action::kPaint:
            drawing_.switches.paint = Paint((int(drawing_.switches.paint) + 1) % 4);
            break;
        case Action::kFrame:
            look_at_everything();
            break;
        case Action::kFollow:
            following_ = !following_ && picked_ != record::kNobody;
            if (following_) {
                followed_ = vec(session.moment().bodies[size_t(picked_)]->pose.pos);
                orbit_.aim(followed_);
            }
            break;
        case Action::kShove:
            push();
            break;
        case Action::kShoot:
            shoot();
            break;
        case Action::kLetGo:
            picked_ = record::kNobody;
            picked_geom_ = record::kNoGeom;
            break;
        default:
            break;
    }
}

void App::other_scene(int by)
{
    const auto& all = scenes::all_recipes();
    const int count = int(all.size()), now = scene_number(what_);
    const int next = now < 0 ? 0 : (now + by + count) % count;
    std::string problem;
    if (!open(all[size_t(next)]->name, problem)) note_ = problem, note_until_ = clock_ + 6;
}

void App::pick(double x, double y)
{
    const Ray ray = orbit_.ray(x, y);
    const auto hit = session_->pick(ray.origin, ray.direction);
    picked_ = hit ? hit->body : record::kNobody;
    picked_geom_ = hit ? hit->geom : record::kNoGeom;
    if (picked_ == record::kNobody) return;
    const record::Pose& pose = session_->moment().bodies[size_t(picked_)]->pose;
    picked_local_ = scenes::rotate(scenes::inverse(turn_of(pose.turn)), hit->point - vec(pose.pos));
}

void App::push()
{
    Live* live = session_->live();
    if (!live || picked_ == record::kNobody) return;
    Vec right, up, forward;
    orbit_.axes(right, up, forward);
    const record::Pose& pose = session_->moment().bodies[size_t(picked_)]->pose;
    const double mass = session_->stage().bodies()[size_t(picked_)].mass;
    live->push(picked_, place(pose, picked_local_), (mass * push_speed_) * forward);
}

// A ball as large as what moves there, and three times as heavy.
void App::shoot()
{
    Live* live = session_->live();
    if (!live) return;
    Vec right, up, forward;
    orbit_.axes(right, up, forward);
    double mass = 0;
    int count = 0;
    for (const record::Body& body : session_->stage().bodies()) {
        if (body.kinematic || !(body.mass > 0)) continue;
        mass += body.mass;
        ++count;
    }
    const double radius = 0.6 * fitting_size(session_->stage(), session_->moment());
    live->shoot(orbit_.eye() + (2 * radius) * forward, shot_speed_ * forward, radius,
                count ? 3 * mass / count : 1);
}

void App::grab_or_pull(double x, double y)
{
    Live* live = session_->live();
    if (!live) return;
    const Ray ray = orbit_.ray(x, y);
    Vec right, up, forward;
    orbit_.axes(right, up, forward);
    if (live->grabbed() == record::kNobody) {
        pick(x, y);
        if (picked_ == record::kNobody) return;
        const Vec point = place(session_->moment().bodies[size_t(picked_)]->pose, picked_local_);
        grab_depth_ = scenes::dot(point - ray.origin, forward);
        live->grab(picked_, point);
    }
    live->pull_to(ray.origin + (grab_depth_ / scenes::dot(ray.direction, forward)) * ray.direction);
}

void App::use_mouse()
{
    const ImGuiIO& io = ImGui::GetIO();
    Live* live = session_->live();
    const bool grabbing = live && live->grabbed() != record::kNobody;
    const auto free_click = [&](int button) { return ImGui::IsMouseClicked(button) && !io.WantCaptureMouse; };
    if (free_click(0)) {
        if (io.KeyCtrl)
            grab_or_pull(double(io.MousePos.x), double(io.MousePos.y));
        else
            turning_ = true;
    }
    if (free_click(1) || free_click(2)) panning_ = true;
    if (!ImGui::IsMouseDown(0)) {
        turning_ = false;
        if (grabbing) live->release();
    } else if (grabbing) {
        grab_or_pull(double(io.MousePos.x), double(io.MousePos.y));
    }
    if (!ImGui::IsMouseDown(1) && !ImGui::IsMouseDown(2)) panning_ = false;
    if (turning_) orbit_.turn(double(io.MouseDelta.x), double(io.MouseDelta.y));
    if (panning_) orbit_.pan(double(io.MouseDelta.x), double(io.MouseDelta.y));
    if (io.WantCaptureMouse) return;
    if (io.MouseWheel != 0) orbit_.zoom(double(io.MouseWheel));
    if (ImGui::IsMouseDoubleClicked(0) && !io.KeyCtrl) pick(double(io.MousePos.x), double(io.MousePos.y));
}

void App::frame(double seconds, int width, int height)
{
    clock_ += seconds;
    orbit_.set_area(clear_area(width, height));
    use_mouse();
    session_->pass(seconds, patient_ ? 1e9 : 0.05);
    follow();
    menus();
    if (panels_) panels();
    if (help_) help();
    note();
    drawing_.switches.soft_light = drawing_.switches.soft_light || fine_;
    picture_ = drawing_.picture(*session_, picked_);
    picture_.camera = orbit_.camera();
    picture_.width = width;
    picture_.height = height;
}

std::string App::summary() const
{
    const State& state = session_->state();
    std::string text = session_->title();
    char figures[160];
    std::snprintf(figures, sizeof figures,
                  " state %zu time %.6g %s speed %g picked %d contacts %zu panels %d help %d",
                  session_->now(), state.step.time, session_->paused ? "paused" : "running", session_->speed,
                  int(picked_), state.step.contacts.size(), int(panels_), int(help_));
    text += figures;
    if (const Live* live = session_->live())
        text += std::string(" stepper ") + scenes::name_of(live->options.stepper) +
                (live->options.world_contacts ? " world contacts" : " contact joints");
    return text;
}

}  // namespace epode::view
