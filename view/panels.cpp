// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The panels of the left side and the menus. Panels hold what one turns while a scene runs; every key of
// actions.h is a line of a menu.
#include <imgui.h>

#include <algorithm>

#include "scenes/extensions.h"
#include "view/app.h"

namespace epode::view {

namespace {

// At the left; of a narrow window at most half.
float panel_width(float window) { return std::min(320.0f, 0.5f * window); }

void row(const char* name, const char* format, double a, double b, double c)
{
    ImGui::TextDisabled("%s", name);
    ImGui::SameLine(96);
    ImGui::Text(format, a, b, c);
}

}  // namespace

WindowArea App::clear_area(int width, int height) const
{
    const double left = panels_ ? double(panel_width(float(width))) : 0,
                 top = double(ImGui::GetFrameHeight());
    return {width, height, left, top, width - left, height - top};
}

void App::menus()
{
    if (!ImGui::BeginMainMenuBar()) return;
    const char* open_menu = "";
    bool is_open = false;
    for (const ActionRow& action : actions()) {
        if (std::string(open_menu) != action.menu) {
            if (is_open) ImGui::EndMenu();
            open_menu = action.menu;
            is_open = ImGui::BeginMenu(action.menu);
        }
        if (is_open && ImGui::MenuItem(action.label, shown(action.keys.front()).c_str())) act(action.action);
    }
    if (is_open) ImGui::EndMenu();
    const State& state = session_->state();
    ImGui::TextDisabled("   %s   %.3f s   x%g%s", session_->title().c_str(), state.step.time, session_->speed,
                        session_->paused ? "   paused" : "");
    ImGui::EndMainMenuBar();
}

void App::panels()
{
    const ImGuiIO& io = ImGui::GetIO();
    const float top = ImGui::GetFrameHeight();
    ImGui::SetNextWindowPos({0, top}, ImGuiCond_Always);
    ImGui::SetNextWindowSize({panel_width(io.DisplaySize.x), io.DisplaySize.y - top}, ImGuiCond_Always);
    ImGui::SetNextWindowBgAlpha(0.82f);
    const ImGuiWindowFlags flags =
        ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove;
    if (ImGui::Begin("Panels", nullptr, flags)) {
        run_panel();
        dials_panel();
        solver_panel();
        drawing_panel();
        body_panel();
        diagnosis_panel();
        plots_panel();
    }
    ImGui::End();
}

void App::timeline()
{
    const Stage& stage = session_->stage();
    int now = int(session_->now());
    ImGui::SetNextItemWidth(-1);
    if (ImGui::SliderInt("##timeline", &now, int(stage.first()), int(stage.last()), "state %d",
                         ImGuiSliderFlags_AlwaysClamp)) {
        session_->paused = true;
        session_->seek(size_t(now));
    }
}

void App::run_panel()
{
    if (!ImGui::CollapsingHeader("Run", ImGuiTreeNodeFlags_DefaultOpen)) return;
    Live* live = session_->live();
    ImGui::SetNextItemWidth(-1);
    if (ImGui::BeginCombo("##scene", session_->title().c_str())) {
        for (const scenes::Recipe* recipe : scenes::all_recipes()) {
            std::string problem;
            const bool chosen = ImGui::Selectable(recipe->name, what_ == recipe->name);
            if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", recipe->description);
            if (chosen && !open(recipe->name, problem)) note_ = problem, note_until_ = clock_ + 6;
        }
        ImGui::EndCombo();
        live = session_->live();
    }
    if (ImGui::Button("<|")) act(Action::kRestart);
    ImGui::SameLine();
    ImGui::PushButtonRepeat(true);
    if (ImGui::Button(" < ")) act(Action::kStepBack);
    ImGui::PopButtonRepeat();
    ImGui::SameLine();
    if (ImGui::Button(session_->paused ? " Run " : "Pause")) act(Action::kPause);
    ImGui::SameLine();
    ImGui::PushButtonRepeat(true);
    if (ImGui::Button(" > ")) act(Action::kStep);
    ImGui::PopButtonRepeat();
    ImGui::SameLine();
    if (ImGui::Button("-")) session_->slower();
    ImGui::SameLine();
    ImGui::Text("x%-5g", session_->speed);
    ImGui::SameLine();
    if (ImGui::Button("+")) session_->faster();
    timeline();
    const State& state = session_->state();
    ImGui::Text("%.3f s   %zu bodies   %zu contacts", state.step.time, session_->stage().bodies().size(),
                state.step.contacts.size());
    if (live) {
        if (ImGui::Button("Shoot")) shoot();
        ImGui::SameLine();
        auto speed = float(shot_speed_);
        ImGui::SetNextItemWidth(110);
        if (ImGui::SliderFloat("m/s##shot", &speed, 0.5f, 100, "%.1f", ImGuiSliderFlags_Logarithmic))
            shot_speed_ = double(speed);
    }
    if (live && live->failed())
        ImGui::TextColored({1, 0.4f, 0.3f, 1}, "the step failed, or numbers are not finite");
}

// Ctrl-click on a slider types a number.
void App::dials_panel()
{
    Live* live = session_->live();
    if (!live || live->scene().dials.empty()) return;
    if (!ImGui::CollapsingHeader("Axes and controls", ImGuiTreeNodeFlags_DefaultOpen)) return;
    for (const scenes::Dial& dial : live->scene().dials) {
        auto value = float(dial.value());
        const std::string format = std::string("%.3f ") + dial.unit;
        ImGui::SetNextItemWidth(0.5f * panel_width(ImGui::GetIO().DisplaySize.x));
        if (ImGui::SliderFloat(dial.name.c_str(), &value, float(dial.low), float(dial.high), format.c_str(),
                               ImGuiSliderFlags_AlwaysClamp))
            dial.turn(double(value));
    }
}

void App::solver_panel()
{
    Live* live = session_->live();
    if (!ImGui::CollapsingHeader("Solver", ImGuiTreeNodeFlags_DefaultOpen)) return;
    if (!live) {
        for (const auto& [key, value] : session_->stage().about())
            ImGui::Text("%s: %s", key.c_str(), value.c_str());
        return;
    }
    for (scenes::Stepper stepper : scenes::kSteppers) {
        if (!scenes::available(stepper)) continue;
        if (stepper != scenes::Stepper::kExact) ImGui::SameLine();
        if (ImGui::RadioButton(scenes::name_of(stepper), live->options.stepper == stepper))
            live->options.stepper = stepper;
    }
    ImGui::PushItemWidth(150);
    if (live->options.stepper != scenes::Stepper::kExact)
        ImGui::SliderInt(live->options.stepper == scenes::Stepper::kQuick ? "iterations" : "substeps",
                         &live->options.iterations, 0, 200, live->options.iterations ? "%d" : "its own");
    if (scenes::has_step_threads()) ImGui::SliderInt("threads", &live->options.threads, 1, 16);
    float ms = float(1e3 * live->options.dt);
    if (ImGui::SliderFloat("step, ms", &ms, 0.2f, 40, "%.2f", ImGuiSliderFlags_Logarithmic) && ms > 0)
        live->options.dt = 1e-3 * double(ms);
    ImGui::PopItemWidth();
}

void App::drawing_panel()
{
    if (!ImGui::CollapsingHeader("Show")) return;
    const auto checked = [&](const char* label, Action action) {
        ImGui::Checkbox(label, switch_of(action));
        ImGui::SameLine(panel_width(ImGui::GetIO().DisplaySize.x) - 50);
        ImGui::TextDisabled("%s", shown(row_of(action).keys.front()).c_str());
    };
    Switches& s = drawing_.switches;
    checked("geoms", Action::kGeoms);
    checked("wireframe", Action::kWireframe);
    checked("contacts", Action::kContacts);
    checked("forces of contacts", Action::kForces);
    ImGui::SetNextItemWidth(150);
    ImGui::SliderFloat("arrows", &s.arrows, 0.05f, 20, "x%.2f", ImGuiSliderFlags_Logarithmic);
    checked("joints", Action::kJoints);
    checked("axes of joints", Action::kJointAxes);
    checked("limits of joints", Action::kLimits);
    checked("axes of bodies", Action::kAxes);
    checked("bounding boxes", Action::kBoxes);
    checked("shadows", Action::kShadows);
    ImGui::Checkbox("soft light (slow)", &s.soft_light);
    ImGui::Checkbox("pale when asleep", &s.pale_sleepers);
    const char* const paints[] = {"body", "island", "sleep", "speed"};
    int paint = int(s.paint);
    ImGui::SetNextItemWidth(150);
    if (ImGui::Combo("colour by", &paint, paints, 4)) s.paint = Paint(paint);
}

void App::body_panel()
{
    if (!ImGui::CollapsingHeader("Picked", ImGuiTreeNodeFlags_DefaultOpen)) return;
    if (picked_geom_ == record::kNoGeom) {
        ImGui::TextDisabled("double-click picks, Ctrl-drag pulls");
        return;
    }
    const Stage& stage = session_->stage();
    const record::Shape& shape = stage.shapes()[stage.geoms()[picked_geom_].shape];
    const Moment now = session_->moment();
    if (picked_ == record::kNobody || !now.bodies[size_t(picked_)]) {
        ImGui::Text("geom %u, a static %s", picked_geom_, record::name_of(shape.kind));
        return;
    }
    const auto i = size_t(picked_);
    const record::BodyState& b = *now.bodies[i];
    ImGui::Text("body %d, %s%s, %.4g kg", picked_, record::name_of(shape.kind),
                now.asleep[i] ? ", asleep" : "", stage.bodies()[i].mass);
    row("position", "%.4f %.4f %.4f m", b.pose.pos[0], b.pose.pos[1], b.pose.pos[2]);
    row("velocity", "%.3f %.3f %.3f m/s", b.linear[0], b.linear[1], b.linear[2]);
    row("spin", "%.3f %.3f %.3f rad/s", b.angular[0], b.angular[1], b.angular[2]);
    ImGui::TextDisabled("turn");
    ImGui::SameLine(96);
    ImGui::Text("%.3f %.3f %.3f %.3f", b.pose.turn[0], b.pose.turn[1], b.pose.turn[2], b.pose.turn[3]);
    ImGui::Checkbox("follow", &following_);
    if (ImGui::IsItemClicked()) followed_ = vec(b.pose.pos);
    if (!session_->live()) return;
    ImGui::SameLine();
    if (ImGui::Button("Push")) push();
    ImGui::SameLine();
    auto speed = float(push_speed_);
    ImGui::SetNextItemWidth(90);
    if (ImGui::SliderFloat("m/s", &speed, 0.1f, 50, "%.1f", ImGuiSliderFlags_Logarithmic))
        push_speed_ = double(speed);
}

void App::note()
{
    if (clock_ >= note_until_) return;
    const ImGuiIO& io = ImGui::GetIO();
    ImGui::SetNextWindowPos({io.DisplaySize.x * 0.5f, io.DisplaySize.y - 40}, ImGuiCond_Always, {0.5f, 1});
    ImGui::Begin("Note", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize |
                     ImGuiWindowFlags_NoInputs | ImGuiWindowFlags_NoFocusOnAppearing);
    ImGui::TextUnformatted(note_.c_str());
    ImGui::End();
}

}  // namespace epode::view
