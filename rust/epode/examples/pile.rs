// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors

//! A pile of boxes and balls that falls on the ground and comes to rest, on two threads.
use epode::{BodyDef, Defaults, GeomDef, Material, Real, Shape, WorldDef};

fn main() -> epode::Result<()> {
    let mut world = WorldDef::new().defaults(Defaults::Game).threads(2).build()?;
    let rough = Material { friction: 0.8, ..Material::default() };
    world.add_geom(&GeomDef::new(Shape::ground()).material(rough.clone()))?;
    let mut bodies = Vec::new();
    for i in 0..100 {
        let at = [(i % 5) as Real - 2.0, (i / 5 % 5) as Real - 2.0, 1.0 + 1.2 * (i / 25) as Real];
        let shape = if i % 3 == 0 { Shape::Sphere { radius: 0.4 } } else { Shape::cube(0.7) };
        bodies.push(world.add_body(&BodyDef::new().position(at).geom(GeomDef::new(shape).material(rough.clone())).density(500.0))?);
    }
    for second in 1..=3 {
        for _ in 0..60 {
            world.step(1.0 / 60.0)?;
        }
        let mut awake = 0;
        for &id in &bodies {
            awake += usize::from(world.body(id)?.is_enabled());
        }
        println!("{second} s: {awake} of {} bodies awake", bodies.len());
    }
    let mut lowest: Real = Real::INFINITY;
    for &id in &bodies {
        lowest = lowest.min(world.body(id)?.position()[2]);
    }
    println!("the lowest centre is {lowest:.2} m above the ground");
    Ok(())
}
