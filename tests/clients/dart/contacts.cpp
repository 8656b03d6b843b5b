// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A client of Debian's DART and of nothing of ours: its collision detector by ODE on random pairs of its
// shapes. Compiled once, run on two libode.so.8. Pairs are drawn close to each other, so that most touch.
// Prints, after the library (preamble.cpp), a line for every pair:
//   pair FIRST SECOND CONTACTS DEPTH LEFT SUNK NX NY NZ
// DEPTH and the normal (from the first to the second) are of the deepest contact, LEFT is the number of
// contacts when the second has been moved away by that depth, SUNK how far points of the second lie under the
// first where that is a plane, the torus or the height field, computed here (-9: not computed). contacts.cpp
// COUNT TORUS: TORUS is the .obj of the mesh shape, radii 0.6 and 0.25 about z.
#include <cstdio>
#include <cstdlib>
#include <dart/collision/ode/ode.hpp>
#include <dart/dynamics/BoxShape.hpp>
#include <dart/dynamics/CapsuleShape.hpp>
#include <dart/dynamics/CylinderShape.hpp>
#include <dart/dynamics/HeightmapShape.hpp>
#include <dart/dynamics/MeshShape.hpp>
#include <dart/dynamics/PlaneShape.hpp>
#include <dart/dynamics/SimpleFrame.hpp>
#include <dart/dynamics/SphereShape.hpp>
#include <random>

namespace {

using namespace dart::dynamics;
using dart::collision::CollisionResult;
using Random = std::mt19937_64;

double between(Random& random, double low, double high)
{
    return low + (high - low) * static_cast<double>(random() >> 11) * 0x1p-53;
}

Eigen::Vector3d direction(Random& random)
{
    for (;;) {
        const Eigen::Vector3d v(between(random, -1, 1), between(random, -1, 1), between(random, -1, 1));
        if (v.norm() < 1 && v.norm() > 0.1) return v.normalized();
    }
}

constexpr const char* kNames[] = {"sphere", "box", "capsule", "cylinder", "mesh", "plane", "heights"};
constexpr int kMoving = 5;  // all that may be turned about come first
constexpr double kTorus = 0.6, kTube = 0.25;
constexpr double kCell = 0.25;
constexpr int kCells = 20;

double ground_height(double column, double row) { return 0.3 * std::sin(0.7 * column) * std::cos(0.9 * row); }

// Mesh and height field are large: what meets them is not inside.
struct Drawn {
    ShapePtr shape;
    double reach;  // from its place to where another one touches it, about
};

Drawn draw(Random& random, int kind, const ShapePtr& mesh)
{
    const double r = between(random, 0.2, 0.6), h = between(random, 0.4, 1.2);
    switch (kind) {
        case 0:
            return {std::make_shared<SphereShape>(r), r};
        case 1:
            return {std::make_shared<BoxShape>(Eigen::Vector3d(r, h, r + 0.1)), 0.4 * (r + h)};
        case 2:
            return {std::make_shared<CapsuleShape>(r, h), r + h / 4};
        case 3:
            return {std::make_shared<CylinderShape>(r, h), 0.5 * (r + h / 2)};
        case 4:
            return {mesh, 0.8};
        case 5:
            return {std::make_shared<PlaneShape>(direction(random), between(random, -0.5, 0.5)), 0};
        default: {
            const auto ground = std::make_shared<HeightmapShaped>();
            std::vector<double> heights;
            for (int i = 0; i < (kCells + 1) * (kCells + 1); ++i)
                heights.push_back(ground_height(i % (kCells + 1), i / (kCells + 1)));
            ground->setHeightField(kCells + 1, kCells + 1, heights);
            ground->setScale(Eigen::Vector3d(kCell, kCell, 1));
            return {ground, 0};
        }
    }
}

// Where the second one stands, so that it touches more often than not.
Eigen::Isometry3d place(Random& random, const Drawn& first, const Drawn& second, int kind)
{
    Eigen::Isometry3d at = Eigen::Isometry3d::Identity();
    at.linear() = Eigen::AngleAxisd(between(random, 0, 6), direction(random)).toRotationMatrix();
    const double share = between(random, 0.6, 1.05);
    at.translation() = direction(random) * share * (first.reach + second.reach);
    if (kind == 5) {
        const auto plane = std::static_pointer_cast<PlaneShape>(first.shape);
        at.translation() = plane->getNormal() * (plane->getOffset() + share * second.reach);
    }
    if (kind == 6)
        at.translation() << between(random, -1.5, 1.5), between(random, -1.5, 1.5), share * second.reach;
    return at;
}

// A point on the surface of a shape, and for the torus on its fold.
Eigen::Vector3d point_of(Random& random, const Shape& shape)
{
    const Eigen::Vector3d d = direction(random);
    if (const auto* sphere = dynamic_cast<const SphereShape*>(&shape)) return sphere->getRadius() * d;
    if (const auto* box = dynamic_cast<const BoxShape*>(&shape))
        return box->getSize().cwiseProduct(d / d.cwiseAbs().maxCoeff()) / 2;
    const double turn = between(random, 0, 7), up = between(random, -0.5, 0.5);
    const Eigen::Vector3d out(std::cos(turn), std::sin(turn), 0), z(0, 0, 1);
    if (const auto* capsule = dynamic_cast<const CapsuleShape*>(&shape))
        return capsule->getRadius() * d + up * capsule->getHeight() * z;
    if (const auto* cylinder = dynamic_cast<const CylinderShape*>(&shape)) {
        const bool end = random() & 1;
        const double radius = cylinder->getRadius() * (end ? std::sqrt(between(random, 0, 1)) : 1);
        return radius * out + (end ? std::copysign(0.5, up) : up) * cylinder->getHeight() * z;
    }
    const double bend = between(random, 0, 7);
    return kTorus * out + kTube * (std::cos(bend) * out + std::sin(bend) * z);
}

// How deep under the surface of the first a point lies.
double depth_under(const Shape& first, const Eigen::Vector3d& p)
{
    if (const auto* plane = dynamic_cast<const PlaneShape*>(&first))
        return plane->getOffset() - plane->getNormal().dot(p);
    if (dynamic_cast<const MeshShape*>(&first))
        return kTube - std::hypot(std::hypot(p[0], p[1]) - kTorus, p[2]);
    return ground_height(p[0] / kCell + kCells / 2, kCells / 2 - p[1] / kCell) - p[2];
}

double sunk(const Drawn& first, const Drawn& second, const Eigen::Isometry3d& at, int kind)
{
    if (kind < 4) return -9;
    Random random(1);
    double deepest = -9;
    for (int i = 0; i < 4000; ++i)
        deepest = std::max(deepest, depth_under(*first.shape, at * point_of(random, *second.shape)));
    return deepest;
}

const dart::collision::Contact* deepest(const CollisionResult& result)
{
    const dart::collision::Contact* found = nullptr;
    for (const auto& contact : result.getContacts())
        if (!found || contact.penetrationDepth > found->penetrationDepth) found = &contact;
    return found;
}

}  // namespace

int main(int argc, char** argv)
{
    if (argc != 3) return 2;
    const aiScene* read = MeshShape::loadMesh(argv[2]);
    if (!read) return 1;
    const auto mesh = std::make_shared<MeshShape>(Eigen::Vector3d(1, 1, 1), read);
    const auto detector = dart::collision::OdeCollisionDetector::create();
    Random random(25);
    for (int i = 0; i < std::atoi(argv[1]); ++i) {
        const int a = static_cast<int>(random() % 7), b = static_cast<int>(random() % kMoving);
        const Drawn first = draw(random, a, mesh), second = draw(random, b, mesh);
        const auto fixed = SimpleFrame::createShared(Frame::World());
        const auto moving = SimpleFrame::createShared(Frame::World());
        fixed->setShape(first.shape);
        moving->setShape(second.shape);
        Eigen::Isometry3d at = place(random, first, second, a);
        moving->setRelativeTransform(at);
        const auto group = detector->createCollisionGroup(fixed.get(), moving.get());
        const dart::collision::CollisionOption all(true, 1000);
        CollisionResult result, later;
        group->collide(all, &result);
        dart::collision::Contact contact{};
        if (const auto* found = deepest(result)) contact = *found;
        if (contact.collisionObject1 && contact.collisionObject1->getShapeFrame() == fixed.get())
            contact.normal *= -1;  // from the first to the second now
        std::printf("pair %s %s %zu %.12g", kNames[a], kNames[b], result.getNumContacts(),
                    contact.penetrationDepth);
        const double under = sunk(first, second, at, a);
        at.translation() += (1.001 * contact.penetrationDepth + 1e-6) * contact.normal;
        moving->setRelativeTransform(at);
        if (contact.penetrationDepth > 0) group->collide(all, &later);
        std::printf(" %zu %.4f %.9g %.9g %.9g\n", later.getNumContacts(), under, contact.normal[0],
                    contact.normal[1], contact.normal[2]);
    }
    std::puts("#end");
}
