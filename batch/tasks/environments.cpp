// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See environments.h. Copies are observed, judged and reset in the thread that has stepped them.
#include "batch/tasks/environments.h"

#include "batch/tasks/draws.h"
#include "batch/tasks/terms.h"

namespace epode::batch {

namespace {

struct Episode {
    std::uint64_t seed = 0;
    std::uint32_t number = 0;
    int steps = 0;
    bool is_over = false, is_first = true;
};

template <typename T>
class EnvironmentsOf : public Environments {
  public:
    EnvironmentsOf(AnyBatch& batch, Task task, Autoreset autoreset, std::uint32_t first,
                   const Results& results)
        : batch_(batch),
          task_(std::move(task)),
          autoreset_(autoreset),
          first_(first),
          out_(results),
          terms_(arrays_),
          width_(std::size_t(task_.observation_size())),
          episodes_(std::size_t(batch.copies()))
    {
        scratch_.reserve(std::size_t(batch.threads()));
        for (int i = 0; i < batch.threads(); ++i) scratch_.emplace_back(batch.model(), task_);
        for (Term& term : task_.terms)
            if (term.kind == Term::Kind::kRate) term.rate = rates_++;
        before_.resize(episodes_.size() * std::size_t(rates_));
        watch_all();
        draw_from_.resize(task_.draws.size());
        for (std::size_t i = 0; i < task_.draws.size(); ++i) {
            const Parameter parameter = task_.draws[i].parameter;
            draw_from_[i].resize(std::size_t(batch::size_of(batch_.model(), parameter)));
            batch_.read(parameter, 0, 1, draw_from_[i].data());
            batch_.write(parameter, 0, 1, draw_from_[i].data());  // copies have their own from now on
        }
        const std::array<T, 3> nowhere{};
        if (task_.curriculum.rows > 0) batch_.write(Parameter::kTerrain, 0, 1, nowhere.data());
    }
    ~EnvironmentsOf() override
    {
        for (int q = 0; q < int(Quantity::kCount); ++q) batch_.watch(Quantity(q), nullptr);
    }

    void reset(const bool* mask, const std::uint64_t* seed) override
    {
        for (int i = 0; i < batch_.copies(); ++i) {
            if (mask && !mask[i]) continue;
            if (seed) episodes_[std::size_t(i)] = {*seed};
            begin(i, 0);
        }
        batch_.refresh(0, batch_.copies(), 0);
        for (int i = 0; i < batch_.copies(); ++i) {
            out_.begun[i] = !mask || mask[i];
            if (!out_.begun[i]) continue;
            out_.rewards[i] = 0, out_.terminated[i] = out_.truncated[i] = out_.bad[i] = false;
            enter(i);
        }
    }

    std::string step(const double* actions) override
    {
        std::string problem = take(actions);
        if (!problem.empty()) return problem;
        const AnyBatch::Visit visit = [this](int first, int count, int worker) {
            judge(first, count, worker);
        };
        if (!batch_.step(task_.frame_skip, &visit))
            return "the arrays that are bound to the batch have numbers that cannot be";
        return {};
    }

  private:
    void watch(Quantity quantity)
    {
        std::vector<T>& array = arrays_.of[std::size_t(quantity)];
        const auto size = std::size_t(batch_.size_of(quantity));
        arrays_.sizes[std::size_t(quantity)] = size;
        array.resize(episodes_.size() * size);
        batch_.watch(quantity, array.data());
    }

    void watch(const Piece& piece)
    {
        if (piece.source == Piece::Source::kQuantity) watch(piece.quantity);
        const bool has_heights = piece.source == Piece::Source::kHeight;
        if (piece.source == Piece::Source::kPoint || has_heights) watch(Quantity::kLinkPositions);
        if (piece.source == Piece::Source::kPoint || piece.source == Piece::Source::kDirection ||
            has_heights || piece.axes_of >= 0)
            watch(Quantity::kLinkTurns);
        if (has_heights && !arrays_.ground) arrays_.ground = std::make_unique<Ground>(batch_.model());
    }

    void watch_all()
    {
        watch(Quantity::kBad);
        arrays_.batch = &batch_;
        for (const Piece& piece : task_.observation) watch(piece);
        for (const Range& range : task_.healthy) watch(range.piece);
        for (const Term& term : task_.terms) watch(term.piece);
        arrays_.action_size = task_.choices.empty() ? std::size_t(batch_.model().controls) : 1;
        arrays_.actions.resize(episodes_.size() * arrays_.action_size),
            arrays_.last_actions = arrays_.actions;
        arrays_.command_size = task_.commands.low.size();
        arrays_.commands.resize(episodes_.size() * arrays_.command_size);
        arrays_.rows.resize(episodes_.size());
        if (task_.curriculum.rows > 0) watch(Quantity::kPositions);
    }

    // Judges all before anything changes.
    std::string take(const double* actions)
    {
        const auto controls = std::size_t(batch_.model().controls);
        const double choices = task_.choices.empty() ? 0 : double(task_.choices.size() / controls);
        for (std::size_t i = 0; i < arrays_.actions.size(); ++i) {
            if (choices > 0 && !(actions[i] >= 0 && actions[i] < choices))
                return "an action is not one of the choices";
            if (!(std::fabs(actions[i]) < 1e15)) return "an action is not finite";
        }
        if (autoreset_ == Autoreset::kDisabled)
            for (const Episode& episode : episodes_)
                if (episode.is_over)
                    return "an episode has ended: reset it, with options={'reset_mask': ...}";
        arrays_.actions.swap(arrays_.last_actions);
        std::copy_n(actions, arrays_.actions.size(), arrays_.actions.begin());
        std::vector<T> row(controls);
        for (int i = 0; i < batch_.copies(); ++i) {
            const double* its = actions + std::size_t(i) * arrays_.action_size;
            if (choices > 0) its = task_.choices.data() + std::size_t(*its) * controls;
            std::copy_n(its, controls, row.begin());
            batch_.write(Quantity::kControls, i, 1, row.data());
        }
        return {};
    }

    void judge(int first, int count, int worker)
    {
        bool any_begins = false;
        for (int i = first; i < first + count; ++i) {
            Episode& episode = episodes_[std::size_t(i)];
            const bool begins = autoreset_ == Autoreset::kNextStep && episode.is_over;
            out_.begun[i] = begins;
            if (begins)
                out_.rewards[i] = 0, out_.terminated[i] = out_.truncated[i] = out_.bad[i] = false;
            else
                finish_step(i);
            if (autoreset_ == Autoreset::kSameStep && episode.is_over) {
                observe(i, static_cast<T*>(out_.final_observations));
                std::copy_n(out_.infos + i * task_.columns, task_.columns,
                            out_.final_infos + i * task_.columns);
                out_.begun[i] = true;
            }
            if (out_.begun[i]) begin(i, worker), any_begins = true;
        }
        if (any_begins) batch_.refresh(first, count, worker);
        for (int i = first; i < first + count; ++i)
            out_.begun[i] ? enter(i) : observe(i, static_cast<T*>(out_.observations));
    }

    bool is_healthy(int copy) const
    {
        const auto within = [&](const Range& range) { return terms_.is_within(range, copy); };
        return !out_.bad[copy] && std::all_of(task_.healthy.begin(), task_.healthy.end(), within);
    }

    void finish_step(int i)
    {
        Episode& episode = episodes_[std::size_t(i)];
        ++episode.steps;
        out_.bad[i] = *arrays_.row(Quantity::kBad, i) > 0;
        const bool healthy = is_healthy(i);
        std::fill_n(out_.infos + i * task_.columns, task_.columns, 0.0);
        double reward = 0;
        for (const Term& term : task_.terms)
            reward += add(term, i, healthy, batch_.options().h * task_.frame_skip);
        out_.rewards[i] = reward;
        out_.terminated[i] = out_.bad[i] || (task_.terminates && !healthy);
        out_.truncated[i] = task_.time_limit > 0 && episode.steps >= task_.time_limit;
        episode.is_over = out_.terminated[i] || out_.truncated[i];
        if (task_.commands.steps > 0 && episode.steps % task_.commands.steps == 0) command(i);
    }

    void command(int i)
    {
        if (arrays_.command_size == 0) return;
        Random random = random_of(i, Random::kCommands, std::uint32_t(episodes_[std::size_t(i)].steps));
        draw_commands(task_.commands, random,
                      arrays_.commands.data() + std::size_t(i) * arrays_.command_size);
    }

    // Puts the copy on a field of its row.
    void choose_field(int i, Scratch<T>& scratch)
    {
        const Curriculum& its = task_.curriculum;
        if (its.rows == 0) return;
        const T* q = arrays_.row(Quantity::kPositions, i);
        const double x = double(q[0]), y = double(q[1]);
        const double moved = episodes_[std::size_t(i)].is_first ? -1 : std::sqrt(x * x + y * y);
        Random random = random_of(i, Random::kParameters, std::uint32_t(Parameter::kTerrain));
        double& row = arrays_.rows[std::size_t(i)];
        row = next_row(its, int(row), moved, random);
        const int column = std::min(its.columns - 1, int(random.uniform() * its.columns));
        scratch.values.assign({T(-its.spacing * row), T(-its.spacing * column), T(0)});
        batch_.write(Parameter::kTerrain, i, 1, scratch.values.data());
    }

    // Of a term its share of the reward; rates begin anew from here.
    double add(const Term& term, int i, bool healthy, double time)
    {
        double none = 0, &before = term.rate < 0 ? none : before_[std::size_t(i * rates_ + term.rate)];
        const double value = terms_.value(term, i, healthy, before, time);
        if (term.rate >= 0) before = terms_.sum(term.piece, i);
        if (term.column >= 0) out_.infos[i * task_.columns + term.column] += value;
        return term.is_reward ? value : 0;
    }

    Random random_of(int i, Random::Stream stream, std::uint32_t step = 0) const
    {
        const Episode& episode = episodes_[std::size_t(i)];
        return {episode.seed, first_ + std::uint32_t(i), episode.number, stream, step};
    }

    // The first state of an episode; the copy's arrays are old until they are refreshed.
    void begin(int i, int worker)
    {
        Episode& episode = episodes_[std::size_t(i)];
        Scratch<T>& scratch = scratch_[std::size_t(worker)];
        ++episode.number, episode.steps = 0, episode.is_over = false;
        choose_field(i, scratch);
        episode.is_first = false;
        batch_.reset_copy(i);
        std::fill_n(arrays_.actions.begin() + std::ptrdiff_t(std::size_t(i) * arrays_.action_size),
                    arrays_.action_size, 0.0);
        command(i);
        for (std::size_t k = 0; k < task_.draws.size(); ++k) {
            Random random = random_of(i, Random::kParameters, std::uint32_t(task_.draws[k].parameter));
            draw_parameter(batch_, task_.draws[k], draw_from_[k], random, i, scratch);
        }
        const std::vector<double>& reference = batch_.model().reference;
        std::copy(reference.begin(), reference.end(), scratch.positions.begin());
        std::fill(scratch.velocities.begin(), scratch.velocities.end(), T(0));
        Random random = random_of(i, Random::kReset);
        for (const Start& start : task_.starts) draw_start(start, random, scratch);
        batch_.write(Quantity::kPositions, i, 1, scratch.positions.data());
        batch_.write(Quantity::kVelocities, i, 1, scratch.velocities.data());
    }

    // The first observation of an episode.
    void enter(int i)
    {
        std::fill_n(out_.infos + i * task_.columns, task_.columns, 0.0);
        for (const Term& term : task_.terms) {
            if (term.rate >= 0) before_[std::size_t(i * rates_ + term.rate)] = terms_.sum(term.piece, i);
            if (term.at_reset) add(term, i, true, 0);
        }
        observe(i, static_cast<T*>(out_.observations));
    }

    void observe(int i, T* to) const
    {
        to += std::size_t(i) * width_;
        T* next = to;
        for (const Piece& piece : task_.observation) {
            terms_.each(piece, i, [&](int k, double x) { next[k] = T(x); });
            next += piece.count;
        }
        if (task_.noise.empty()) return;
        Random random = random_of(i, Random::kNoise, std::uint32_t(episodes_[std::size_t(i)].steps));
        for (std::size_t k = 0; k < width_; ++k) to[k] += T(task_.noise[k] * random.normal());
    }

    AnyBatch& batch_;
    Task task_;
    Autoreset autoreset_;
    std::uint32_t first_;
    Results out_;
    Arrays<T> arrays_;
    Terms<T> terms_;
    std::size_t width_;
    std::vector<Episode> episodes_;
    std::vector<double> before_;  // of each copy what rates are of
    std::vector<std::vector<T>> draw_from_;
    std::vector<Scratch<T>> scratch_;  // of each thread
    int rates_ = 0;
};

}  // namespace

std::unique_ptr<Environments> make_environments(AnyBatch& batch, Task task, Autoreset autoreset,
                                                std::uint32_t first, const Results& results)
{
    if (batch.number_size() == 8)
        return std::make_unique<EnvironmentsOf<double>>(batch, std::move(task), autoreset, first, results);
    return std::make_unique<EnvironmentsOf<float>>(batch, std::move(task), autoreset, first, results);
}

}  // namespace epode::batch
