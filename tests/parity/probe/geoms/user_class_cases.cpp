// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Geom classes of the client's own and replaced colliders: class numbers, data, boxes, vetoes, which collider
// is asked for and with which geom first, destruction. Four classes live as long as the library, so one case
// makes them all.
#include "case_list.h"

#include <algorithm>
#include <cstring>

namespace parity {
namespace {

std::string story;

void note(const char* words) { story += words; }

struct BallData {
    double radius;
};

void ball_box(dGeomID g, dReal box[6])
{
    const dReal* p = dGeomGetPosition(g);
    const double r = static_cast<const BallData*>(dGeomGetClassData(g))->radius;
    for (int i = 0; i < 3; ++i) {
        box[2 * i] = p[i] - r;
        box[2 * i + 1] = p[i] + r;
    }
}

int ball_collide(dGeomID a, dGeomID b, int, dContactGeom* contact, int)
{
    story += "collide" + std::to_string(dGeomGetClass(a)) + "-" + std::to_string(dGeomGetClass(b)) + ";";
    std::memset(contact, 0, sizeof *contact);
    contact->normal[1] = 1;
    contact->depth = 0.25;
    contact->pos[0] = 0.5;
    contact->g1 = a;
    contact->g2 = b;
    contact->side1 = 3;
    contact->side2 = 4;
    return 1;
}

dColliderFn* choose(int other)
{
    story += "asked" + std::to_string(other) + ";";
    return other == dCapsuleClass ? nullptr : &ball_collide;
}

int veto(dGeomID, dGeomID b, dReal*)
{
    note("veto;");
    return dGeomGetClass(b) == dBoxClass ? 0 : 1;
}

void destroyed(dGeomID) { note("destroyed;"); }

int make_class(bool tests)
{
    dGeomClass c = {};
    c.bytes = sizeof(BallData);
    c.collider = &choose;
    c.aabb = &ball_box;
    c.aabb_test = tests ? &veto : nullptr;
    c.dtor = tests ? &destroyed : nullptr;
    return dCreateGeomClass(&c);
}

dGeomID make_ball(int number, double radius)
{
    const dGeomID g = dCreateGeom(number);
    static_cast<BallData*>(dGeomGetClassData(g))->radius = radius;
    return g;
}

void put_story(Output& out, const std::string& key)
{
    out.put_text(key, "=" + story);
    story.clear();
}

void put_collision(Output& out, const std::string& key, dGeomID a, dGeomID b)
{
    dContactGeom c[4] = {};
    const int count = dCollide(a, b, 4, c, sizeof(dContactGeom));
    out.put(key + ".count", {static_cast<double>(count)});
    if (count > 0) {
        out.put(key + ".contact",
                {c[0].pos[0], c[0].normal[1], c[0].depth, static_cast<double>(c[0].side1),
                 static_cast<double>(c[0].side2), c[0].g1 == a ? 1.0 : 0.0, c[0].g2 == b ? 1.0 : 0.0});
    }
    put_story(out, key + ".story");
}

void note_pair(void*, dGeomID a, dGeomID b)
{
    const int low = std::min(dGeomGetClass(a), dGeomGetClass(b)),
              high = std::max(dGeomGetClass(a), dGeomGetClass(b));
    story += "pair" + std::to_string(low) + "-" + std::to_string(high) + ";";
}

PARITY_CASE(user_classes)
{
    int numbers[4];
    for (int i = 0; i < 4; ++i) { numbers[i] = make_class(i >= 2); }
    out.put("numbers", {double(numbers[0]), double(numbers[1]), double(numbers[2]), double(numbers[3])});
    const dGeomID first = make_ball(numbers[0], 1), second = make_ball(numbers[1], 2),
                  third = make_ball(numbers[2], 3);
    dGeomID plain[] = {dCreateSphere(nullptr, 1), dCreateBox(nullptr, 1, 1, 1), dCreateCapsule(nullptr, 1, 1),
                       dCreatePlane(nullptr, 0, 0, 1, 0), dCreateRay(nullptr, 2)};
    dGeomSetPosition(second, 3, 4, 5);
    dReal box[6] = {0};
    dGeomGetAABB(second, box);
    out.put("box", box, 6);
    out.put("classes",
            {double(dGeomGetClass(first)), double(dGeomGetClass(third)), double(dGeomIsSpace(first))});
    for (int round = 0; round < 2; ++round) {
        const std::string r = "round" + std::to_string(round);
        for (int i = 0; i < 5; ++i) {
            put_collision(out, r + "first" + std::to_string(i), first, plain[i]);
            put_collision(out, r + "back" + std::to_string(i), plain[i], third);
        }
        put_collision(out, r + "own", first, second);
        put_collision(out, r + "other", third, first);
    }
    const dSpaceID space = dSimpleSpaceCreate(nullptr);
    for (const dGeomID g : {first, second, third}) { dSpaceAdd(space, g); }
    for (const dGeomID g : plain) { dSpaceAdd(space, g); }
    dSpaceCollide(space, nullptr, &note_pair);
    std::size_t pairs = 0;
    for (std::size_t at = story.find("pair"); at != std::string::npos; at = story.find("pair", at + 1)) {
        ++pairs;
    }
    out.put("space.pairs", {double(pairs)});
    story.clear();
    dSpaceDestroy(space);
    put_story(out, "destroyed");
}

// A replaced collider serves both orders; removed, the pair collides no more. dCloseODE would forget it: the
// pair is of a class that no other case uses with itself.
int ray_meets_ray(dGeomID a, dGeomID b, int, dContactGeom* contact, int)
{
    std::memset(contact, 0, sizeof *contact);
    contact->depth = dGeomRayGetLength(a);
    contact->normal[2] = dGeomRayGetLength(b);
    contact->g1 = a;
    contact->g2 = b;
    return 1;
}

PARITY_CASE(user_override)
{
    const dGeomID a = dCreateRay(nullptr, 2), b = dCreateRay(nullptr, 2);
    dContactGeom c[2] = {};
    const auto put = [&](const char* key) {
        const int count = dCollide(a, b, 2, c, sizeof(dContactGeom));
        out.put(key, {double(count), count > 0 ? c[0].depth : 0.0});
    };
    put("before");
    dSetColliderOverride(dRayClass, dRayClass, &ray_meets_ray);
    put("replaced");
    dSetColliderOverride(dRayClass, dRayClass, nullptr);
    put("removed");
    dGeomDestroy(a);
    dGeomDestroy(b);
}

}  // namespace
}  // namespace parity
