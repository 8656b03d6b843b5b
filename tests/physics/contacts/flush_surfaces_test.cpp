// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Surfaces laid edge to edge are one floor: what slides over the border goes on as over a single surface. Height fields,
// meshes and boxes, flat and hilly (z = 0.1 sin x cos y, samples 1 m apart), with world-managed contacts, in every
// stepper and preset.
#include <memory>

#include "../world_contacts.h"

namespace epode::physics {
namespace {

double flat(double, double) { return 0; }
double valley(double x, double) { return 0.02 * x * x; }
double hills(double x, double y) { return 0.1 * std::sin(x) * std::cos(y); }
using Height = double (*)(double, double);

enum class Part { kBox, kMesh, kField };
constexpr double kFar = 10;

// Of x0 ... x1 and |y| < 5 m; a field's z axis runs against y.
class Surface {
  public:
    Surface(Sim& sim, Part part, double x0, double x1, Height height, double friction = 0)
    {
        const int nx = int(x1 - x0) + 1, ny = 11;
        if (part == Part::kBox) {
            geom_ = dCreateBox(sim.space, real(x1 - x0), 10, 2);
            dGeomSetPosition(geom_, real((x0 + x1) / 2), 0, -1);
        } else if (part == Part::kField) {
            for (int j = 0; j < ny; ++j)
                for (int i = 0; i < nx; ++i) heights_.push_back(height(x0 + i, 5 - j));
            field_ = dGeomHeightfieldDataCreate();
            dGeomHeightfieldDataBuildDouble(field_, heights_.data(), 0, real(x1 - x0), 10, nx, ny, 1, 0, 1,
                                            0);
            geom_ = dCreateHeightfield(sim.space, field_, 1);
            const dMatrix3 up = {1, 0, 0, 0, 0, 0, -1, 0, 0, 1, 0, 0};
            dGeomSetRotation(geom_, up);
            dGeomSetPosition(geom_, real((x0 + x1) / 2), 0, 0);
        } else {
            make_mesh(sim, x0, nx, ny, height);
        }
        set_material(geom_, friction);
    }
    ~Surface()
    {
        dGeomDestroy(geom_);
        if (field_) dGeomHeightfieldDataDestroy(field_);
        if (mesh_) dGeomTriMeshDataDestroy(mesh_);
    }
    Surface(const Surface&) = delete;
    Surface& operator=(const Surface&) = delete;

  private:
    // The cells' diagonals are those of a field.
    void make_mesh(Sim& sim, double x0, int nx, int ny, Height height)
    {
        for (int j = 0; j < ny; ++j)
            for (int i = 0; i < nx; ++i)
                vertices_.insert(vertices_.end(), {x0 + i, 5.0 - j, height(x0 + i, 5 - j)});
        for (int j = 0; j + 1 < ny; ++j)
            for (int i = 0; i + 1 < nx; ++i) {
                const auto a = dTriIndex(i + j * nx), b = a + 1, c = a + dTriIndex(nx), d = c + 1;
                triangles_.insert(triangles_.end(), {a, c, b, d, b, c});
            }
        mesh_ = dGeomTriMeshDataCreate();
        dGeomTriMeshDataBuildDouble(mesh_, vertices_.data(), 3 * sizeof(double), nx * ny, triangles_.data(),
                                    int(triangles_.size()), 3 * sizeof(dTriIndex));
        geom_ = dCreateTriMesh(sim.space, mesh_, nullptr, nullptr, nullptr);
    }

    dGeomID geom_;
    std::vector<double> heights_, vertices_;
    std::vector<dTriIndex> triangles_;
    dHeightfieldDataID field_ = nullptr;
    dTriMeshDataID mesh_ = nullptr;
};

enum class Shape { kBall, kCapsule, kBox, kCylinder };
constexpr Shape kShapes[] = {Shape::kBall, Shape::kCapsule, Shape::kBox, Shape::kCylinder};
enum class Way { kExact, kQuick, kSubsteps, kHybrid, kGame };
constexpr Way kWays[] = {Way::kExact, Way::kQuick, Way::kSubsteps, Way::kHybrid, Way::kGame};

void advance(dWorldID world, Way way, double h)
{
    switch (way) {
        case Way::kExact:
            dWorldStep(world, real(h));
            break;
        case Way::kQuick:
            dWorldQuickStep(world, real(h));
            break;
        case Way::kSubsteps:
            dWorldStepFast1(world, real(h), 4);
            break;
        default:
            dWorldStepHybrid(world, real(h));
    }
}

// A body that cannot turn.
dBodyID slider(Sim& sim, Shape shape, double radius, V3 foot)
{
    const double half = shape == Shape::kCapsule ? 2 * radius : radius;
    dGeomID geom = nullptr;
    switch (shape) {
        case Shape::kBall:
            geom = dCreateSphere(sim.space, real(radius));
            break;
        case Shape::kCapsule:
            geom = dCreateCapsule(sim.space, real(radius), real(2 * radius));
            break;
        case Shape::kBox:
            geom = dCreateBox(sim.space, real(2 * radius), real(2 * radius), real(2 * radius));
            break;
        case Shape::kCylinder:
            geom = dCreateCylinder(sim.space, real(radius), real(2 * radius));
            break;
    }
    const dBodyID body = sim.body({foot.x, foot.y, foot.z + half}, 70, 7e6);
    dGeomSetBody(geom, body);
    set_material(geom, 0);
    return body;
}

struct Path {
    std::vector<V3> at;
    V3 end_velocity;
    double fastest_up = 0, largest_loss = 0;  // |v_z|, and of |v| in a step
};

struct Slide {
    Shape shape;
    double radius, h;
    Height height;
    V3 start, velocity;
    double seconds;
};

Path slide_over(const std::vector<Part>& parts, Way way, const Slide& slide)
{
    WorldContactsSim sim(Stepper::kExact);
    if (way == Way::kGame) dWorldUseDefaults(sim.world, dDefaultsGame);
    sim.gravity(0, 0, -9.81);
    std::vector<std::unique_ptr<Surface>> floor;
    const double step = 2 * kFar / double(parts.size());
    for (std::size_t i = 0; i < parts.size(); ++i)
        floor.push_back(std::make_unique<Surface>(sim, parts[i], -kFar + double(i) * step,
                                                  -kFar + double(i + 1) * step, slide.height));
    const dBodyID body = slider(sim, slide.shape, slide.radius, slide.start);
    velocity(body, slide.velocity);
    Path path;
    for (int i = 0; i < int(slide.seconds / slide.h); ++i) {
        const double before = length(velocity(body));
        advance(sim.world, way, slide.h);
        path.at.push_back(position(body));
        if (i < 10) continue;  // it comes to rest in the layer
        path.fastest_up = std::fmax(path.fastest_up, std::fabs(velocity(body).z));
        path.largest_loss = std::fmax(path.largest_loss, before - length(velocity(body)));
    }
    path.end_velocity = velocity(body);
    return path;
}

double distance(const Path& a, const Path& b)
{
    double largest = 0;
    for (std::size_t i = 0; i < a.at.size(); ++i) largest = std::fmax(largest, length(a.at[i] - b.at[i]));
    return largest;
}

template <typename Visit>
void in_every_way(Visit visit)
{
    for (const Way way : kWays)
        for (const Shape shape : kShapes)
            for (const double h : {1.0 / 60, 1.0 / 240}) {
                SCOPED_TRACE(testing::Message()
                             << "way " << int(way) << ", shape " << int(shape) << ", h " << h);
                visit(way, shape, h);
            }
}

const std::vector<Part> kPairs[] = {{Part::kField, Part::kField}, {Part::kMesh, Part::kMesh},
                                    {Part::kBox, Part::kBox},     {Part::kBox, Part::kMesh},
                                    {Part::kMesh, Part::kField},  {Part::kField, Part::kBox}};

TEST(FlushSurfaces, let_what_slides_over_a_flat_border_slide_on)
{
    in_every_way([](Way way, Shape shape, double h) {
        for (const std::vector<Part>& parts : kPairs)
            for (const double radius : {0.1, 0.3}) {
                const Slide slide{shape, radius, h, flat, {-1, 0.37, 0}, {3, 0.4, 0}, 0.8};
                const Path path = slide_over(parts, way, slide);
                SCOPED_TRACE(testing::Message()
                             << "parts " << int(parts[0]) << int(parts[1]) << ", r " << radius);
                EXPECT_NEAR(path.end_velocity.x, 3, 0.003);
                EXPECT_NEAR(path.end_velocity.y, 0.4, 0.0004);
                EXPECT_LT(path.fastest_up, 0.02);
            }
    });
}

// The same as over one surface of the same samples: to 1.5 mm in the time that it takes to cross the border, and where
// a mesh meets a field to two, which are what a box on one differs from a box on the other. (Two fields took 1.5 % of a
// ball's speed.)
TEST(FlushSurfaces, of_hills_are_one_field)
{
    in_every_way([](Way way, Shape shape, double h) {
        const Slide slide{shape, 0.3, h, hills, {-1.2, 0.6, hills(-1.2, 0.6) + 0.02}, {3, 0.2, 0}, 0.7};
        for (const std::vector<Part>& parts : {kPairs[0], kPairs[1], kPairs[4]}) {
            const Path one = slide_over({parts[0]}, way, slide), two = slide_over(parts, way, slide);
            EXPECT_LT(distance(one, two), parts[0] == parts[1] ? 1.5e-3 : 2e-3)
                << "parts " << int(parts[0]) << int(parts[1]);
            EXPECT_NEAR(two.end_velocity.x, one.end_velocity.x, 0.01);
        }
    });
}

// Energy over a border that goes on smoothly: no step loses more than those on either side. (The facets on both sides of
// the border lean by 2 degrees against each other: of one field they are one manifold with one normal, of two fields two.)
TEST(FlushSurfaces, of_a_valley_take_no_energy)
{
    in_every_way([](Way way, Shape shape, double h) {
        const Slide slide{shape, 0.3, h, valley, {-2.5, 0.37, valley(-2.5, 0) + 0.02}, {3, 0.4, 0}, 1.2};
        const Path one = slide_over({Part::kField}, way, slide), two = slide_over(kPairs[0], way, slide);
        EXPECT_LT(two.largest_loss, one.largest_loss + 0.01);
        EXPECT_LT(distance(one, two), 4e-3);
    });
}

// A border at a step is a border: a ball that runs against it is stopped, one that rolls off it falls.
TEST(FlushSurfaces, do_not_hide_a_step)
{
    for (const Way way : kWays)
        for (const Part part : {Part::kMesh, Part::kField}) {
            SCOPED_TRACE(testing::Message() << "way " << int(way) << ", part " << int(part));
            WorldContactsSim sim(Stepper::kExact);
            if (way == Way::kGame) dWorldUseDefaults(sim.world, dDefaultsGame);
            const Surface low(sim, Part::kBox, -kFar, 0, flat);
            const Surface high(sim, part, 0, kFar, [](double, double) { return 0.1; });
            const dBodyID ball = slider(sim, Shape::kBall, 0.15, {-1, 0.37, 0});
            velocity(ball, {2, 0, 0});
            for (int i = 0; i < 120; ++i) advance(sim.world, way, 1.0 / 60);
            EXPECT_LT(position(ball).x, 0.01) << "stopped at the step";
            EXPECT_GT(position(ball).z, 0.15 - 2e-3);
            dBodySetPosition(ball, 1, real(0.37), real(0.25 + 1e-4));
            velocity(ball, {-2, 0, 0});
            for (int i = 0; i < 120; ++i) advance(sim.world, way, 1.0 / 60);
            EXPECT_LT(position(ball).x, -1);
            EXPECT_NEAR(position(ball).z, 0.15, 3e-3);
        }
}

// A box that lies half on one field and half on the other rests on both.
TEST(FlushSurfaces, carry_together)
{
    for (const Way way : kWays)
        for (const std::vector<Part>& parts : kPairs) {
            SCOPED_TRACE(testing::Message()
                         << "way " << int(way) << ", parts " << int(parts[0]) << int(parts[1]));
            WorldContactsSim sim(Stepper::kExact);
            if (way == Way::kGame) dWorldUseDefaults(sim.world, dDefaultsGame);
            const Surface left(sim, parts[0], -kFar, 0, flat, 0.5), right(sim, parts[1], 0, kFar, flat, 0.5);
            const dBodyID box = sim.box({0.07, 0.37, 0.301}, {0.8, 0.6, 0.6}, 5);
            for (int i = 0; i < 240; ++i) advance(sim.world, way, 1.0 / 60);
            EXPECT_NEAR(position(box).z, 0.3, 2e-3);
            EXPECT_NEAR(position(box).x, 0.07, 1e-3);
            EXPECT_NEAR(std::fabs(double(dBodyGetQuaternion(box)[0])), 1, 1e-6);
        }
}

}  // namespace
}  // namespace epode::physics
