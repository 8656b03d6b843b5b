// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors

//! A pendulum on a hinge, and its period compared with the formula.
use epode::{BodyDef, JointDef, Mass, Real, World};

fn main() -> epode::Result<()> {
    let mut world = World::new()?;
    let bob = world.add_body(&BodyDef::new().position([1.0, 0.0, 0.0]).inertia(Mass::diagonal(1.0, [1e-6; 3])))?;
    let hinge = world.add_joint(&JointDef::hinge(bob, None).anchor([0.0; 3]).axis([0.0, 1.0, 0.0]).feedback())?;

    let h: Real = 0.001;
    let mut steps = 0;
    let mut passed = Vec::new(); // times at which it passes the lowest point
    while passed.len() < 3 {
        let before = world.joint(hinge)?.hinge_angle_rate()?;
        let x = world.body(bob)?.position()[0];
        world.step(h)?;
        steps += 1;
        let now = world.body(bob)?.position()[0];
        if x.signum() != now.signum() {
            passed.push(h * steps as Real);
            let pull = world.joint(hinge)?.feedback().map_or(0.0, |feedback| feedback.f1[2]);
            println!("{:.2} s: lowest, {:.2} rad/s, the hinge carries {:.1} N", h * steps as Real, before.abs(), pull);
        }
    }
    // Released at 90 degrees: 1.18034 times the period of small swings.
    let wanted = 2.0 * std::f64::consts::PI / 9.81f64.sqrt() * 1.18034;
    println!("period {:.2} s, by the formula {:.2} s", passed[2] - passed[0], wanted);
    Ok(())
}
