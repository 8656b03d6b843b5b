// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The same scene in C and in Rust has the same bits: a program of C is compiled against the headers and the library, and prints the
// hash of its state.
use epode::{step_worlds, BodyDef, GeomDef, JointDef, Material, Method, Param, Real, Result, Shape, Stepper, World, WorldDef};
use std::panic::{catch_unwind, AssertUnwindSafe};
use std::path::PathBuf;
use std::process::Command;

/// What golden.c prints.
fn hashes_of_c() -> Vec<u64> {
    let folder = env!("EPODE_LINKED"); // by build.rs
    let root = PathBuf::from(env!("CARGO_MANIFEST_DIR"));
    let include = std::env::var_os("EPODE_INCLUDE_DIR").map_or(root.join("../../include"), PathBuf::from);
    let program = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(format!("golden_{}", std::process::id()));
    let single = cfg!(feature = "single");
    let built = Command::new(std::env::var("CC").unwrap_or_else(|_| "cc".into()))
        .arg(if single { "-DdIDESINGLE" } else { "-DdIDEDOUBLE" })
        .arg(root.join("tests/golden.c"))
        .args(["-Wall", "-Werror", "-o"])
        .arg(&program)
        .arg("-I")
        .arg(include)
        .arg(format!("-L{folder}"))
        .arg(format!("-Wl,-rpath,{folder}"))
        .arg(if single { "-lode_single" } else { "-lode" })
        .status()
        .expect("a C compiler is needed");
    assert!(built.success());
    let out = Command::new(&program).output().unwrap();
    assert!(out.status.success());
    let text = String::from_utf8(out.stdout).unwrap();
    text.lines().map(|line| u64::from_str_radix(line, 16).unwrap()).collect()
}

fn scene() -> Result<World> {
    let mut world = World::new()?;
    world.set_erp(0.3)?;
    let rough = Material { friction: 0.9, bounce: 0.2, ..Material::default() };
    world.add_geom(&GeomDef::new(Shape::ground()).material(rough))?;
    let mut before = None;
    for i in 0..20 {
        let at = [0.3 * (i % 3) as Real, 0.2 * (i % 2) as Real, 1.0 + 0.8 * i as Real];
        let shape = if i % 2 == 0 { Shape::Box { lengths: [0.5, 0.6, 0.7] } } else { Shape::Sphere { radius: 0.3 } };
        let body = world.add_body(&BodyDef::new().position(at).shape(shape).density(700.0))?;
        if let (3, Some(other)) = (i % 4, before) {
            let hinge = JointDef::hinge(other, body).axis([0.0, 1.0, 0.0]).anchor(at);
            let hinge = hinge.param(Param::LO_STOP, -0.5).param(Param::HI_STOP, 0.5).motor(2.0, 5.0);
            world.add_joint(&hinge)?;
        }
        before = Some(body);
    }
    Ok(world)
}

#[test]
fn a_scene_has_the_bits_that_it_has_in_c() -> Result<()> {
    let mut world = scene()?;
    let mut hashes = vec![world.state_hash()?];
    for method in [Method::Exact, Method::Quick, Method::Hybrid, Method::Substeps(4)] {
        (0..60).try_for_each(|_| world.step_by(method, 0.01))?;
        hashes.push(world.state_hash()?);
    }
    let distinct: std::collections::HashSet<_> = hashes.iter().collect();
    assert_eq!(distinct.len(), 5);
    assert_eq!(hashes, hashes_of_c());
    Ok(())
}

#[test]
fn worlds_on_two_threads_have_the_bits_of_one() -> Result<()> {
    let run = |threads: i32| -> Result<u64> {
        let mut world = scene()?;
        world.set_step_threads(threads)?;
        (0..150).try_for_each(|_| world.step(0.01))?;
        world.state_hash()
    };
    let alone = run(1)?;
    let together: Vec<_> = std::thread::scope(|scope| {
        let running: Vec<_> = [1, 2, 1, 2].into_iter().map(|threads| scope.spawn(move || run(threads).unwrap())).collect();
        running.into_iter().map(|thread| thread.join().unwrap()).collect()
    });
    assert_eq!(together, [alone; 4]);
    Ok(())
}

#[test]
fn many_worlds_are_stepped_in_one_call_with_the_same_bits() -> Result<()> {
    let mut alone = WorldDef::new().history(5).build()?;
    let mut many = (0..6).map(|_| WorldDef::new().history(5).build()).collect::<Result<Vec<_>>>()?;
    for world in many.iter_mut().chain([&mut alone]) {
        world.add_geom(&GeomDef::new(Shape::ground()))?;
        world.add_body(&BodyDef::new().position([0.0, 0.0, 0.6]).quaternion([1.0, 0.2, 0.1, 0.0]).shape(Shape::cube(1.0)))?;
    }
    (0..30).try_for_each(|_| alone.step(0.01))?;
    assert_eq!(step_worlds(&mut many, 0.01, Stepper::Exact, 4, 30, 2)?, 6);
    for world in &mut many {
        assert_eq!(world.state_hash()?, alone.state_hash()?);
        let body = world.bodies()[0];
        world.remove_body(body)?;
    }
    step_worlds(&mut many, 0.01, Stepper::Exact, 4, 4, 2)?;
    many[3].roll_back(4)?;
    assert_eq!((many[3].state_hash()?, many[3].bodies().len()), (alone.state_hash()?, 1));
    assert!(step_worlds(&mut many, -0.01, Stepper::Exact, 4, 1, 2).is_err());
    assert!(step_worlds(&mut many, 0.01, Stepper::Substeps, 0, 1, 2).is_err());
    assert_eq!(step_worlds(&mut [], 0.01, Stepper::Exact, 4, 1, 2)?, 0);
    many[1].add_body(&BodyDef::new().position([0.0, 0.0, 0.5]).shape(Shape::cube(1.0)))?;
    many[1].set_contact_filter(|_, _| panic!("in one of them"))?;
    assert!(catch_unwind(AssertUnwindSafe(|| step_worlds(&mut many, 0.01, Stepper::Quick, 4, 2, 2))).is_err());
    many[1].remove_contact_filter()?;
    step_worlds(&mut many, 0.01, Stepper::Quick, 4, 2, 2).map(drop)
}

#[test]
fn a_world_goes_from_thread_to_thread() -> Result<()> {
    let mut here = scene()?;
    let mut there = scene()?;
    for _ in 0..5 {
        (0..10).try_for_each(|_| here.step(0.01))?;
        there = std::thread::spawn(move || {
            (0..10).for_each(|_| there.step(0.01).unwrap());
            there
        })
        .join()
        .unwrap();
    }
    assert_eq!(here.state_hash()?, there.state_hash()?);
    Ok(())
}
