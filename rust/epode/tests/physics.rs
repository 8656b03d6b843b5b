// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Is it Newton? Closed forms, through the safe crate.
#![allow(clippy::unnecessary_cast)] // Real is f32 with the feature single
use epode::{BodyDef, GeomDef, JointDef, Mass, Material, Method, Param, Real, Result, Shape, World, WorldDef};
use std::f64::consts::PI;

const SINGLE: bool = std::mem::size_of::<Real>() == 4;

/// In floats to 0.2 %, which the sums of hundreds of steps keep.
fn near(value: Real, wanted: f64, tolerance: f64) {
    let error = (value as f64 - wanted).abs();
    let allowed = if SINGLE { tolerance.max(2e-3 * wanted.abs().max(1.0)) } else { tolerance };
    assert!(error <= allowed, "{value} is not {wanted}: {error:e} off");
}

#[test]
fn free_fall_is_the_sum_of_semi_implicit_euler() -> Result<()> {
    let mut world = World::new()?;
    let ball =
        world.add_body(&BodyDef::new().position([0.0, 0.0, 100.0]).linear_vel([1.0, 0.0, 0.0]).shape(Shape::Sphere { radius: 0.5 }))?;
    let (h, steps) = (0.01, 200);
    for _ in 0..steps {
        world.step(h)?;
    }
    let n = f64::from(steps);
    let body = world.body(ball)?;
    // z = z0 - g h^2 n (n + 1) / 2 with velocities first; vz = -g n h; nothing acts along x.
    near(body.position()[2], 100.0 - 9.81 * 1e-4 * n * (n + 1.0) / 2.0, 1e-10);
    near(body.linear_vel()[2], -9.81 * n * 0.01, 1e-10);
    near(body.position()[0], n * 0.01, 1e-10);
    Ok(())
}

#[test]
fn a_pendulum_swings_with_its_period() -> Result<()> {
    // A point mass on a massless rod of length L, released at 0.1 rad: T = 2 pi sqrt(L/g) (1 + a^2/16 + 11 a^4/3072).
    let (length, amplitude, h) = (1.0f64, 0.1f64, 0.0005f64);
    let mut world = WorldDef::new().gravity([0.0, 0.0, -9.81]).build()?;
    let (x, z) = (length * amplitude.sin(), -length * amplitude.cos());
    let tiny = 1e-6;
    let bob = BodyDef::new().position([x as Real, 0.0, z as Real]).inertia(Mass::diagonal(1.0, [tiny; 3]));
    let bob = world.add_body(&bob)?;
    let hinge = world.add_joint(&JointDef::hinge(bob, None).anchor([0.0; 3]).axis([0.0, 1.0, 0.0]))?;
    let mut crossings = Vec::new();
    let mut before = world.body(bob)?.position()[0] as f64;
    for step in 1..=10000 {
        world.step(h as Real)?;
        let now = world.body(bob)?.position()[0] as f64;
        if before > 0.0 && now <= 0.0 {
            crossings.push((f64::from(step) - now / (now - before)) * h);
        }
        before = now;
    }
    let periods = (crossings.len() - 1) as f64;
    let period = (crossings[crossings.len() - 1] - crossings[0]) / periods;
    let wanted = 2.0 * PI * (length / 9.81).sqrt() * (1.0 + amplitude.powi(2) / 16.0);
    assert!((period / wanted - 1.0).abs() < if SINGLE { 1e-2 } else { 1e-4 }, "{period} s is not {wanted} s");
    // Its angle is 0 where it was made.
    assert!(world.joint(hinge)?.hinge_angle()?.abs() <= 0.201);
    Ok(())
}

#[test]
fn a_stack_stays_at_rest_and_its_contacts_carry_it() -> Result<()> {
    let mut world = World::new()?;
    let ground = world.add_geom(&GeomDef::new(Shape::ground()))?;
    let mut boxes = Vec::new();
    for level in 0..4 {
        let at = [0.0, 0.0, 0.5 + level as Real];
        boxes.push(world.add_body(&BodyDef::new().position(at).shape(Shape::cube(1.0)).mass(2.0))?);
    }
    for _ in 0..200 {
        world.step(0.01)?;
    }
    for (level, &id) in boxes.iter().enumerate() {
        let body = world.body(id)?;
        near(body.position()[2], 0.5 + level as f64, 2e-3);
        assert!(body.linear_vel().iter().all(|v| v.abs() < 1e-3));
    }
    let contacts = world.contacts();
    let on_ground = contacts.iter().filter(|c| c.geoms().is_some_and(|g| g.contains(&ground)));
    let carried: Real = on_ground.map(|c| c.normal_force()).sum();
    near(carried, 4.0 * 2.0 * 9.81, 1e-4);
    Ok(())
}

#[test]
fn a_ball_bounces_with_the_restitution_of_its_material() -> Result<()> {
    let mut world = World::new()?;
    world.set_cfm(0.0)?; // the default of floats softens the blow by 3 %
    let material = Material { bounce: 0.5, bounce_speed: 0.1, ..Material::default() };
    world.add_geom(&GeomDef::new(Shape::ground()).material(material.clone()))?;
    let ball = GeomDef::new(Shape::Sphere { radius: 0.1 }).material(material);
    let ball = world.add_body(&BodyDef::new().position([0.0, 0.0, 0.2]).linear_vel([0.0, 0.0, -4.0]).geom(ball))?;
    let mut fastest: Real = 0.0;
    let mut arrives: Real = 0.0;
    for _ in 0..60 {
        let v = world.body(ball)?.linear_vel()[2];
        arrives = arrives.min(v);
        world.step(0.001)?;
        fastest = fastest.max(world.body(ball)?.linear_vel()[2]);
    }
    near(fastest / -arrives, 0.5, 0.01);
    Ok(())
}

#[test]
fn joints_hold_what_their_builders_say() -> Result<()> {
    let mut world = World::new()?;
    let body = world.add_body(&BodyDef::new().shape(Shape::cube(0.2)).mass(1.0))?;
    let slider = JointDef::slider(body, None).axis([0.0, 0.0, 1.0]).limits(-0.5, 0.25).feedback();
    let slider = world.add_joint(&slider)?;
    for _ in 0..300 {
        world.step(0.01)?;
    }
    // The stop of the slider carries the body: the joint pushes it up with its weight.
    let joint = world.joint(slider)?;
    near(joint.slider_position()?, -0.5, 1e-6);
    near(joint.feedback().expect("it is kept").f1[2], 9.81, 1e-6);
    assert_eq!(joint.slider_param(Param::HI_STOP)?, 0.25);
    assert_eq!(joint.bodies(), [Some(body), None]);
    Ok(())
}

#[test]
fn every_method_lets_a_body_fall() -> Result<()> {
    for method in [Method::Exact, Method::Quick, Method::Hybrid, Method::Substeps(4)] {
        let mut world = World::new()?;
        let body = world.add_body(&BodyDef::new())?;
        world.step_by(method, 0.01)?;
        assert!(world.body(body)?.linear_vel()[2] < -0.09, "{method:?}");
    }
    Ok(())
}

#[test]
fn masses_are_those_of_the_shapes() -> Result<()> {
    let mut world = World::new()?;
    let cube = world.add_body(&BodyDef::new().shape(Shape::cube(2.0)).density(10.0))?;
    let mass = world.body(cube)?.mass();
    near(mass.mass, 80.0, 1e-10);
    near(mass.inertia[0][0], 80.0 * 8.0 / 12.0, 1e-9);
    // The same cube as triangles, off its origin: the origin of the body is its centre of mass.
    let corner = |i: usize| [(i & 1) as Real * 2.0 + 5.0, (i >> 1 & 1) as Real * 2.0, (i >> 2 & 1) as Real * 2.0];
    let vertices: Vec<_> = (0..8).map(corner).collect();
    let triangles = [
        [0, 2, 1],
        [1, 2, 3],
        [4, 5, 6],
        [5, 7, 6],
        [0, 1, 4],
        [1, 5, 4],
        [2, 6, 3],
        [3, 6, 7],
        [0, 4, 2],
        [2, 4, 6],
        [1, 3, 5],
        [3, 7, 5],
    ];
    let mesh = Shape::Mesh { vertices: &vertices, triangles: &triangles };
    let mesh = world.add_body(&BodyDef::new().position([9.0, 9.0, 9.0]).shape(mesh).density(10.0))?;
    let mass = world.body(mesh)?.mass();
    near(mass.mass, 80.0, 1e-9);
    near(mass.inertia[1][1], 80.0 * 8.0 / 12.0, 1e-8);
    let geom = world.body(mesh)?.geoms()[0];
    near(world.geom(geom)?.aabb()[0], 8.0, 1e-9);
    // Two halves make the whole, too.
    let half = |x| GeomDef::new(Shape::Box { lengths: [1.0, 2.0, 2.0] }).position([x, 0.0, 0.0]);
    let pair = world.add_body(&BodyDef::new().geom(half(0.0)).geom(half(1.0)).density(10.0))?;
    near(world.body(pair)?.mass().inertia[1][1], 80.0 * 8.0 / 12.0, 1e-9);
    Ok(())
}
