// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Card house: three storeys of thin boards leaning on each other in pairs, with boards laid across. Only
// friction holds it up: a stepper whose friction creeps, or whose contacts push, brings it down within
// seconds, as QuickStep's 20 sweeps do.
#include <cmath>

#include "scenes/build.h"

namespace epode::scenes {

namespace {

constexpr int kStoreys = 3;

struct Board {
    double length = 0.9, width = 0.6, thick = 0.03;
};

constexpr double kOverlap = 0.0005;  // so that edges which touch are seen to touch

// Two boards whose upper edges touch at x, leaning by `lean` from the vertical, feet at z. Returns the height
// of the top.
double add_tent(Scene& scene, const Board& board, double x, double z, double lean, double density)
{
    const double up = 0.5 * board.length * std::cos(lean) + 0.5 * board.thick * std::sin(lean);
    const double out = 0.5 * board.length * std::sin(lean) + 0.5 * board.thick * std::cos(lean);
    for (double side : {-1.0, 1.0}) {
        add_box(scene, {board.thick, board.width, board.length}, density,
                {x + side * (out - kOverlap), 0, z + up - kOverlap}, turn(kY, -side * lean));
    }
    return z + 2 * up;
}

void build(Scene& scene)
{
    const Board board;
    const double lean = 0.25, density = 600, pitch = 0.66;
    add_ground(scene);
    double z = 0;
    for (int storey = 0; storey < kStoreys; ++storey) {
        const int tents = kStoreys - storey;
        double top = z;
        for (int i = 0; i < tents; ++i)
            top = add_tent(scene, board, (i - 0.5 * (tents - 1)) * pitch, z, lean, density);
        for (int i = 0; i + 1 < tents; ++i) {
            const double x = (i - 0.5 * (tents - 2)) * pitch;
            add_box(scene, {pitch - 0.005, board.width, board.thick}, density, {x, 0, top + board.thick / 2});
        }
        z = top + board.thick;
    }
    scene.surface.mu = dReal(0.8);
    scene.tracked = {scene.bodies().back()};
    set_view(scene, {-2.2, -5.4, 2.3}, {0, 0, 1.2});
}

}  // namespace

extern const Recipe kCards = {
    .name = "cards",
    .description = "a card house of three storeys that nothing but friction holds up",
    .dt = 0.005,
    .seconds = 3,
    .stepper = Stepper::kExact,
    .build = build,
};

}  // namespace epode::scenes
