// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See inverse.h. A goal's residual r is the distance p* - p to its position and the chord 2 v of the turn E = (w, v)
// from its orientation to the wanted one, |2 v| = 2 sin(angle / 2), whose derivative is -(w 1 + [v]x) omega: no arc
// is needed and the gradient is exact however far the goal is. Levenberg's and Marquardt's step of the joints is
//     min |J W y - r|^2 + lambda^2 |y|^2,   s = W y,   lambda^2 = mu |r|,
// within the limits; mu falls when |r| does and grows when a step is rejected. So steps stay small near singular
// positions and where the goal cannot be reached, and convergence is quadratic where it can (compare Sugihara,
// IEEE Trans. Robotics 27, 2011). A joint at a limit that the step would leave is fixed there, and the others are
// solved again. Where that ends without the goal, other starts, the same ones each time, are tried.
// A posture q0 is followed where goals leave a choice:  min |J W y|^2 / epsilon^2 + |y - W^-1 (q0 - q)|^2 is the nearest
// motion in the null space; the goals' own steps repair what its length spoils, and it is shortened where they cannot.
// Couplings and loops c(q) = 0 (constraints.h) are residuals -kHold c among the goals'. Where a goal cannot be reached, the
// compromise would leave c at some (1 / kHold)^2 of its distance, so the answer is then moved to c = 0 by the least motion.
#include "robots/inverse.h"

#include <algorithm>
#include <numbers>

#include "robots/constraints.h"
#include "robots/kinematics.h"

namespace epode::robots {

namespace {

using Column = std::vector<double>;

constexpr double kNullSpace = 1e-6;  // epsilon
constexpr int kMaxPostureSteps = 100;
constexpr double kHold = 100;  // weight of an error of a coupling or loop, of 1 m or rad
constexpr int kMaxHoldSteps = 50;

double product(const Column& a, const Column& b)
{
    double sum = 0;
    for (size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
    return sum;
}

// The x of least |A x - b|^2 + lambda^2 |x - c|^2, by Gram and Schmidt's method on the columns of A over lambda 1.
Column damped_solution(const std::vector<Column>& a, const Column& b, double lambda, const Column& c)
{
    const size_t n = a.size(), m = b.size();
    std::vector<Column> q(n + 1, Column(m + n, 0)), r(n, Column(n + 1, 0));
    for (size_t k = 0; k < n; ++k) {
        std::copy(a[k].begin(), a[k].end(), q[k].begin());
        q[k][m + k] = lambda, q[n][m + k] = lambda * c[k];
    }
    std::copy(b.begin(), b.end(), q[n].begin());
    for (size_t k = 0; k < n; ++k) {
        const double size = std::sqrt(product(q[k], q[k]));
        if (!(size > 0)) continue;
        for (double& value : q[k]) value /= size;
        r[k][k] = size;
        for (size_t j = k + 1; j <= n; ++j) {
            r[k][j] = product(q[k], q[j]);
            for (size_t i = 0; i < m + n; ++i) q[j][i] -= r[k][j] * q[k][i];
        }
    }
    Column x(n, 0);
    for (size_t k = n; k-- > 0;) {
        double rest = r[k][n];
        for (size_t j = k + 1; j < n; ++j) rest -= r[k][j] * x[j];
        x[k] = r[k][k] > 0 ? rest / r[k][k] : 0;
    }
    return x;
}

// Of a counter, in 0 ... 1 (Steele, Lea and Flood's mixer).
double spread(std::uint64_t counter)
{
    std::uint64_t z = (counter + 1) * 0x9e3779b97f4a7c15ull;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
    return double((z ^ (z >> 31)) >> 11) * 0x1p-53;
}

class Solver {
  public:
    Solver(const RobotModel& model, const std::vector<Goal>& goals, const InverseSettings& settings)
        : model_(model),
          goals_(goals),
          settings_(settings),
          n_(size_t(number_of_velocities(model))),
          weights_(settings.weights.empty() ? Column(n_, 1) : settings.weights)
    {}

    struct State {
        Column q, r;
        double size = 0;  // |r|
    };

    State state_at(Column q) const
    {
        State out{std::move(q), {}, 0};
        const std::vector<Pose> poses = forward_kinematics(model_, out.q);
        for (const Goal& goal : goals_) {
            const Pose here = poses[size_t(goal.link)] * goal.frame;
            append(out.r, goal.position_weight, goal.pose.p - here.p);
            append(out.r, goal.orientation_weight, 2 * chord_of(goal, here));
        }
        for (double error : constraint_errors(model_, out.q)) out.r.push_back(-kHold * error);
        out.size = std::sqrt(product(out.r, out.r));
        return out;
    }

    State descend(State state)
    {
        double mu = 0.1;
        for (int i = 0; i < settings_.max_iterations && state.size > settings_.tolerance; ++i) {
            ++iterations_;
            const Column y = step_within_limits(jacobian_at(state.q), state.q, state.r,
                                                std::sqrt(mu * state.size) + 1e-15, Column(n_, 0));
            if (std::sqrt(product(y, y)) < 1e-14) break;
            State trial = state_at(moved(state.q, y, 1));
            const bool is_better = trial.size < state.size;
            mu *= is_better ? 0.25 : 8;
            if (is_better) state = std::move(trial);
            if (mu > 1e12) break;
        }
        return state;
    }

    // To where couplings and loops hold, whatever it does to the goals.
    State held(State state) const
    {
        Column c = constraint_errors(model_, state.q);
        for (int i = 0; i < kMaxHoldSteps && std::sqrt(product(c, c)) > 1e-14; ++i) {
            std::vector<Column> columns(n_);
            append_constraints(columns, state.q, 1);
            for (double& error : c) error = -error;
            const Column y = step_within_limits(columns, state.q, c, 1e-9, Column(n_, 0));
            const Column trial = moved(state.q, y, 1), after = constraint_errors(model_, trial);
            if (product(after, after) >= product(c, c)) break;
            state.q = trial, c = after;
        }
        return state_at(std::move(state.q));
    }

    // In the null space towards the posture, as long as the goals are met as well as before.
    State approach_posture(State state)
    {
        if (settings_.posture.empty()) return state;
        const double allowed = std::max(settings_.tolerance, state.size * (1 + 1e-9));
        double away = distance_to_posture(state.q);
        for (int i = 0; i < kMaxPostureSteps; ++i) {
            const Column y = step_within_limits(jacobian_at(state.q), state.q, Column(state.r.size(), 0),
                                                kNullSpace, towards_posture(state.q));
            if (std::sqrt(product(y, y)) < 1e-10) break;
            const double before = away;
            for (double share = 1; share > 0.01 && away == before; share /= 2) {
                State trial = descend(state_at(moved(state.q, y, share)));
                const double distance = distance_to_posture(trial.q);
                if (trial.size > allowed || distance >= away) continue;
                state = std::move(trial), away = distance;
            }
            if (away >= before * (1 - 1e-12)) break;
        }
        return state;
    }

    // The guess, within the limits.
    Column first_start(Column q) const
    {
        for (const Joint& joint : model_.joints)
            if (joint.is_scalar() && joint.limited) {
                double& its = q[size_t(joint.position)];
                its = std::min(std::max(its, joint.low), joint.high);
            }
        return q;
    }

    // From the guess towards anywhere in the limits of hinges and sliders, farther from start to start: the least
    // suffices at a saddle, such as an arm stretched out. What has no limit goes half a turn or 1 m; locked joints stay.
    Column other_start(Column q, int number) const
    {
        constexpr double shares[] = {0.02, 0.06, 0.18, 0.54};
        const double share = number <= 4 ? shares[number - 1] : 1;
        size_t velocity = 0;
        for (size_t i = 0; i < model_.joints.size(); ++i) {
            const Joint& joint = model_.joints[i];
            const bool moves = weights_[velocity] > 0;
            velocity += size_t(velocities_of(joint));
            if (!joint.is_scalar() || !moves) continue;
            double& its = q[size_t(joint.position)];
            const double reach = joint.kind == JointKind::kHinge ? std::numbers::pi : 1;
            const double low = joint.limited && std::isfinite(joint.low) ? joint.low : its - reach;
            const double high = joint.limited && std::isfinite(joint.high) ? joint.high : its + reach;
            its += share * (low + (high - low) * spread(std::uint64_t(number) * 4096 + i) - its);
        }
        return first_start(std::move(q));
    }

    double distance_to_posture(const Column& q) const
    {
        const Column away = towards_posture(q);
        return std::sqrt(product(away, away));
    }

    void judge(const State& state, InverseAnswer& answer) const
    {
        const std::vector<Pose> poses = forward_kinematics(model_, state.q);
        for (const Goal& goal : goals_) {
            const Pose here = poses[size_t(goal.link)] * goal.frame;
            if (goal.position_weight > 0)
                answer.position_error = std::max(answer.position_error, length(goal.pose.p - here.p));
            if (goal.orientation_weight > 0)
                answer.orientation_error =
                    std::max(answer.orientation_error, angle_of(goal.pose.q * conjugate(here.q)));
        }
        answer.positions = state.q, answer.residual = state.size, answer.iterations = iterations_;
        answer.is_reached = state.size <= settings_.tolerance;
    }

  private:
    static void append(Column& out, double weight, Vec v)
    {
        for (int i = 0; weight > 0 && i < 3; ++i) out.push_back(weight * v[i]);
    }

    static Quat shorter(Quat q) { return q.w < 0 ? Quat{-q.w, -q.x, -q.y, -q.z} : q; }
    static Vec chord_of(const Goal& goal, const Pose& here)
    {
        const Quat e = shorter(goal.pose.q * conjugate(here.q));
        return {e.x, e.y, e.z};
    }

    // Columns of -dr/ds W, so that a step y changes r by -J W y.
    std::vector<Column> jacobian_at(const Column& q) const
    {
        std::vector<Column> out(n_);
        const std::vector<Pose> poses = forward_kinematics(model_, q);
        for (const Goal& goal : goals_) {
            const Column j = jacobian(model_, q, goal.link, goal.frame.p);
            const Pose here = poses[size_t(goal.link)] * goal.frame;
            const Quat e = shorter(goal.pose.q * conjugate(here.q));
            for (size_t k = 0; k < n_; ++k) {
                const Vec v{j[k], j[n_ + k], j[2 * n_ + k]}, w{j[3 * n_ + k], j[4 * n_ + k], j[5 * n_ + k]};
                append(out[k], goal.position_weight, weights_[k] * v);
                append(out[k], goal.orientation_weight,
                       weights_[k] * (e.w * w + cross(Vec{e.x, e.y, e.z}, w)));
            }
        }
        append_constraints(out, q, kHold);
        return out;
    }

    void append_constraints(std::vector<Column>& out, const Column& q, double factor) const
    {
        const Column rows = constraint_jacobian(model_, q);
        for (size_t i = 0; i < rows.size(); ++i) out[i % n_].push_back(factor * weights_[i % n_] * rows[i]);
    }

    // How far each y may go: between its limits, or at all.
    void bounds_at(const Column& q, Column& low, Column& high) const
    {
        low.assign(n_, -kInfinity), high.assign(n_, kInfinity);
        size_t k = 0;
        for (const Joint& joint : model_.joints) {
            if (joint.is_scalar() && joint.limited && weights_[k] > 0) {
                low[k] = std::min(0.0, (joint.low - q[size_t(joint.position)]) / weights_[k]);
                high[k] = std::max(0.0, (joint.high - q[size_t(joint.position)]) / weights_[k]);
            }
            k += size_t(velocities_of(joint));
        }
        for (k = 0; k < n_; ++k)
            if (!(weights_[k] > 0)) low[k] = high[k] = 0;
    }

    // What leaves its bounds is fixed there, one pass after another, and the rest solved again.
    Column step_within_limits(const std::vector<Column>& a, const Column& q, const Column& b, double lambda,
                              const Column& c) const
    {
        Column low, high, y(n_, 0);
        bounds_at(q, low, high);
        std::vector<bool> is_fixed(n_);
        for (size_t k = 0; k < n_; ++k) {
            const double pull = product(a[k], b) + lambda * lambda * c[k];
            is_fixed[k] = (low[k] == 0 && pull <= 0) || (high[k] == 0 && pull >= 0);
        }
        for (size_t pass = 0; pass <= n_; ++pass) {
            std::vector<Column> free;
            Column rest = b, wanted, x;
            for (size_t k = 0; k < n_; ++k) {
                if (!is_fixed[k]) free.push_back(a[k]), wanted.push_back(c[k]);
                for (size_t i = 0; is_fixed[k] && i < rest.size(); ++i) rest[i] -= y[k] * a[k][i];
            }
            x = damped_solution(free, rest, lambda, wanted);
            bool is_within = true;
            for (size_t k = 0, f = 0; k < n_; ++k) {
                if (is_fixed[k]) continue;
                y[k] = std::min(std::max(x[f], low[k]), high[k]);
                if (y[k] != x[f++]) is_fixed[k] = true, is_within = false;
            }
            if (is_within) break;
        }
        return y;
    }

    Column moved(const Column& q, const Column& y, double share) const
    {
        Column s(n_);
        for (size_t k = 0; k < n_; ++k) s[k] = share * weights_[k] * y[k];
        return first_start(moved_positions(model_, q, s));
    }

    // W^-1 (q0 - q), of joints that move.
    Column towards_posture(const Column& q) const
    {
        Column out = difference(model_, q, settings_.posture);
        for (size_t k = 0; k < n_; ++k) out[k] = weights_[k] > 0 ? out[k] / weights_[k] : 0;
        return out;
    }

    const RobotModel& model_;
    const std::vector<Goal>& goals_;
    const InverseSettings& settings_;
    const size_t n_;
    const Column weights_;
    int iterations_ = 0;
};

}  // namespace

InverseAnswer solve_inverse(const RobotModel& model, const std::vector<double>& guess,
                            const std::vector<Goal>& goals, const InverseSettings& settings)
{
    Solver solver(model, goals, settings);
    InverseAnswer answer;
    const std::vector<double> first = solver.first_start(guess);
    Solver::State best = solver.descend(solver.state_at(first));
    for (answer.starts = 1; answer.starts < settings.max_starts && best.size > settings.tolerance;
         ++answer.starts) {
        Solver::State other = solver.descend(solver.state_at(solver.other_start(first, answer.starts)));
        if (other.size < best.size * (1 - 1e-9)) best = std::move(other);
    }
    best = solver.approach_posture(std::move(best));
    if (best.size > settings.tolerance) best = solver.held(std::move(best));
    solver.judge(best, answer);
    return answer;
}

}  // namespace epode::robots
