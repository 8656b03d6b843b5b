// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "runner.h"

#include <cmath>
#include <cstdio>
#include <cstring>
#include <ctime>

#include "last_words.h"

namespace hostile {
namespace {

constexpr long kExerciseEvery = 7;
constexpr double kTooSlow = 5;  // seconds for one call, on a busy machine

bool begins(const char* text, const char* with) { return std::strncmp(text, with, std::strlen(with)) == 0; }
bool contains(const char* text, const char* part) { return std::strstr(text, part) != nullptr; }

// Touches what belongs to the process and not to the scene.
bool is_global(const Function& f)
{
    for (const char* name : {"dExternal", "dInit", "dClose", "dSet", "dAllocateODE", "dCleanup",
                             "dCreateGeomClass", "dRand", "dMakeRandom", "dThreading"})
        if (begins(f.name, name)) return true;
    return false;
}

// Changes something that no reader shows.
bool is_hidden(const Function& f)
{
    for (const char* part :
         {"Destroy", "dCooper", "dResource", "dEstimate", "dWorldSetStep", "dWorldUse", "MovedCallback"})
        if (contains(f.name, part)) return true;
    return false;
}

bool uses_threads(const Function& f)
{
    for (const Parameter& p : f.all())
        if (p.kind == Kind::kThreadPool) return true;
    return false;
}

double now()
{
    timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return double(t.tv_sec) + 1e-9 * double(t.tv_nsec);
}

bool is_zero(const Function& f, const Result& r)
{
    // Numbers of classes start at 0, so that "none" is -1 there.
    const bool of_class = contains(f.name, "GetClass") || contains(f.name, "CreateGeomClass");
    if (of_class && r.type == Result::Type::kInteger) return r.integer == -1;
    return r.real == 0 && r.integer == 0 && !r.pointer;
}

// ---- the world goes on ----

struct Collision {
    dWorldID world;
    dJointGroupID group;
    int made = 0;
    bool sane = true;
};

bool sane(const dContactGeom& c)
{
    for (int i = 0; i < 3; ++i)
        if (!std::isfinite(c.pos[i]) || !std::isfinite(c.normal[i])) return false;
    return std::isfinite(c.depth);
}

void make_contacts(void* data, dGeomID a, dGeomID b)
{
    Collision& collision = *static_cast<Collision*>(data);
    if (dGeomIsSpace(a) || dGeomIsSpace(b)) {
        dSpaceCollide2(a, b, data, make_contacts);
        return;
    }
    dContactGeom found[8];
    const int count = dCollide(a, b, 8, found, sizeof found[0]);
    for (int i = 0; i < count; ++i) {
        if (!sane(found[i])) collision.sane = false;
        if (collision.made >= 100) continue;
        ++collision.made;
        dContact contact{};
        contact.surface.mode = dContactApprox1;
        contact.surface.mu = 1;
        contact.geom = found[i];
        const dJointID joint = dJointCreateContact(collision.world, collision.group, &contact);
        if (dGeomGetClass(a) != dRayClass && dGeomGetClass(b) != dRayClass)
            dJointAttach(joint, dGeomGetBody(a), dGeomGetBody(b));
    }
}

}  // namespace

Runner::Runner(std::uint64_t seed) : values_(scene_), state_(scene_), seed_(seed)
{
    reset_process();
    scene_.build();
    state_.learn();
    hash_ = state_.hash(nullptr);
}

Runner::~Runner() { scene_.tear_down(); }

std::uint64_t Runner::random()
{
    std::uint64_t z = (seed_ += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
}

void Runner::rebuild()
{
    ++tally_.rebuilt;
    scene_.tear_down();
    if (reset_ || tally_.rebuilt % 512 == 0) reset_process();
    reset_ = false;
    scene_.build();
    hash_ = state_.hash(nullptr);
    messages() = {};
}

std::string Runner::described(const Function& f) const
{
    std::string s = std::string(f.name) + "(";
    for (int i = 0; i < f.count; ++i) {
        if (i) s += ", ";
        const Kind kind = f.parameters[i].kind;
        s += arguments_[i].text;
        if (is_handle(kind) && arguments_[i].trait == Trait::kFine) {
            const auto& live = scene_.live[std::size_t(kind)];
            for (std::size_t k = 0; k < live.size(); ++k)
                if (live[k] == arguments_[i].pointer)
                    s += std::string(" ") + name_of(kind) + " " + std::to_string(k);
        }
    }
    static constexpr const char* kInside[] = {"",
                                              " inside a near callback",
                                              " inside a moved callback",
                                              " inside a box function",
                                              " inside a box test",
                                              " inside a collider",
                                              " inside a height function",
                                              " inside a destructor function"};
    return s + ")" + kInside[int(phase_)];
}

void Runner::fault(const Function& f, const std::string& rule)
{
    Fault& entry = faults_[std::string(f.name) + ": " + rule];
    if (entry.count++ == 0) entry.example = described(f);
}

// The parameter for whose value the call must be refused, or null.
const char* Runner::must_refuse(const Function& f) const
{
    for (int i = 0; i < f.count; ++i) {
        const Parameter& p = f.parameters[i];
        if (p.flags & kNotRead) continue;
        const bool scalar = p.kind == Kind::kReal;
        switch (arguments_[i].trait) {
            case Trait::kBad:
                return p.name;
            case Trait::kNull:
                if (!(p.flags & kMayBeNull)) return p.name;
                break;
            case Trait::kNaN:
                if (scalar ? !(p.flags & kAnyNumber) : (p.flags & kInput) != 0) return p.name;
                break;
            default:
                break;
        }
    }
    return nullptr;
}

void Runner::judge_refused(const Function& f, const Result& r, long blocks)
{
    const Messages& m = messages();
    if (m.refusals > 1) fault(f, "several messages");
    if (m.odd) fault(f, "a message without d_ERR_UASSERT");
    if (!contains(m.text, ("in " + std::string(f.name) + "()").c_str()))
        fault(f, std::string("the message is \"") + m.text + '"');
    if (!is_zero(f, r)) fault(f, "refused, but does not answer 0");
    for (int i = 0; i < f.count; ++i)
        if (!values_.untouched(f.parameters[i].kind, i, arguments_[i]))
            fault(f, std::string("refused, but writes to ") + f.parameters[i].name);
    if (blocks_held() != blocks && !contains(f.name, "Handler"))
        fault(f, "refused, but memory has come or gone");
    if (changed_) fault(f, "refused, but the state has changed");
}

void Runner::judge_accepted(const Function& f, const Result& r)
{
    if (const char* name = must_refuse(f)) fault(f, std::string("accepts a bad ") + name);
    bool finite = true;
    for (int i = 0; i < f.count; ++i) {
        const Value& v = arguments_[i];
        if (v.trait != Trait::kFine) finite = false;
    }
    if (r.type == Result::Type::kReal && std::isnan(r.real) && finite) fault(f, "answers NaN");
}

void Runner::clean_up(const Function& f, const Result& r)
{
    auto* made = const_cast<void*>(r.pointer);
    if (contains(f.name, "dRealloc")) {
        if (made || arguments_[2].integer == 0)
            dFree(made, 64);
        else
            dFree(arguments_[0].pointer, 64);
    } else if (begins(f.name, "dAlloc") && r.type == Result::Type::kPointer) {
        dFree(made, 64);
    }
    if (!made) return;
    if (begins(f.name, "dThreadingAllocateThreadPool")) {
        dThreadingFreeThreadPool(static_cast<dThreadingThreadPoolID>(made));
    } else if (begins(f.name, "dThreadingAllocate")) {
        dThreadingFreeImplementation(static_cast<dThreadingImplementationID>(made));
    }
    if (begins(f.name, "dCooperativeCreate")) dCooperativeDestroy(static_cast<dCooperativeID>(made));
    if (begins(f.name, "dResourceRequirementsC"))
        dResourceRequirementsDestroy(static_cast<dResourceRequirementsID>(made));
    if (contains(f.name, "Acquire")) dResourceContainerDestroy(static_cast<dResourceContainerID>(made));
    if (!contains(f.name, "Create")) return;
    if (begins(f.name, "dWorldCreate")) dWorldDestroy(static_cast<dWorldID>(made));
    if (begins(f.name, "dJointGroupCreate")) dJointGroupDestroy(static_cast<dJointGroupID>(made));
    if (contains(f.name, "SpaceCreate")) dSpaceDestroy(static_cast<dSpaceID>(made));
    if (begins(f.name, "dCreate")) dGeomDestroy(static_cast<dGeomID>(made));
    if (contains(f.name, "DataCreate")) dGeomHeightfieldDataDestroy(static_cast<dHeightfieldDataID>(made));
}

void Runner::call_and_judge(const Function& f, const Choice& choice)
{
    called_ = true;
    for (int i = 0; i < f.count; ++i)
        arguments_[i] = values_.get(f.parameters[i].kind, choice[std::size_t(i)], i);
    const std::uint64_t before = phase_ == Phase::kTop ? hash_ : state_.hash(nullptr);
    const long blocks = blocks_held();
    messages() = {};
    last_words([this, &f] { return described(f); });
    const double start = now();
    const Result result = f.call(arguments_);
    if (now() - start > kTooSlow) fault(f, "takes more than 5 seconds");
    const Messages said = messages();
    std::string unhealthy;
    const std::uint64_t after = state_.hash(&unhealthy);
    ++tally_.calls;
    accepted_ = said.refusals == 0;
    changed_ = after != before;
    ++(accepted_ ? tally_.accepted : tally_.refused);
    if (contains(f.name, "dSetDebugHandler")) accepted_ = true;
    if (accepted_) {
        judge_accepted(f, result);
        if (changed_ && !unhealthy.empty()) fault(f, "leaves something that is not finite: " + unhealthy);
    } else {
        judge_refused(f, result, blocks);
    }
    if (is_global(f)) {
        restore_handlers();
        reset_ = true;
    }
    // From inside some functions nothing can be destroyed.
    result_ = result;
    if (phase_ == Phase::kTop) clean_up(f, result);
}

bool Runner::perform(const Function& f, const Choice& choice)
{
    call_and_judge(f, choice);
    const bool dirty = changed_ || reset_ || (accepted_ && (is_hidden(f) || tally_.calls % 64 == 0));
    if (!dirty) return accepted_;
    if (accepted_ && tally_.rebuilt % kExerciseEvery == 0) {
        exercise();
        std::string unhealthy;
        state_.hash(&unhealthy);
        if (!unhealthy.empty()) fault(f, "after some steps something is not finite: " + unhealthy);
    }
    rebuild();
    return accepted_;
}

void Runner::exercise()
{
    ++tally_.exercised;
    const Messages kept = messages();
    Collision collision{scene_.world, scene_.contacts};
    for (int i = 0; i < 6; ++i) {
        collision.made = 0;
        dSpaceCollide(scene_.space, &collision, make_contacts);
        const dReal h = dReal(0.01);
        if (i % 3 == 0) dWorldQuickStep(scene_.world, h);
        if (i % 3 == 1) dWorldStep(scene_.world, h);
        if (i % 3 == 2) dWorldStepFast1(scene_.world, h, 4);
        dJointGroupEmpty(scene_.contacts);
    }
    if (!collision.sane) faults_["dCollide gives a contact that is not finite"].count++;
    messages() = kept;
}

// ---- which combinations ----

// Arguments that are accepted: the first value of everything and the first handles that do; else anything.
bool Runner::find_base(const Function& f, Choice& base)
{
    base.assign(std::size_t(f.count), 0);
    std::vector<int> handles, counts;
    for (int i = 0; i < f.count; ++i)
        if (is_handle(f.parameters[i].kind)) {
            handles.push_back(i);
            counts.push_back(int(scene_.live[std::size_t(f.parameters[i].kind)].size()) + 1);
        }
    for (std::size_t k = 0; k < handles.size() || handles.empty();) {
        if (perform(f, base)) return true;
        for (k = 0; k < handles.size(); ++k) {
            int& at = base[std::size_t(handles[k])];
            if (++at < counts[k]) break;
            at = 0;
        }
        if (handles.empty()) break;
    }
    for (int n = 0; n < 3000; ++n) {
        for (int i = 0; i < f.count; ++i)
            base[std::size_t(i)] = below(3) ? 0 : below(values_.count(f.parameters[i].kind));
        for (std::size_t k = 0; k < handles.size(); ++k) base[std::size_t(handles[k])] = below(counts[k]);
        if (perform(f, base)) return true;
    }
    return false;
}

bool Runner::all_combinations(const Function& f, long budget)
{
    long product = 1;
    for (const Parameter& p : f.all()) {
        product *= values_.count(p.kind);
        if (product > budget) return false;
    }
    Choice choice(std::size_t(f.count), 0);
    for (long n = 0; n < product; ++n) {
        long rest = n;
        for (int i = 0; i < f.count; ++i) {
            const int count = values_.count(f.parameters[i].kind);
            choice[std::size_t(i)] = int(rest % count);
            rest /= count;
        }
        perform(f, choice);
    }
    return true;
}

void Runner::singles_and_pairs(const Function& f, const Choice& base, long budget)
{
    const long end = tally_.calls + budget;
    int singles = 0;
    for (const Parameter& p : f.all()) singles += values_.count(p.kind);
    for (int i = 0; i < f.count; ++i)
        for (int v = 0; v < values_.count(f.parameters[i].kind); ++v) {
            if (below(singles) >= budget) continue;  // a small budget is spread over all of them
            Choice choice = base;
            choice[std::size_t(i)] = v;
            perform(f, choice);
        }
    for (int i = 0; i < f.count; ++i)
        for (int j = 0; j < i; ++j)
            for (int v = 0; v < values_.count(f.parameters[i].kind); ++v)
                for (int w = 0; w < values_.count(f.parameters[j].kind); ++w) {
                    if (tally_.calls >= end) return;
                    Choice choice = base;
                    choice[std::size_t(i)] = v;
                    choice[std::size_t(j)] = w;
                    perform(f, choice);
                }
}

void Runner::random_ones(const Function& f, const Choice& base, long budget)
{
    for (long n = 0; n < budget; ++n) {
        Choice choice = base;
        for (int i = 0; i < f.count; ++i)
            if (below(3)) choice[std::size_t(i)] = below(values_.count(f.parameters[i].kind));
        perform(f, choice);
    }
}

void Runner::run_any(long budget)
{
    const Function& f = functions()[std::size_t(below(int(functions().size())))];
    if (f.count > 1) random_ones(f, Choice(std::size_t(f.count), 0), budget);
}

void Runner::run(const Function& f, long budget)
{
    const long first = tally_.calls;
    const bool threads = uses_threads(f);
    if (threads != scene_.with_threads) {
        scene_.tear_down();
        scene_.with_threads = threads;
        scene_.build();
        hash_ = state_.hash(nullptr);
    }
    Choice base;
    if (!find_base(f, base)) fault(f, "is never accepted");
    if (f.count > 0 && !all_combinations(f, budget)) {
        singles_and_pairs(f, base, budget * 2 / 3);
        random_ones(f, base, std::max(0l, budget - (tally_.calls - first)));
    }
}

// ---- inside functions of the program ----

// Lets the library call a function of the program, which makes the call.
void Runner::enter(Phase phase)
{
    switch (phase) {
        case Phase::kTop:
            return;
        case Phase::kNear:
            dSpaceCollide(scene_.space, nullptr, near_nothing);
            return;
        case Phase::kMoved:
            dWorldStep(scene_.world, dReal(0.01));
            return;
        case Phase::kBox:
            dGeomMoved(scene_.user_geom);
            dGeomMoved(scene_.tested_geom);
            if (random() % 2) {
                dSpaceClean(scene_.space);
            } else {
                dReal box[6];
                dGeomGetAABB(scene_.tested_geom, box);
            }
            return;
        case Phase::kBoxTest:
            dSpaceCollide2(reinterpret_cast<dGeomID>(scene_.space), scene_.tested_geom, nullptr,
                           near_nothing);
            return;
        case Phase::kCollider:
        case Phase::kHeight: {
            dContactGeom room[4];
            const dGeomID other = phase == Phase::kHeight ? scene_.high_ground : scene_.tested_geom;
            dCollide(other, scene_.probe, 4, room, sizeof room[0]);
            return;
        }
        case Phase::kEnd:
            dGeomDestroy(random() % 2 ? scene_.user_geom : scene_.tested_geom);
            return;
    }
}

void Runner::run_inside(const Function& f, Phase phase, long budget)
{
    struct Order {
        Runner* runner;
        const Function* function;
        Choice choice;
    } order{this, &f, {}};
    const auto act = [](void* data) {
        auto* o = static_cast<Order*>(data);
        o->runner->call_and_judge(*o->function, o->choice);
    };
    phase_ = phase;
    for (long n = 0; n < budget; ++n) {
        order.choice.clear();
        for (const Parameter& p : f.all()) {
            // Mostly live objects: they have the consequences.
            const int all = values_.count(p.kind);
            const int live = is_handle(p.kind) ? int(scene_.live[std::size_t(p.kind)].size()) : all;
            order.choice.push_back(below(below(4) ? live : all));
        }
        called_ = false;
        Hook hook{act, &order};
        Hook* const hooks[] = {nullptr,           &g_hooks.near,     &g_hooks.moved,  &g_hooks.box,
                               &g_hooks.box_test, &g_hooks.collider, &g_hooks.height, &g_hooks.end};
        *hooks[int(phase)] = hook;
        enter(phase);
        g_hooks = {};
        if (called_) clean_up(f, result_);
        if (!called_) fault(f, "the library did not call the program");
        if (accepted_ && n % 4 == 0) exercise();
        rebuild();
    }
    phase_ = Phase::kTop;
}

void Runner::report() const
{
    for (const auto& [what, f] : faults_)
        std::printf("FAULT %s\n      %ld times, first: %s\n", what.c_str(), f.count, f.example.c_str());
    std::printf(
        "%ld calls: %ld accepted, %ld refused; %ld scenes built, %ld stepped on; %zu readings a state; %zu "
        "faults\n",
        tally_.calls, tally_.accepted, tally_.refused, tally_.rebuilt, tally_.exercised, state_.readings(),
        faults_.size());
}

}  // namespace hostile
