// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "runner.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <ctime>

#include "aftermath.h"
#include "exercise.h"
#include "last_words.h"

namespace hostile {
namespace {

constexpr long kExerciseEvery = 7;
constexpr double kTooSlow = 5;  // seconds of the processor for one call

bool contains(const char* text, const char* part) { return std::strstr(text, part) != nullptr; }

// Of the processor: other programs must not make a call seem slow. One that sleeps for ever is found by
// last_words.
double now()
{
    timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return double(t.tv_sec) + 1e-9 * double(t.tv_nsec);
}

bool is_zero(const Function& f, const Result& r)
{
    // Numbers of classes start at 0, so that "none" is -1 there.
    const bool of_class = contains(f.name, "GetClass") || contains(f.name, "CreateGeomClass");
    if (of_class && r.type == Result::Type::kInteger) return r.integer == -1;
    return r.real == 0 && r.integer == 0 && !r.pointer;
}

}  // namespace

Runner::Runner(std::uint64_t seed) : values_(scene_), state_(scene_), seed_(seed)
{
    reset_process();
    scene_.build();
    state_.learn();
    hash_ = state_.hash(nullptr);
}

Runner::~Runner()
{
    scene_.tear_down();
    last_words(nullptr);
}

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
    return s + ")" + (phase_ ? phase_->name : "");
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

void Runner::call_and_judge(const Function& f, const Choice& choice)
{
    called_ = true;
    for (int i = 0; i < f.count; ++i)
        arguments_[i] = values_.get(f.parameters[i].kind, choice[std::size_t(i)], i);
    const std::uint64_t before = !phase_ ? hash_ : state_.hash(nullptr);
    const long blocks = blocks_held();
    messages() = {};
    last_words([this, &f] { return described(f); });
    const double start = now();
    const Result result = f.call(arguments_);
    if (now() - start > kTooSlow) fault(f, "takes more than 5 seconds");
    const Messages said = messages();
    std::string unhealthy;
    const long held = blocks_held();
    const std::uint64_t after = state_.hash(&unhealthy);
    if (contains(f.name, "Handler")) forget_blocks(held);  // readings take memory and give it back
    ++tally_.calls;
    tally_.called.insert(&f);
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
    if (!phase_ && hostile_broken_invariant)
        if (const char* broken = hostile_broken_invariant(scene_)) fault(f, std::string("breaks ") + broken);
    // From inside some functions nothing can be destroyed.
    result_ = result;
    if (!phase_) give_back(f, arguments_, result);
}

bool Runner::perform(const Function& f, const Choice& choice)
{
    call_and_judge(f, choice);
    const bool dirty = changed_ || reset_ || (accepted_ && (is_hidden(f) || tally_.calls % 64 == 0));
    if (!dirty) return accepted_;
    if (accepted_ && tally_.rebuilt % kExerciseEvery == 0) {
        go_on(f);
        std::string unhealthy;
        state_.hash(&unhealthy);
        if (!unhealthy.empty()) fault(f, "after some steps something is not finite: " + unhealthy);
    }
    rebuild();
    return accepted_;
}

void Runner::perform_with(const Function& f, Choice choice,
                          std::initializer_list<std::pair<int, int>> changes)
{
    for (const auto& [parameter, value] : changes) {
        if (value < 0) return;
        choice[std::size_t(parameter)] = value;
    }
    perform(f, choice);
}

void Runner::go_on(const Function& f)
{
    ++tally_.exercised;
    if (!exercise(scene_)) fault(f, "afterwards dCollide gives a contact that is not finite");
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

// Of every parameter one value of each trait, so that a small budget has asked for every refusal.
void Runner::one_of_each(const Function& f, const Choice& base)
{
    for (int i = 0; i < f.count; ++i) {
        const Kind kind = f.parameters[i].kind;
        const int count = values_.count(kind);
        std::array<int, kTraits> chosen, seen{};
        chosen.fill(-1);
        for (int v = 1; v < count; ++v) {
            const auto trait = std::size_t(values_.trait(kind, v));
            if (below(++seen[trait]) == 0) chosen[trait] = v;
        }
        for (int v : chosen) perform_with(f, base, {{i, v}});
    }
}

void Runner::singles(const Function& f, const Choice& base, long budget)
{
    int all = 0;
    for (const Parameter& p : f.all()) all += values_.count(p.kind);
    for (int i = 0; i < f.count; ++i)
        for (int v = 0; v < values_.count(f.parameters[i].kind); ++v)
            if (below(all) < budget) perform_with(f, base, {{i, v}});
}

void Runner::pairs(const Function& f, const Choice& base, long budget)
{
    const long end = tally_.calls + budget;
    for (int i = 0; i < f.count; ++i)
        for (int j = 0; j < i; ++j)
            for (int v = 0; v < values_.count(f.parameters[i].kind); ++v)
                for (int w = 0; w < values_.count(f.parameters[j].kind); ++w) {
                    if (tally_.calls >= end) return;
                    perform_with(f, base, {{i, v}, {j, w}});
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

void Runner::set_scene_for(const Function& f)
{
    const bool threads = uses_threads(f);
    if (threads == scene_.with_threads) return;
    scene_.tear_down();
    scene_.with_threads = threads;
    scene_.build();
    hash_ = state_.hash(nullptr);
}

void Runner::run_any(long budget)
{
    const Function& f = functions()[std::size_t(below(int(functions().size())))];
    set_scene_for(f);
    if (f.count > 1) random_ones(f, Choice(std::size_t(f.count), 0), budget);
}

void Runner::run(const Function& f, long budget)
{
    const long first = tally_.calls;
    set_scene_for(f);
    Choice base;
    if (!find_base(f, base)) fault(f, "is never accepted");
    if (f.count > 0 && !all_combinations(f, budget)) {
        const auto left = [&] { return std::max(0l, budget - (tally_.calls - first)); };
        one_of_each(f, base);
        singles(f, base, left() * 2 / 3);
        pairs(f, base, left() / 2);
        random_ones(f, base, left());
    }
}

// ---- inside functions of the program ----

// Lets the library call a function of the program, which makes the call.
void Runner::run_inside(const Function& f, const Phase& phase, long budget)
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
    phase_ = &phase;
    if (f.count == 0) budget = std::min(budget, 4l);  // always the same call
    for (long n = 0; n < budget; ++n) {
        order.choice.clear();
        for (const Parameter& p : f.all()) {
            // Mostly live objects: they have the consequences.
            const int all = values_.count(p.kind);
            const int live = is_handle(p.kind) ? int(scene_.live[std::size_t(p.kind)].size()) : all;
            order.choice.push_back(below(below(4) ? live : all));
        }
        called_ = false;
        g_hooks.*phase.hook = {act, &order};
        phase.enter(scene_, random() % 2);
        g_hooks = {};
        if (called_) give_back(f, arguments_, result_);
        if (!called_) fault(f, "the library did not call the program");
        if (accepted_ && n % 4 == 0) go_on(f);
        rebuild();
    }
    phase_ = nullptr;
}

void Runner::report() const
{
    for (const auto& [what, f] : faults_)
        std::printf("FAULT %s\n      %ld times, first: %s\n", what.c_str(), f.count, f.example.c_str());
    std::printf(
        "%ld calls of %zu functions: %ld accepted, %ld refused; %ld scenes built, %ld stepped on; %zu "
        "readings "
        "a state; %zu faults\n",
        tally_.calls, tally_.called.size(), tally_.accepted, tally_.refused, tally_.rebuilt, tally_.exercised,
        state_.readings(), faults_.size());
}

}  // namespace hostile
