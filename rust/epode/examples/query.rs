// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors

//! Rays, casts, overlaps and distances in a room, without a step.
use epode::{BodyDef, Filter, GeomDef, GeomId, Real, Shape, World};

const GLASS: u64 = 2;

fn main() -> epode::Result<()> {
    let mut world = World::new()?;
    world.add_geom(&GeomDef::new(Shape::ground()).tag(1))?;
    let pane = Shape::Box { lengths: [0.02, 4.0, 3.0] };
    let pane = world.add_geom(&GeomDef::new(pane).position([2.0, 0.0, 1.5]).bits(GLASS, u64::MAX).tag(2))?;
    world.add_geom(&GeomDef::new(Shape::Box { lengths: [0.2, 6.0, 3.0] }).position([4.0, 0.0, 1.5]).tag(3))?;
    let robot = world.add_body(&BodyDef::new().position([0.0, 0.0, 0.5]).shape(Shape::Cylinder { radius: 0.3, length: 1.0 }))?;
    let hull = world.body(robot)?.geoms()[0];
    let name = |geom: GeomId| ["?", "ground", "glass", "wall"][world.geom(geom).map_or(0, |geom| geom.tag()) as usize];

    let (eye, ahead): ([Real; 3], [Real; 3]) = ([0.0, 0.0, 0.8], [1.0, 0.0, 0.0]);
    let me = || Filter::new().skip_body(robot);
    if let Some(hit) = world.ray(eye, ahead, 10.0, &me())? {
        println!("ahead: {} at {:.2} m", name(hit.geom), hit.distance);
    }
    let mut opaque = |geom: GeomId| geom != pane;
    if let Some(hit) = world.ray(eye, ahead, 10.0, &me().keep(&mut opaque))? {
        println!("through the glass: {} at {:.2} m", name(hit.geom), hit.distance);
    }
    let all: Vec<_> = world.ray_all(eye, ahead, 10.0, &me())?.iter().map(|hit| name(hit.geom)).collect();
    println!("on the way: {}", all.join(", "));

    // A scanner: many rays in one call, on two threads.
    let turns = (0..360).map(|i| (i as Real).to_radians());
    let directions: Vec<_> = turns.map(|a| [a.cos(), a.sin(), 0.0]).collect();
    let hits = world.ray_batch(&[eye; 360], &directions, &[10.0; 360], &me(), 2)?;
    println!("the scanner sees something at {} of 360 degrees", hits.iter().flatten().count());

    if let Some(hit) = world.cast(hull, [3.0, 0.0, 0.0], &Filter::new())? {
        println!("the robot may drive {:.2} m until it meets the {}", hit.distance, name(hit.geom));
    }
    if let Some(near) = world.distance(hull, pane, Real::INFINITY)? {
        println!("the glass is {:.2} m away", near.distance);
    }
    println!("touching: {}", world.overlaps(hull, &Filter::new())?.iter().map(|&geom| name(geom)).collect::<Vec<_>>().join(", "));
    Ok(())
}
