// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See rerun.h. Functions are looked up in the library that is there by name, and what an argument must be
// comes from their types in the headers; a call whose arguments are of other kinds is refused. Calls on
// things that live no more are passed over, as the library did when they were recorded.
#include "record/rerun/rerun.h"

#include <ode/ext.h>

#include <algorithm>
#include <chrono>
#include <climits>
#include <deque>

#include "record/watch/figures.h"
#include "record/watch/lookup.h"

#pragma GCC diagnostic ignored "-Wdeprecated-declarations"

namespace epode::record {

namespace {

// More of these in one call are a damaged file's, whatever the library thinks of them: the call would not end
// in a lifetime, or a body would take gigabytes.
constexpr int kMostSteps = 10000, kMostSweeps = 10000000, kMostSamples = 10000;
// Of all calls together, for each recorded state in the mean: a number that was damaged into a large one
// would else be paid in every step that follows.
constexpr std::int64_t kMeanSweeps = 100000;

// Of all bodies together: 48 bytes each.
constexpr std::int64_t kMostSamplesTogether = 1000000;

struct Bound {
    const char* name;
    int least, largest;  // of the call's last argument
};
constexpr const char* kBodySamples = "dBodySetAutoDisableAverageSamplesCount";
constexpr Bound kBounds[] = {
    {"dWorldSetQuickStepNumIterations", INT_MIN, kMostSweeps},
    {"dWorldSetAutoDisableAverageSamplesCount", 0, kMostSamples},
    {kBodySamples, 0, kMostSamples},
};

void* find(const std::string& name) { return library_function(name.c_str()); }

// Arguments of one call, made into what the function takes.
class Decoder {
  public:
    Decoder(Rerun& rerun, const std::vector<Argument>& given, int count)
        : rerun_(rerun), given_(given), count_(count)
    {}
    bool fits = true;   // kinds and numbers are those of the function
    bool alive = true;  // the first thing lives

    template <class Type>
    Type next()
    {
        const Argument& argument = given_[at_++];
        Type value{};
        decode(argument, value);
        return value;
    }

  private:
    bool is(const Argument& argument, ArgumentKind kind)
    {
        fits = fits && argument.kind == kind;
        return argument.kind == kind;
    }
    void decode(const Argument& argument, dWorldID& value)
    {
        if (is(argument, ArgumentKind::kWorld)) value = rerun_.world();
    }
    void decode(const Argument& argument, dBodyID& value)
    {
        if (is(argument, ArgumentKind::kBody)) value = rerun_.body(argument.handle);
        alive = alive && (value || at_ > 1);
    }
    void decode(const Argument& argument, dJointID& value)
    {
        if (is(argument, ArgumentKind::kJoint)) value = rerun_.joint(argument.handle);
        alive = alive && (value || at_ > 1);
    }
    void decode(const Argument& argument, dReal& value)
    {
        if (is(argument, ArgumentKind::kNumber)) value = dReal(argument.number);
    }
    void decode(const Argument& argument, int& value)
    {
        if (is(argument, ArgumentKind::kInteger)) value = argument.integer;
    }
    void decode(const Argument& argument, unsigned& value)
    {
        if (is(argument, ArgumentKind::kInteger)) value = unsigned(argument.integer);
    }
    void decode(const Argument& argument, const dReal*& value)
    {
        if (!is(argument, ArgumentKind::kNumbers) || argument.numbers.empty()) return;
        fits = fits && argument.numbers.size() == size_t(count_);
        if (!fits) return;
        std::vector<dReal>& kept = arrays_.emplace_back(argument.numbers.begin(), argument.numbers.end());
        kept.resize(4 * ((kept.size() + 3) / 4));  // vectors are padded to four
        value = kept.data();
    }
    void decode(const Argument& argument, const dMass*& value)
    {
        if (!is(argument, ArgumentKind::kNumbers) || argument.numbers.empty()) return;
        fits = fits && from_numbers(argument.numbers, mass_);
        value = &mass_;
    }

    Rerun& rerun_;
    const std::vector<Argument>& given_;
    int count_;
    size_t at_ = 0;
    std::deque<std::vector<dReal>> arrays_;
    dMass mass_;
};

enum class Played { kYes, kUnknown, kUnfit };

template <class... Types>
Played play_plain(Rerun& rerun, void (*function)(Types...), int count, const std::vector<Argument>& given)
{
    if (!function) return Played::kUnknown;
    if (given.size() != sizeof...(Types)) return Played::kUnfit;
    Decoder decoder(rerun, given, count);
    const std::tuple<Types...> arguments{decoder.next<Types>()...};  // in order: braces
    if (!decoder.fits) return Played::kUnfit;
    if (decoder.alive) std::apply(function, arguments);
    return Played::kYes;
}

using Player = Played (*)(Rerun&, const std::vector<Argument>&);

const std::map<std::string, Player>& players()
{
#define CALL(name, count, parameters, names)                                             \
    {#name, [](Rerun& rerun, const std::vector<Argument>& given) {                       \
         static const auto function = reinterpret_cast<void(*) parameters>(find(#name)); \
         return play_plain(rerun, function, count, given);                               \
     }},
    static const std::map<std::string, Player> table = {
#include "record/file/calls.inc"
    };
#undef CALL
    return table;
}

bool is(const std::vector<Argument>& given, std::initializer_list<ArgumentKind> kinds)
{
    if (given.size() != kinds.size()) return false;
    size_t i = 0;
    for (ArgumentKind kind : kinds) {
        if (given[i++].kind != kind) return false;
    }
    return true;
}

bool is_absurd(const std::string& name, const std::vector<Argument>& given)
{
    for (const Bound& bound : kBounds) {
        const int count = given.empty() ? 0 : given.back().integer;
        if (name == bound.name && (count < bound.least || count > bound.largest)) return true;
    }
    return false;
}

constexpr const char* kSteps[] = {"dWorldStep", "dWorldQuickStep", "dWorldStepFast1", "dWorldStepHybrid",
                                  "dWorldsStep"};

}  // namespace

Rerun::Rerun(const Recording& was, const RerunOptions& options)
    : was_(was), options_(options), world_(dWorldCreate())
{
    if (options.find_contacts) found_ = std::make_unique<FoundContacts>(was, world_);
}

Rerun::~Rerun()
{
    found_.reset();
    for (const Group& group : groups_) dJointGroupDestroy(group.group);
    dWorldDestroy(world_);
}

bool Rerun::refuse(const std::string& why)
{
    problem_ = why;
    return false;
}

dBodyID Rerun::body(std::int32_t number) const
{
    return number >= 0 && size_t(number) < bodies_.size() ? bodies_[size_t(number)] : nullptr;
}

dJointID Rerun::joint(std::int32_t number) const
{
    return number >= 0 && size_t(number) < joints_.size() ? joints_[size_t(number)] : nullptr;
}

// Groups are numbered in the order in which they are named first.
dJointGroupID Rerun::group(std::int32_t number)
{
    if (number < 0) return nullptr;
    if (size_t(number) == groups_.size()) groups_.push_back({dJointGroupCreate(0), {}});
    return size_t(number) < groups_.size() ? groups_[size_t(number)].group : nullptr;
}

void Rerun::keep_joint(dJointID joint, std::int32_t group)
{
    if (group >= 0 && size_t(group) < groups_.size())
        groups_[size_t(group)].members.push_back(std::int32_t(joints_.size()));
    joints_.push_back(joint);
}

void Rerun::make_contact(const std::vector<Argument>& arguments)
{
    dContact contact;
    dJointGroupID in = group(arguments[1].handle);
    const bool sound = from_numbers(arguments[2].numbers, contact);
    if (sound) surfaces_.push_back(contact.surface);
    keep_joint(sound && !found_ ? dJointCreateContact(world_, in, &contact) : nullptr, arguments[1].handle);
}

bool Rerun::make(const std::string& name, const std::vector<Argument>& arguments)
{
    using enum ArgumentKind;
    if (name == "dBodyCreate" && is(arguments, {kWorld})) {
        bodies_.push_back(dBodyCreate(world_));
        return true;
    }
    if (name == "dJointCreateContact" && is(arguments, {kWorld, kGroup, kNumbers})) {
        make_contact(arguments);
        return true;
    }
    const bool a_joint = name.starts_with("dJointCreate") && name != "dJointCreateContact";
    if (!a_joint || !is(arguments, {kWorld, kGroup})) return false;
    const auto create = reinterpret_cast<dJointID (*)(dWorldID, dJointGroupID)>(find(name));
    if (!create) return false;
    dJointID made = create(world_, group(arguments[1].handle));
    keep_joint(made, arguments[1].handle);
    if (made) new_joints_.push_back(made);
    return true;
}

void Rerun::forget_joint(dJointID joint)
{
    recorder_->remove(joint);
    std::erase(new_joints_, joint);
}

void Rerun::empty(std::int32_t number)
{
    dJointGroupID emptied = group(number);
    if (!emptied) return;
    Group& group = groups_[size_t(number)];
    for (std::int32_t member : group.members) {
        dJointID& joint = joints_[size_t(member)];
        if (joint && dJointGetType(joint) != dJointTypeContact) forget_joint(joint);
        joint = nullptr;
    }
    group.members.clear();
    dJointGroupEmpty(emptied);
}

bool Rerun::destroy(const std::string& name, const std::vector<Argument>& arguments)
{
    using enum ArgumentKind;
    if (name == "dJointGroupEmpty" && is(arguments, {kGroup})) {
        empty(arguments[0].handle);
        return true;
    }
    if (name == "dJointDestroy" && is(arguments, {kJoint})) {
        if (dJointID dead = joint(arguments[0].handle)) {
            forget_joint(dead);
            dJointDestroy(dead);
            joints_[size_t(arguments[0].handle)] = nullptr;
        }
        return true;
    }
    if (name != "dBodyDestroy" || !is(arguments, {kBody})) return false;
    if (dBodyID dead = body(arguments[0].handle)) {
        recorder_->remove(dead);
        for (dBodyID& recorded : recorded_) {
            if (recorded == dead) recorded = nullptr;
        }
        dBodyDestroy(dead);
        bodies_[size_t(arguments[0].handle)] = nullptr;
    }
    return true;
}

bool Rerun::take_samples(int count)
{
    samples_ += count;
    return samples_ <= kMostSamplesTogether || refuse("all calls together ask for absurdly many samples");
}

bool Rerun::call(const std::string& name, const std::vector<Argument>& arguments)
{
    for (const char* step_name : kSteps) {
        if (name == step_name) return step(name, arguments);
    }
    const auto player = players().find(name);
    if (player != players().end()) {
        if (is_absurd(name, arguments)) return refuse("a call of " + name + " asks for absurdly much");
        const bool chosen = name == kBodySamples && !arguments.empty();
        if (chosen && !take_samples(arguments.back().integer)) return false;
        const Played played = player->second(*this, arguments);
        if (played == Played::kUnknown) return refuse("the library here has no " + name);
        return played == Played::kYes || refuse("a call of " + name + " with other arguments than it has");
    }
    if (name == "dBodyCreate" && !take_samples(dWorldGetAutoDisableAverageSamplesCount(world_))) return false;
    if (arguments.empty()) return refuse("the program calls " + name + ", which a recording cannot do again");
    return make(name, arguments) || destroy(name, arguments) || refuse("the recording calls " + name);
}

// Bodies get the recording's numbers when the state after their making is kept, if they live then.
void Rerun::take_new_bodies()
{
    for (; taken_ < bodies_.size(); ++taken_) {
        if (!bodies_[taken_]) continue;
        recorder_->add(bodies_[taken_]);
        recorded_.push_back(bodies_[taken_]);
    }
}

// dWorldSetExactSubsteps, where the library has that.
int Rerun::parts_of_exact_steps() const
{
    static const auto parts = reinterpret_cast<int (*)(dWorldID)>(find("dWorldGetExactSubsteps"));
    return parts ? parts(world_) : 1;
}

void Rerun::set_iterations()
{
    static const auto substeps = reinterpret_cast<void (*)(dWorldID, int)>(find("dWorldSetHybridSubsteps"));
    dWorldSetQuickStepNumIterations(world_, options_.iterations);
    if (substeps) substeps(world_, std::min(options_.iterations, kMostSteps));
}

bool Rerun::step(const std::string& name, const std::vector<Argument>& arguments)
{
    using enum ArgumentKind;
    const bool many = name == "dWorldsStep" && is(arguments, {kWorld, kNumber, kInteger, kInteger, kInteger});
    const bool fast = name == "dWorldStepFast1" && is(arguments, {kWorld, kNumber, kInteger});
    if (!many && !fast && !is(arguments, {kWorld, kNumber})) return refuse("a step of another kind");
    const dReal dt = dReal(arguments[1].number);
    const int steps = many ? arguments[4].integer : 1;
    const int small = fast ? arguments[2].integer : many ? arguments[3].integer : 1;
    const int sweeps = options_.iterations > 0 ? 1 : dWorldGetQuickStepNumIterations(world_);
    if (steps > kMostSteps || small > kMostSteps ||
        std::int64_t(steps) * std::max(small, sweeps) > kMostSweeps)
        return refuse("a call of " + name + " asks for absurdly many steps");
    sweeps_ += std::int64_t(std::max(1, steps)) * std::max({small, sweeps, parts_of_exact_steps()});
    if (sweeps_ > kMeanSweeps * std::int64_t(was_.steps.size()))
        return refuse("all calls together ask for absurdly many steps");
    if (found_ && step_ < was_.steps.size()) {
        take_new_bodies();
        found_->learn(was_.steps[step_], surfaces_);
        found_->make(step_, recorded_);
    }
    surfaces_.clear();
    const auto start = std::chrono::steady_clock::now();
    int ok = 1;
    if (options_.stepper.empty() && many) {
        using StepMany = int (*)(const dWorldID*, int, dReal, int, int, int, int, int*);
        const auto function = reinterpret_cast<StepMany>(find(name));
        if (!function) return refuse("the library here has no " + name);
        ok = function(&world_, 1, dt, arguments[2].integer, arguments[3].integer, steps, 1, nullptr);
    } else {
        std::string chosen = options_.stepper == "exact"    ? "dWorldStep"
                             : options_.stepper == "quick"  ? "dWorldQuickStep"
                             : options_.stepper == "fast"   ? "dWorldStepFast1"
                             : options_.stepper == "hybrid" ? "dWorldStepHybrid"
                                                            : name;
        void* function = find(chosen);
        if (!function) return refuse("the library here has no " + chosen);
        const int parts = options_.iterations > 0 ? options_.iterations : fast ? small : kFastSteps;
        if (options_.iterations > 0) set_iterations();
        for (int i = 0; i < steps && ok; ++i) {
            ok = chosen == "dWorldStepFast1"
                     ? reinterpret_cast<int (*)(dWorldID, dReal, int)>(function)(world_, dt, parts)
                     : reinterpret_cast<int (*)(dWorldID, dReal)>(function)(world_, dt);
        }
    }
    const std::chrono::duration<double, std::milli> spent = std::chrono::steady_clock::now() - start;
    ms_ = spent.count();
    dt_ = double(dt) * steps;
    time_ += dt_;
    return ok || refuse("the library reports that the step to state " + std::to_string(step_) + " failed");
}

bool Rerun::play(const CallBlock& block)
{
    names_.insert(names_.end(), block.new_names.begin(), block.new_names.end());
    ByteReader in(block.bytes.data(), block.bytes.size());
    Call next;
    while (next_call(in, next)) {
        if (next.name >= names_.size()) return refuse("a call without a name");
        if (!call(names_[next.name], next.arguments)) return false;
    }
    return true;
}

// Forms and places of geoms do not come from the calls.
void Rerun::begin_recording(Recording& now)
{
    now.about = was_.about;
    if (!options_.stepper.empty()) now.about["stepper"] = options_.stepper;
    now.shapes = was_.shapes;
    now.geoms = was_.geoms;
    now.geom_lives = was_.geom_lives;
    now.moves = was_.moves;
    recorder_ = std::make_unique<Recorder>(now);
}

void Rerun::sample(Recording& now)
{
    take_new_bodies();
    for (dJointID joint : new_joints_) recorder_->add(joint);
    new_joints_.clear();
    StepFigures figures;
    measure(world_, recorder_->bodies(), recorder_->joints(), figures);
    figures.time = time_;
    figures.dt = dt_;
    figures.ms = ms_;
    recorder_->step(figures, {}, false);
    now.steps.back().contacts = found_ ? found_->take() : was_.steps[step_].contacts;
}

bool Rerun::run(Recording& now, const std::function<bool(size_t)>& goes_on)
{
    begin_recording(now);
    size_t block = 0;
    for (step_ = 0; step_ < was_.steps.size(); ++step_) {
        for (; block < was_.calls_made.size() && was_.calls_made[block].step <= step_; ++block) {
            if (!play(was_.calls_made[block].block)) return false;
        }
        sample(now);
        if (!goes_on(step_)) break;
    }
    return true;
}

}  // namespace epode::record
