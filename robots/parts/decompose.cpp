// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See decompose.h.
#include "robots/parts/decompose.h"

#include <algorithm>
#include <numeric>

#include "robots/parts/concavity.h"
#include "robots/parts/cut.h"

namespace epode::robots {

namespace {

constexpr double kShare = 0.025;  // of the longest side, the tolerance without one
constexpr double kThin = 1e-9;    // of the longest side
constexpr double kCells = 1.5;    // to a tolerance
constexpr int kLeastCells = 48;   // to the longest side
constexpr int kRounds = 4;        // of cutting and merging
constexpr double kPlate = 0.01;   // of the tolerance: half the thickness that a part without any gets

struct Part {
    BoxPart cut;
    std::vector<Vec> points;  // corners of its hull
    Hull hull;
    double concavity = 0;
    bool is_final = false;  // too small to cut
};

struct Box {
    Vec low, high;
};

Box box_of(const std::vector<Vec>& points)
{
    Box out{points[0], points[0]};
    for (Vec p : points)
        for (int k = 0; k < 3; ++k)
            out.low[k] = std::min(out.low[k], p[k]), out.high[k] = std::max(out.high[k], p[k]);
    return out;
}

double longest_side(const Box& box)
{
    return std::max({box.high.x - box.low.x, box.high.y - box.low.y, box.high.z - box.low.z});
}

bool do_touch(const Box& a, const Box& b, double slack)
{
    for (int k = 0; k < 3; ++k)
        if (a.low[k] > b.high[k] + slack || b.low[k] > a.high[k] + slack) return false;
    return true;
}

class Decomposer {
  public:
    Decomposer(const Mesh& mesh, const PartSettings& settings, double side)
        : mesh_(mesh),
          settings_(settings),
          tolerance_(settings.tolerance > 0 ? settings.tolerance : kShare * side),
          thin_(kThin * side),
          grid_(mesh, std::min(side / kLeastCells, tolerance_ / kCells))
    {}

    Decomposition run()
    {
        BoxPart whole;
        whole.triangles.resize(mesh_.triangles.size());
        std::iota(whole.triangles.begin(), whole.triangles.end(), 0u);
        add(whole);
        for (int round = 0; round < kRounds && cut_all(); ++round) merge();
        return finish();
    }

  private:
    // Nothing where the box has nothing of the solid.
    void add(const BoxPart& cut)
    {
        Part part;
        part.cut = cut;
        std::vector<Vec> points = points_of(mesh_, grid_, cut, thin_);
        if (points.empty()) return;
        part.hull = hull_of(points, 0);
        if (part.hull.is_empty()) part.hull = hull_of(thickened(points), 0), part.is_final = true;
        if (part.hull.is_empty()) return;
        part.points = part.hull.corners();
        part.concavity = concavity_of(part.hull, grid_);
        parts_.push_back(std::move(part));
    }

    // Of points in one plane: an octahedron around each.
    std::vector<Vec> thickened(const std::vector<Vec>& points) const
    {
        std::vector<Vec> out;
        for (Vec p : points)
            for (int k = 0; k < 3; ++k)
                for (double sign : {-1.0, 1.0}) {
                    Vec moved = p;
                    moved[k] += sign * kPlate * tolerance_;
                    out.push_back(moved);
                }
        return out;
    }

    // Merging leaves numbers free for further cuts. False: there was nothing to cut.
    bool cut_all()
    {
        bool has_cut = false;
        while (int(parts_.size()) < 2 * settings_.max_parts && cut_worst()) has_cut = true;
        return has_cut;
    }

    // False: all are within the tolerance, or too small to cut.
    bool cut_worst()
    {
        size_t worst = parts_.size();
        for (size_t i = 0; i < parts_.size(); ++i) {
            const bool is_open = !parts_[i].is_final && parts_[i].concavity > tolerance_;
            if (is_open && (worst == parts_.size() || parts_[i].concavity > parts_[worst].concavity))
                worst = i;
        }
        if (worst == parts_.size()) return false;
        const Box box = box_of(parts_[worst].points);
        const Cut cut = best_cut(mesh_, grid_, parts_[worst].cut, box.low, box.high);
        if (cut.axis < 0) return parts_[worst].is_final = true;
        const Part old = std::move(parts_[worst]);
        parts_.erase(parts_.begin() + ptrdiff_t(worst));
        CutBox below = old.cut.box, above = old.cut.box;
        below.high[cut.axis] = above.low[cut.axis] = cut.place;
        add(cut_out(mesh_, old.cut, below, thin_));
        add(cut_out(mesh_, old.cut, above, thin_));
        return true;
    }

    struct Pair {
        size_t one, two;
        double concavity, growth;
    };

    Part merged(const Part& one, const Part& two, double enough) const
    {
        Part out;
        std::vector<Vec> points = one.points;
        points.insert(points.end(), two.points.begin(), two.points.end());
        out.hull = hull_of(points, 0);
        out.points = out.hull.corners();
        out.concavity = concavity_of(out.hull, grid_, enough);
        out.is_final = true;
        return out;
    }

    void weigh(size_t one, size_t two, bool only_touching)
    {
        const bool touch = do_touch(box_of(parts_[one].points), box_of(parts_[two].points), grid_.cell());
        if (only_touching && !touch) return;
        const bool are_many = int(parts_.size()) > settings_.max_parts;
        const Part both = merged(parts_[one], parts_[two], are_many ? HUGE_VAL : tolerance_);
        if (both.hull.is_empty()) return;
        const double growth = both.hull.volume - parts_[one].hull.volume - parts_[two].hull.volume;
        pairs_.push_back({one, two, std::max(both.concavity, tolerance_), growth});
    }

    // The pair that costs least; the parts before the second keep their numbers.
    bool merge_one()
    {
        const auto less = [](const Pair& a, const Pair& b) {
            return a.concavity != b.concavity ? a.concavity < b.concavity : a.growth < b.growth;
        };
        const auto best = std::min_element(pairs_.begin(), pairs_.end(), less);
        const bool are_many = int(parts_.size()) > settings_.max_parts;
        if (best == pairs_.end() || (!are_many && best->concavity > tolerance_)) return false;
        const size_t one = best->one, two = best->two;
        parts_[one] = merged(parts_[one], parts_[two], HUGE_VAL);
        parts_.erase(parts_.begin() + ptrdiff_t(two));
        std::erase_if(pairs_, [&](const Pair& pair) {
            return pair.one == one || pair.two == one || pair.one == two || pair.two == two;
        });
        for (Pair& pair : pairs_) pair.one -= pair.one > two, pair.two -= pair.two > two;
        for (size_t i = 0; i < parts_.size(); ++i)
            if (i != one) weigh(std::min(i, one), std::max(i, one), true);
        return true;
    }

    void weigh_all(bool only_touching)
    {
        for (size_t i = 0; i < parts_.size(); ++i)
            for (size_t k = i + 1; k < parts_.size(); ++k) weigh(i, k, only_touching);
    }

    void merge()
    {
        pairs_.clear();
        weigh_all(true);
        while (merge_one()) continue;
        if (int(parts_.size()) <= settings_.max_parts) return;
        weigh_all(false);  // pieces that do not touch
        while (merge_one()) continue;
    }

    Decomposition finish()
    {
        Decomposition out;
        out.tolerance = tolerance_, out.cell = grid_.cell(), out.is_closed = grid_.is_closed();
        for (const Part& part : parts_) {
            const bool is_limited = settings_.max_vertices > 0 && part.points.size() > settings_.max_vertices;
            out.hulls.push_back(is_limited ? hull_of(part.points, settings_.max_vertices) : part.hull);
            out.surplus = std::max(out.surplus, concavity_of(out.hulls.back(), grid_));
            for (Vec p : part.points)
                if (is_limited) out.uncovered = std::max(out.uncovered, out.hulls.back().height(p));
        }
        return out;
    }

    const Mesh& mesh_;
    const PartSettings& settings_;
    double tolerance_, thin_;
    Grid grid_;
    std::vector<Part> parts_;
    std::vector<Pair> pairs_;
};

}  // namespace

bool decompose(const Mesh& mesh, const PartSettings& settings, Decomposition& out, std::string& problem)
{
    std::vector<Vec> used;
    for (const auto& t : mesh.triangles)
        for (std::uint32_t corner : t) {
            if (corner >= mesh.vertices.size())
                return problem = "a triangle has an index beyond the vertices", false;
            used.push_back(mesh.vertices[corner]);
        }
    if (used.empty()) return problem = "the mesh has no triangles", false;
    if (!std::all_of(used.begin(), used.end(), [](Vec v) { return is_finite(v) && length(v) < 1e100; }))
        return problem = "a vertex is not a usable number", false;
    if (hull_of(used, 0).is_empty()) return problem = "all vertices are in one plane", false;
    out = Decomposer(mesh, settings, longest_side(box_of(used))).run();
    return true;
}

}  // namespace epode::robots
