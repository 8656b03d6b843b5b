// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// One degree of freedom: q'' M(q) = -V'(q) - M'(q) q'^2/2. Where q is a path through a closed loop (Bricard),
// the derivatives are central differences along the path.
#include "reference.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "squeezer.h"

namespace epode::iftomm {
namespace {

using State = std::vector<double>;
using Rates = std::function<State(const State&)>;
constexpr double kPi = 3.14159265358979323846;

State plus(const State& y, double s, const State& dy)
{
    State out(y);
    for (std::size_t i = 0; i < y.size(); ++i) out[i] += s * dy[i];
    return out;
}

State runge_kutta(const Rates& f, const State& y, double h)
{
    const State k1 = f(y), k2 = f(plus(y, h / 2, k1)), k3 = f(plus(y, h / 2, k2)), k4 = f(plus(y, h, k3));
    State out(y);
    for (std::size_t i = 0; i < y.size(); ++i) out[i] += h / 6 * (k1[i] + 2 * (k2[i] + k3[i]) + k4[i]);
    return out;
}

Motion integrate(const Rates& f, State y, double duration, int samples, double substep,
                 const std::function<State(const State&)>& outputs,
                 const std::function<void(State&)>& project = {})
{
    Motion motion{outputs(y)};
    const double interval = duration / samples;
    const int inner = std::max(1, int(std::ceil(interval / substep - 1e-9)));
    for (int i = 0; i < samples; ++i) {
        for (int k = 0; k < inner; ++k) {
            y = runge_kutta(f, y, interval / inner);
            if (project) project(y);
        }
        motion.push_back(outputs(y));
    }
    return motion;
}

// A x = b by elimination with row exchanges; A row-major, n x n.
State solve(std::vector<double> A, State b)
{
    const std::size_t n = b.size();
    for (std::size_t c = 0; c < n; ++c) {
        std::size_t pivot = c;
        for (std::size_t r = c + 1; r < n; ++r)
            if (std::fabs(A[r * n + c]) > std::fabs(A[pivot * n + c])) pivot = r;
        for (std::size_t k = 0; k < n; ++k) std::swap(A[c * n + k], A[pivot * n + k]);
        std::swap(b[c], b[pivot]);
        for (std::size_t r = c + 1; r < n; ++r) {
            const double f = A[r * n + c] / A[c * n + c];
            if (f == 0) continue;
            for (std::size_t k = c; k < n; ++k) A[r * n + k] -= f * A[c * n + k];
            b[r] -= f * b[c];
        }
    }
    for (std::size_t c = n; c-- > 0;) {
        for (std::size_t k = c + 1; k < n; ++k) b[c] -= A[c * n + k] * b[k];
        b[c] /= A[c * n + c];
    }
    return b;
}

// ---- A03: bars of the plane and pins, x y angle per bar ----

struct Plane {
    std::array<squeezer::Bar, squeezer::kBars> bars = squeezer::bars(squeezer::kStart);
    std::array<squeezer::Pin, 10> pins = squeezer::pins(squeezer::kStart);
    std::array<double, squeezer::kBars> angles = squeezer::bar_angles(squeezer::kStart);
    squeezer::Point D = squeezer::spring_end(squeezer::kStart);
    static constexpr std::size_t kN = 3 * squeezer::kBars, kM = 20;

    squeezer::Point local(int bar, squeezer::Point at) const
    {
        const double c = std::cos(angles[std::size_t(bar)]), s = std::sin(angles[std::size_t(bar)]);
        const double x = at.x - bars[std::size_t(bar)].centre.x, y = at.y - bars[std::size_t(bar)].centre.y;
        return {c * x + s * y, c * y - s * x};
    }
    static squeezer::Point arm(const State& y, int bar, squeezer::Point own)
    {
        const double t = y[std::size_t(3 * bar + 2)], c = std::cos(t), s = std::sin(t);
        return {c * own.x - s * own.y, s * own.x + c * own.y};
    }
    State start() const
    {
        State y;
        for (std::size_t i = 0; i < bars.size(); ++i)
            y.insert(y.end(), {bars[i].centre.x, bars[i].centre.y, angles[i]});
        y.resize(2 * kN);
        return y;
    }
    // Constraint values, G (kM x kN) and, with velocities, -G' q'.
    void constraints(const State& y, State& g, std::vector<double>& G, State& gamma) const
    {
        g.assign(kM, 0), gamma.assign(kM, 0), G.assign(kM * kN, 0);
        for (std::size_t p = 0; p < pins.size(); ++p) {
            const auto side = [&](int bar, double sign) {
                const auto b = std::size_t(3 * bar);
                const squeezer::Point r = arm(y, bar, local(bar, pins[p].at));
                const double w = y[kN + b + 2];
                g[2 * p] += sign * (y[b] + r.x), g[2 * p + 1] += sign * (y[b + 1] + r.y);
                G[2 * p * kN + b] = sign, G[(2 * p + 1) * kN + b + 1] = sign;
                G[2 * p * kN + b + 2] = -sign * r.y, G[(2 * p + 1) * kN + b + 2] = sign * r.x;
                gamma[2 * p] += sign * w * w * r.x, gamma[2 * p + 1] += sign * w * w * r.y;
            };
            side(pins[p].a, 1);
            if (pins[p].b >= 0)
                side(pins[p].b, -1);
            else
                g[2 * p] -= pins[p].at.x, g[2 * p + 1] -= pins[p].at.y;
        }
    }
    // [M G^T; G 0] [x; l] = [f; r], the first kN of the answer.
    State kkt(const std::vector<double>& G, const State& f, const State& r) const
    {
        constexpr std::size_t n = kN + kM;
        std::vector<double> K(n * n, 0);
        State b(n);
        for (std::size_t i = 0; i < kN; ++i) {
            const squeezer::Bar& bar = bars[i / 3];
            K[i * n + i] = i % 3 < 2 ? bar.mass : bar.inertia;
            b[i] = f[i];
        }
        for (std::size_t i = 0; i < kM; ++i) {
            for (std::size_t k = 0; k < kN; ++k) K[(kN + i) * n + k] = K[k * n + kN + i] = G[i * kN + k];
            b[kN + i] = r[i];
        }
        State x = solve(std::move(K), std::move(b));
        x.resize(kN);
        return x;
    }
    State rates(const State& y) const
    {
        State g, gamma, f(kN, 0.0);
        std::vector<double> G;
        constraints(y, g, G, gamma);
        f[2] = squeezer::kTorque;
        const int t = squeezer::kTriangle;
        const squeezer::Point r = arm(y, t, local(t, D));
        const double dx = y[3 * t] + r.x - squeezer::kC.x, dy = y[3 * t + 1] + r.y - squeezer::kC.y;
        const double l = std::sqrt(dx * dx + dy * dy),
                     pull = -squeezer::kStiffness * (l - squeezer::kRest) / l;
        f[3 * t] += pull * dx, f[3 * t + 1] += pull * dy;
        f[3 * t + 2] += r.x * pull * dy - r.y * pull * dx;
        State out(y.begin() + kN, y.end());
        const State a = kkt(G, f, gamma);
        out.insert(out.end(), a.begin(), a.end());
        return out;
    }
    void project(State& y) const
    {
        State g, gamma;
        std::vector<double> G;
        const State nothing(kN, 0.0);
        constraints(y, g, G, gamma);
        for (double& x : g) x = -x;
        const State move = kkt(G, nothing, g);
        for (std::size_t i = 0; i < kN; ++i) y[i] += move[i];
        constraints(y, g, G, gamma);
        State rate(kM, 0.0);
        for (std::size_t i = 0; i < kM; ++i)
            for (std::size_t k = 0; k < kN; ++k) rate[i] -= G[i * kN + k] * y[kN + k];
        const State change = kkt(G, nothing, rate);
        for (std::size_t i = 0; i < kN; ++i) y[kN + i] += change[i];
    }
};

Motion squeezer_motion(double duration, int samples, double substep,
                       const std::function<State(const State&)>& outputs)
{
    const Plane plane;
    return integrate([&](const State& y) { return plane.rates(y); }, plane.start(), duration, samples,
                     substep, outputs, [&](State& y) { plane.project(y); });
}

// ---- A04: a loop of six hinges, the path through its one freedom ----

struct Vec {
    double x = 0, y = 0, z = 0;
};
Vec operator+(Vec a, Vec b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
Vec operator-(Vec a, Vec b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
Vec operator*(double s, Vec a) { return {s * a.x, s * a.y, s * a.z}; }
double dot(Vec a, Vec b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Vec cross(Vec a, Vec b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }
Vec turned(Vec v, Vec n, double angle)
{
    return std::cos(angle) * v + std::sin(angle) * cross(n, v) + (1 - std::cos(angle)) * dot(n, v) * n;
}

struct Bricard {
    static constexpr Vec kCorner[6] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {1, 1, 1}, {0, 1, 1}, {0, 0, 1}};
    static constexpr Vec kAxis[6] = {{0, 1, 0}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 0}};

    struct Pose {
        Vec at[7], axis[7];  // joint k = 1 ... 5; 6: where the loop ends
    };
    // Hinge k turns all links behind it.
    static Pose pose(const State& q)
    {
        Pose p;
        for (int k = 0; k < 7; ++k) p.at[k] = kCorner[k % 6], p.axis[k] = kAxis[k % 6];
        for (int j = 5; j >= 1; --j)
            for (int k = j + 1; k < 7; ++k) {
                p.at[k] = kCorner[j] + turned(p.at[k] - kCorner[j], kAxis[j], q[std::size_t(j - 1)]);
                p.axis[k] = turned(p.axis[k], kAxis[j], q[std::size_t(j - 1)]);
            }
        return p;
    }
    // Rates of hinges 1 ... 5 of norm 1, in the sense of `hint`: the loop's end neither moves nor turns but
    // about the ground's own axis. Least squares of six equations in all but the fastest hinge, and hinge 0;
    // hinges turn back now and then, so that none of them could be the coordinate.
    static State null_rates(const Pose& p, const State& hint)
    {
        double S[6][6];  // columns: hinges 1 ... 5, 0
        for (int j = 1; j <= 6; ++j) {
            const Vec n = j == 6 ? kAxis[0] : p.axis[j];
            const Vec m = j == 6 ? Vec{} : cross(n, p.at[6] - p.at[j]);
            const double column[6] = {n.x, n.y, n.z, m.x, m.y, m.z};
            for (int i = 0; i < 6; ++i) S[i][j - 1] = column[i];
        }
        std::size_t lead = 0;
        for (std::size_t k = 1; k < 5; ++k)
            if (std::fabs(hint[k]) > std::fabs(hint[lead])) lead = k;
        const auto column = [&](std::size_t c) { return c < lead ? c : c + 1; };
        std::vector<double> N(25, 0);
        State b(5, 0.0);
        for (std::size_t r = 0; r < 5; ++r)
            for (int i = 0; i < 6; ++i) {
                b[r] -= S[i][column(r)] * S[i][lead];
                for (std::size_t c = 0; c < 5; ++c) N[5 * r + c] += S[i][column(r)] * S[i][column(c)];
            }
        const State x = solve(N, b);
        State rate(6, 0.0);
        rate[lead] = hint[lead] > 0 ? 1 : -1;
        for (std::size_t c = 0; c < 5; ++c) rate[column(c)] = rate[lead] * x[c];
        rate.resize(5);
        double norm = 0;
        for (double r : rate) norm += r * r;
        for (double& r : rate) r /= std::sqrt(norm);
        return rate;
    }
    struct Energy {
        double mass, potential;
    };
    static Energy energy(const State& q, const State& hint)
    {
        const Pose p = pose(q);
        const State rate = null_rates(p, hint);
        const double across = (1 + 0.01) / 12, along = 0.02 / 12;
        Energy e{0, 0};
        Vec spin;
        Vec moment;  // sum of rate (axis x (-at)): v(x) = moment + spin x x
        for (int k = 1; k <= 5; ++k) {
            const Vec n = p.axis[k];
            const double r = rate[std::size_t(k - 1)];
            spin = spin + r * n;
            moment = moment - r * cross(n, p.at[k]);
            const Vec centre = 0.5 * (p.at[k] + p.at[k + 1]), own = p.at[k + 1] - p.at[k];
            const Vec v = moment + cross(spin, centre);
            const double w = dot(spin, own);
            e.mass += dot(v, v) + across * (dot(spin, spin) - w * w) + along * w * w;
            e.potential += kGravity * centre.y;
        }
        return e;
    }
    // y: the five angles and the speed along the path; `hint` is the direction of the path.
    static State rates(const State& y, State& hint)
    {
        const State q(y.begin(), y.begin() + 5), N = hint = null_rates(pose(q), hint);
        const double eps = 1e-5, u = y[5];
        const Energy here = energy(q, N), ahead = energy(plus(q, eps, N), N),
                     behind = energy(plus(q, -eps, N), N);
        const double dV = (ahead.potential - behind.potential) / (2 * eps);
        const double dM = (ahead.mass - behind.mass) / (2 * eps);
        State out;
        for (double n : N) out.push_back(n * u);
        out.push_back(-(dV + 0.5 * dM * u * u) / here.mass);
        return out;
    }
};

}  // namespace

Motion pendulum_reference(double inertia, double duration, int samples)
{
    return integrate(
        [=](const State& y) {
            return State{y[1], -kGravity * std::cos(y[0]) / (1 + inertia)};
        },
        {kPi, 0}, duration, samples, 1e-4,
        [](const State& y) {
            return State{std::cos(y[0]), std::sin(y[0])};
        });
}

// All cranks stay parallel: (N + 1)/3 + N of inertia, (N + 1)/2 + N of weight, at the angle from upright.
Motion four_bars_reference(int windows, double duration, int samples)
{
    const double n = windows, rate = kGravity * ((n + 1) / 2 + n) / ((n + 1) / 3 + n);
    return integrate(
        [=](const State& y) {
            return State{y[1], rate * std::sin(y[0])};
        },
        {0, 1}, duration, samples, 1e-4,
        [](const State& y) {
            const double s = std::sin(y[0]), c = std::cos(y[0]);
            return State{s, c, c * y[1], -s * y[1]};
        });
}

Motion squeezer_reference(double duration, int samples, double substep)
{
    const Plane plane;
    const squeezer::Point F = plane.local(squeezer::kCrank, plane.pins[1].at);
    return squeezer_motion(duration, samples, substep, [F](const State& y) {
        const squeezer::Point r = Plane::arm(y, squeezer::kCrank, F);
        return State{y[0] + r.x, y[1] + r.y};
    });
}

std::vector<double> squeezer_angles(double time, double substep)
{
    const Motion motion = squeezer_motion(time, 1, substep, [](const State& y) {
        const auto a = [&](int bar) { return y[std::size_t(3 * bar + 2)]; };
        using namespace squeezer;
        return State{a(kCrank), a(kLink) - a(kCrank),  a(kTriangle), a(kBarEG) - a(kBarAG),
                     a(kBarAG), a(kBarHE) - a(kBarAH), a(kBarAH)};
    });
    return motion.back();
}

Motion bricard_reference(double duration, int samples)
{
    State hint{1, 0, 0, 0, 0};
    return integrate([&](const State& y) { return Bricard::rates(y, hint); }, {0, 0, 0, 0, 0, 0}, duration,
                     samples, 5e-4,
                     [](const State& y) {
                         const Vec p = Bricard::pose(State(y.begin(), y.begin() + 5)).at[3];
                         return State{p.x, p.y, p.z};
                     });
}

// phi below the horizontal, height s of the slider, spin L/J(phi): two rods of 1 m from the top of a shaft of
// 1 m, 0.3 kg each with 5 kg at the end, springs from their middles to the slider of 3 kg.
Motion governor_reference(double duration, int samples, double substep)
{
    const double rod = 0.3, thin = 0.01 * 0.01 / 12, K = 8e5, C = 4e4, rest = 0.5, slider = 3;
    const double swing = rod * (1.0 / 3 + thin) + 5, twist = rod * 2 * thin;
    const double fixed = slider * 0.02 / 12 + rod * 2 * thin;
    const auto J = [=](double phi) {
        const double c = std::cos(phi), s = std::sin(phi);
        return fixed + 2 * (swing * c * c + twist * s * s);
    };
    const double phi0 = kPi / 6, L = J(phi0) * 2 * kPi;
    const auto rates = [=](const State& y) {
        const double phi = y[0], s = y[1], dphi = y[2], ds = y[3];
        const double x = 0.5 * std::cos(phi), z = 1 - 0.5 * std::sin(phi) - s, l = std::sqrt(x * x + z * z);
        const double dx = -0.5 * std::sin(phi), dz = -0.5 * std::cos(phi);
        const double l_phi = (x * dx + z * dz) / l, l_s = -z / l;
        const double F = K * (l - rest) + C * (l_phi * dphi + l_s * ds);
        const double spin = L / J(phi), dJ = -4 * (swing - twist) * std::cos(phi) * std::sin(phi);
        const double weight = -2 * kGravity * (rod * 0.5 + 5) * std::cos(phi);  // dV/dphi
        return State{dphi, ds, (0.5 * dJ * spin * spin - weight - 2 * F * l_phi) / (2 * swing),
                     (-slider * kGravity - 2 * F * l_s) / slider};
    };
    return integrate(rates, {phi0, 0.5, 0, 0}, duration, samples, substep,
                     [](const State& y) { return State{y[1]}; });
}

}  // namespace epode::iftomm
