// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors

//! A ragdoll of capsules, balls and hinges falls down stairs; its hardest blow is reported.
use epode::{BodyDef, BodyId, Defaults, EventKind, EventSettings, GeomDef, JointDef, Real, Shape, Vec3, World, WorldDef};

struct Ragdoll {
    parts: Vec<(&'static str, BodyId)>,
}

impl Ragdoll {
    fn new(world: &mut World, [x, y, z]: Vec3) -> epode::Result<Self> {
        let mut ragdoll = Ragdoll { parts: Vec::new() };
        let torso = ragdoll.part(world, "torso", [x, y, z], 0.14, 0.35, 30.0)?;
        let head = ragdoll.part(world, "head", [x, y, z + 0.45], 0.11, 0.05, 5.0)?;
        world.add_joint(&JointDef::ball(torso, head).anchor([x, y, z + 0.3]))?;
        for (side, arm, thigh, shin) in [(-1.0, "left arm", "left thigh", "left shin"), (1.0, "right arm", "right thigh", "right shin")] {
            let arm = ragdoll.part(world, arm, [x, y + 0.26 * side, z], 0.05, 0.5, 4.0)?;
            world.add_joint(&JointDef::ball(torso, arm).anchor([x, y + 0.24 * side, z + 0.25]))?;
            let thigh = ragdoll.part(world, thigh, [x, y + 0.1 * side, z - 0.55], 0.07, 0.3, 8.0)?;
            world.add_joint(&JointDef::ball(torso, thigh).anchor([x, y + 0.1 * side, z - 0.32]))?;
            let shin = ragdoll.part(world, shin, [x, y + 0.1 * side, z - 1.0], 0.06, 0.3, 4.0)?;
            let knee = JointDef::hinge(thigh, shin).anchor([x, y + 0.1 * side, z - 0.78]).axis([0.0, 1.0, 0.0]);
            world.add_joint(&knee.limits(-2.2, 0.0))?;
        }
        Ok(ragdoll)
    }

    fn part(&mut self, world: &mut World, name: &'static str, at: Vec3, radius: Real, length: Real, mass: Real) -> epode::Result<BodyId> {
        let id = world.add_body(&BodyDef::new().position(at).shape(Shape::Capsule { radius, length }).mass(mass))?;
        self.parts.push((name, id));
        Ok(id)
    }

    fn name_of(&self, body: Option<BodyId>) -> &'static str {
        self.parts.iter().find(|(_, id)| Some(*id) == body).map_or("?", |(name, _)| name)
    }
}

fn main() -> epode::Result<()> {
    let kinds = 1 << EventKind::ContactBegin as u32;
    let events = EventSettings { kinds, ..EventSettings::default() };
    let mut world = WorldDef::new().defaults(Defaults::Game).events(events).build()?;
    world.add_geom(&GeomDef::new(Shape::ground()))?;
    for i in 0..6 {
        let step = Shape::Box { lengths: [0.4, 3.0, 0.3 * (6 - i) as Real] };
        world.add_geom(&GeomDef::new(step).position([0.4 * i as Real, 0.0, 0.15 * (6 - i) as Real]))?;
    }
    let ragdoll = Ragdoll::new(&mut world, [0.0, 0.0, 3.2])?;
    for &(_, id) in &ragdoll.parts {
        world.body_mut(id)?.set_linear_vel([1.5, 0.0, 0.0])?;
        // Nothing stops a limb of a hard body that rolls about its shoulder; muscles do.
        world.body_mut(id)?.set_angular_damping(0.05)?;
    }
    let (mut blows, mut hardest) = (0, (0.0, "nothing"));
    for _ in 0..60 * 6 {
        world.step(1.0 / 60.0)?;
        for event in world.events() {
            let body = event.geom1.and_then(|geom| world.geom(geom).ok()?.body());
            blows += 1;
            if event.impulse > hardest.0 {
                hardest = (event.impulse, ragdoll.name_of(body));
            }
        }
    }
    let still = ragdoll.parts.iter().all(|&(_, id)| world.body(id).is_ok_and(|body| body.linear_vel().iter().all(|v| v.abs() < 0.1)));
    println!("{} parts, {} joints; at rest: {still}", ragdoll.parts.len(), world.joints().len());
    println!("{blows} blows; the hardest: {:.0} N s on the {}", hardest.0, hardest.1);
    Ok(())
}
