// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// After Box3D's rain: ragdolls of 15 bodies fall on tiles of level ground with a torus each, all one mesh.
// Box3D makes them during the run and gives their joints springs; here they hang in columns from the start,
// three to a tile and a storey, and the joints are free, so that every engine can be asked. Size: ragdolls.
#include <cmath>

#include "bench/scenes/human.h"
#include "bench/scenes/recipe.h"

namespace epode::bench {

namespace {

constexpr int kTiles = 10;
constexpr double kTile = 15;  // m

void add_grid(ShapeData& mesh, int cells, double pitch)
{
    const int across = cells + 1;
    for (int n = 0; n < across * across; ++n)
        mesh.points.push_back({pitch * (n % across - 0.5 * cells), pitch * (n / across - 0.5 * cells), 0});
    for (int j = 0; j < cells; ++j) {
        for (int i = 0; i < cells; ++i) {
            const int low = j * across + i, high = low + across + 1;
            mesh.triangles.push_back({low, low + 1, high});
            mesh.triangles.push_back({low, high, high - 1});
        }
    }
}

// Radii 3.75 and 1 m, lying in the ground to its middle.
void add_torus(ShapeData& mesh, Vec centre)
{
    constexpr int kSegments = 16;
    const int first = int(mesh.points.size());
    for (int n = 0; n < kSegments * kSegments; ++n) {
        const double u = 2 * scenes::kPi * (n / kSegments) / kSegments,
                     v = 2 * scenes::kPi * (n % kSegments) / kSegments;
        const double r = 3.75 + std::cos(v);
        mesh.points.push_back(centre + Vec{r * std::cos(u), r * std::sin(u), std::sin(v)});
    }
    const auto corner = [&](int i, int j) { return first + (i % kSegments) * kSegments + j % kSegments; };
    for (int i = 0; i < kSegments; ++i) {
        for (int j = 0; j < kSegments; ++j) {
            mesh.triangles.push_back({corner(i, j), corner(i + 1, j), corner(i + 1, j + 1)});
            mesh.triangles.push_back({corner(i, j), corner(i + 1, j + 1), corner(i, j + 1)});
        }
    }
}

Vec tile_centre(int tile)
{
    return {kTile * (tile % kTiles - 0.5 * (kTiles - 1)), kTile * (tile / kTiles - 0.5 * (kTiles - 1)), 0};
}

void build(SceneData& scene, int count)
{
    constexpr int kOnTile = 3;
    ShapeData mesh{ShapeKind::kMesh, {}, {}, {}};
    add_grid(mesh, 8 * kTiles, kTile / 8);
    for (int tile = 0; tile < kTiles * kTiles; ++tile) add_torus(mesh, tile_centre(tile));
    add_static(scene, add_shape(scene, std::move(mesh)), {});
    scene.gravity = 10;
    const HumanShapes shapes = add_human_shapes(scene);
    Lcg random(11);
    for (int n = 0; n < count; ++n) {
        const int tile = n / kOnTile % (kTiles * kTiles), storey = n / (kOnTile * kTiles * kTiles);
        const double turned = random.uniform(-scenes::kPi, scenes::kPi);
        const Vec at{random.uniform(-4.5, 4.5), 1.5 * (n % kOnTile - 1),
                     4 + 4.0 * storey + random.uniform(0, 8)};
        add_human(scene, shapes, {tile_centre(tile) + at, scenes::turn(scenes::kZ, turned), true, n + 1});
    }
}

}  // namespace

extern const SceneRecipe kRainScene = {
    "ragdolls rain on a mesh of tori", build, {{"rain", 300, 200, 12, 100}}};

}  // namespace epode::bench
