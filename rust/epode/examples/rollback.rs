// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors

//! A game on a network: another player's input arrives late, so ten steps are taken back and made again with it. The result has the
//! bits that it has if the input is there at once.
use epode::{BodyDef, BodyId, GeomDef, Real, Shape, World, WorldDef};

const H: Real = 1.0 / 60.0;

fn game() -> epode::Result<(World, [BodyId; 2])> {
    let mut world = WorldDef::new().history(30).build()?;
    world.add_geom(&GeomDef::new(Shape::ground()))?;
    let player = |x| BodyDef::new().position([x, 0.0, 0.5]).shape(Shape::Sphere { radius: 0.5 }).mass(10.0);
    let players = [world.add_body(&player(-2.0))?, world.add_body(&player(2.0))?];
    for i in 0..5 {
        world.add_body(&BodyDef::new().position([0.0, 0.0, 0.25 + 0.5 * i as Real]).shape(Shape::cube(0.5)).mass(1.0))?;
    }
    world.set_history(30)?; // from here on
    Ok((world, players))
}

/// A frame: each player has an input, the velocity that it wants.
fn frame(world: &mut World, players: [BodyId; 2], inputs: [Real; 2]) -> epode::Result<()> {
    for (player, input) in players.into_iter().zip(inputs) {
        let mut body = world.body_mut(player)?;
        let v = body.linear_vel()[0];
        body.add_force([100.0 * (input - v), 0.0, 0.0])?;
    }
    world.step(H)
}

fn main() -> epode::Result<()> {
    let theirs = |number: i32| if number < 20 { 0.0 } else { -3.0 };
    let ours = 3.0;

    // All inputs known.
    let (mut world, players) = game()?;
    for number in 0..90 {
        frame(&mut world, players, [ours, theirs(number)])?;
    }
    let wanted = world.state_hash()?;

    // Theirs arrive ten frames late: until then the last known one is assumed, and a shot is fired that never was.
    let (mut world, players) = game()?;
    let delay = 10;
    for number in 0..30 {
        frame(&mut world, players, [ours, theirs(number - delay)])?;
    }
    let shot = world.add_body(&BodyDef::new().position([0.0, 3.0, 1.0]).shape(Shape::Sphere { radius: 0.1 }))?;
    world.roll_back(delay)?;
    println!("frame 20 again; the shot is gone: {}", world.body(shot).is_err());
    for number in 20..90 {
        frame(&mut world, players, [ours, theirs(number)])?;
    }
    println!("same bits as with all inputs at once: {}", world.state_hash()? == wanted);
    println!("{} steps can be taken back", world.history_frames());
    Ok(())
}
