// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Programs that an outsider might write: each does what should not be done and compiles, and must end in an error, a panic of its own
// or the right answer. (What must not compile is in the documentation of lib.rs.)
use epode::{
    BodyDef, BodyId, CharacterSettings, ErrorKind, Filter, GeomDef, GeomId, JointDef, JointKind, Method, Param, Real, Result, Shape, World,
    WorldDef,
};
use std::cell::RefCell;
use std::panic::{catch_unwind, AssertUnwindSafe};
use std::sync::{Arc, Mutex};

fn world_with_ball() -> Result<(World, BodyId)> {
    let mut world = World::new()?;
    world.add_geom(&GeomDef::new(Shape::ground()))?;
    let ball = world.add_body(&BodyDef::new().position([0.0, 0.0, 0.5]).shape(Shape::Sphere { radius: 0.5 }))?;
    Ok((world, ball))
}

#[test]
fn handles_are_kept_after_the_world_is_gone() -> Result<()> {
    let mut stored = Vec::new();
    for _ in 0..50 {
        let (world, ball) = world_with_ball()?;
        for &old in &stored {
            assert_eq!(world.body(old).err().map(|e| e.kind()), Some(ErrorKind::OtherWorld));
            assert!(world.body(BodyId::in_world(old, &world)).is_err(), "no copy of that world");
        }
        stored.push(ball);
    }
    Ok(())
}

thread_local! {
    static HIDDEN: RefCell<Option<World>> = const { RefCell::new(None) };
}

#[test]
fn a_callback_steps_its_own_world_by_a_back_door() -> Result<()> {
    let (mut world, ball) = world_with_ball()?;
    world.set_contact_filter(|_, _| HIDDEN.with(|hidden| hidden.borrow_mut().as_mut().unwrap().step(0.01).is_ok()))?;
    HIDDEN.with(|hidden| *hidden.borrow_mut() = Some(world));
    // The world is lent to the step: the second borrow panics, within C, and that goes on when the step is over.
    let caught = catch_unwind(|| HIDDEN.with(|hidden| hidden.borrow_mut().as_mut().unwrap().step(0.01)));
    assert!(caught.is_err());
    let mut world = HIDDEN.with(|hidden| hidden.borrow_mut().take().unwrap());
    world.remove_contact_filter()?;
    world.step(0.01)?;
    assert!(world.body(ball)?.position()[2] > 0.4);
    Ok(())
}

#[test]
fn a_callback_locks_the_mutex_that_its_world_is_in() -> Result<()> {
    let (world, _) = world_with_ball()?;
    let shared = Arc::new(Mutex::new(world));
    let own = Arc::downgrade(&shared);
    let locked = Arc::new(Mutex::new(Vec::new()));
    let seen = locked.clone();
    shared.lock().unwrap().set_contact_filter(move |_, _| {
        seen.lock().unwrap().push(own.upgrade().unwrap().try_lock().is_ok());
        true
    })?;
    shared.lock().unwrap().step(0.01)?;
    assert!(locked.lock().unwrap().iter().all(|&locked| !locked));
    Ok(())
}

#[test]
fn a_world_dies_on_another_thread_while_others_are_made() -> Result<()> {
    let run = |seed: usize| {
        for i in 0..40 {
            let (mut world, _) = world_with_ball().unwrap();
            let vertices = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
            let mesh = Shape::Mesh { vertices: &vertices, triangles: &[[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]] };
            let mesh = world.add_body(&BodyDef::new().position([0.0, 0.0, 2.0]).shape(mesh)).unwrap();
            world.add_character(&CharacterSettings::default(), [3.0, 0.0, 0.0]).unwrap();
            world.add_joint(&JointDef::ball(mesh, None)).unwrap();
            world.step_by([Method::Exact, Method::Quick, Method::Hybrid][(seed + i) % 3], 0.01).unwrap();
            assert!(world.step(-1.0).is_err(), "each thread has its own refusals");
            let copy = world.try_clone().unwrap();
            std::thread::spawn(move || drop(world));
            drop(copy);
        }
    };
    std::thread::scope(|scope| (0..4).for_each(|seed| drop(scope.spawn(move || run(seed)))));
    Ok(())
}

#[test]
fn worlds_are_swapped_and_moved_under_their_callbacks() -> Result<()> {
    let (mut one, ball) = world_with_ball()?;
    let (mut two, other) = world_with_ball()?;
    let received = Arc::new(Mutex::new(Vec::new()));
    for world in [&mut one, &mut two] {
        let received = received.clone();
        world.set_contact_filter(move |a, b| {
            received.lock().unwrap().extend([a.body, b.body].into_iter().flatten());
            true
        })?;
    }
    std::mem::swap(&mut one, &mut two);
    let mut boxed = Box::new(one);
    boxed.step(0.01)?;
    let mut list = [*boxed, two];
    list.swap(0, 1);
    list[0].step(0.01)?;
    assert_eq!(*received.lock().unwrap(), [other, ball]);
    assert!(list[0].body(ball).is_ok() && list[0].body(other).is_err());
    Ok(())
}

struct PanicsWhenDropped;
impl Drop for PanicsWhenDropped {
    fn drop(&mut self) {
        if !std::thread::panicking() {
            panic!("dropped");
        }
    }
}

#[test]
fn what_a_callback_owns_panics_when_it_is_dropped() -> Result<()> {
    let (mut world, _) = world_with_ball()?;
    let bomb = PanicsWhenDropped;
    world.set_contact_filter(move |_, _| {
        let _ = &bomb;
        true
    })?;
    assert!(catch_unwind(AssertUnwindSafe(|| world.set_contact_filter(|_, _| true))).is_err());
    world.step(0.01)?;
    let bomb = PanicsWhenDropped;
    world.on_moved(move |_| {
        let _ = &bomb;
    });
    assert!(catch_unwind(AssertUnwindSafe(|| drop(world))).is_err());
    let (mut next, _) = world_with_ball()?;
    next.step(0.01)
}

#[test]
fn views_and_worlds_are_forgotten() -> Result<()> {
    let (mut world, ball) = world_with_ball()?;
    #[allow(clippy::forget_non_drop)]
    std::mem::forget(world.body_mut(ball)?);
    world.remove_body(ball)?;
    assert!(world.body(ball).is_err());
    std::mem::forget(world.try_clone()?);
    world.step(0.01)
}

#[test]
fn a_querys_filter_answers_at_random() -> Result<()> {
    let (mut world, ball) = world_with_ball()?;
    for i in 0..100 {
        world.add_geom(&GeomDef::new(Shape::Sphere { radius: 0.4 }).position([i as Real + 1.0, 0.0, 3.0]))?;
    }
    let mut calls = 0u32;
    let mut fickle = |_: GeomId| {
        calls += 1;
        calls % 3 != 0
    };
    let hits = world.ray_all([-5.0, 0.0, 3.0], [1.0, 0.0, 0.0], Real::INFINITY, &Filter::new().keep(&mut fickle))?;
    assert!(hits.len() > 20 && hits.windows(2).all(|pair| pair[0].distance <= pair[1].distance));
    assert!(world.body(ball).is_ok());
    Ok(())
}

#[test]
fn a_querys_filter_reads_all_that_can_be_read() -> Result<()> {
    let (mut world, ball) = world_with_ball()?;
    world.set_diagnosis_mode(true)?;
    (0..5).try_for_each(|_| world.step(0.01))?;
    let wanted = world.state_hash()?;
    let mut calls = 0;
    let mut reader = |geom: GeomId| {
        calls += 1;
        let copy = world.try_clone().unwrap();
        assert_eq!(copy.state_hash().unwrap(), wanted);
        assert_eq!(world.state_hash().unwrap(), wanted);
        let around = world.overlaps(geom, &Filter::new()).unwrap_or_default();
        let counts = (around.len(), world.contacts().len(), world.diagnose().len(), world.events().len(), world.geoms().len());
        assert_eq!((counts.1, counts.4, world.body(ball).unwrap().joints().len()), (1, 2, 0));
        let _ = (world.cast(geom, [0.0, 0.0, 1.0], &Filter::new()), world.geom(geom).unwrap().aabb());
        true
    };
    assert_eq!(world.ray_all([0.0, 0.0, 5.0], [0.0, 0.0, -1.0], 9.0, &Filter::new().keep(&mut reader))?.len(), 2);
    assert!(calls >= 2);
    assert_eq!(world.state_hash()?, wanted);
    Ok(())
}

#[test]
fn numbers_are_extreme_everywhere() -> Result<()> {
    let (mut world, ball) = world_with_ball()?;
    let joint = world.add_joint(&JointDef::hinge(ball, None))?;
    for number in [i32::MIN, -1, 1_000_000, i32::MAX] {
        let _ = world.set_history(number);
        let _ = world.roll_back(number);
        let _ = world.set_exact_substeps(number);
        let _ = world.set_quick_step_num_iterations(number.min(1000));
        let _ = world.island_step_report(number);
        let _ = world.joint_mut(joint)?.set_axis_turn(number, 1.0);
        let _ = world.joint(joint)?.coupling_joint(number);
        let geom = world.body(ball)?.geoms()[0];
        assert!(world.geom(geom)?.triangles(number).is_err());
        assert!(world.geom(geom)?.mesh_triangle(number).is_err());
    }
    for axis in 0..=u8::MAX {
        let _ = world.joint_mut(joint)?.set_param(Param::HI_STOP.of_axis(axis), 1.0);
    }
    assert!(world.step_by(Method::Substeps(u16::MAX), 0.01).is_err());
    assert!(world.step_by(Method::Substeps(0), 0.01).is_err());
    assert!(world.ray_batch(&[], &[], &[], &Filter::new(), i32::MAX)?.is_empty());
    for kind in [JointKind::None, JointKind::Contact] {
        assert!(world.add_joint(&JointDef::new(kind, ball, None)).is_err());
    }
    let _ = world.set_history(0);
    world.step(0.01)?;
    assert!(world.body(ball)?.position().iter().all(|x| x.is_finite()));
    Ok(())
}

#[test]
fn everything_is_added_removed_and_rolled_back_at_random() -> Result<()> {
    let mut seed = 12345u64;
    let mut below = |n: usize| {
        seed = seed.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (seed >> 33) as usize % n
    };
    let mut world = WorldDef::new().history(8).build()?;
    world.add_geom(&GeomDef::new(Shape::ground()))?;
    let (mut bodies, mut joints, mut geoms): (Vec<BodyId>, Vec<_>, Vec<GeomId>) = (Vec::new(), Vec::new(), Vec::new());
    let vertices = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    let mut rolled_back = 0;
    for _ in 0..3000 {
        match below(12) {
            0 | 1 => {
                let shape = match below(3) {
                    0 => Shape::cube(0.5),
                    1 => Shape::Sphere { radius: 0.3 },
                    _ => Shape::Mesh { vertices: &vertices, triangles: &[[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]] },
                };
                let at = [below(8) as Real, below(8) as Real, 1.0 + below(5) as Real];
                bodies.push(world.add_body(&BodyDef::new().position(at).shape(shape))?);
            }
            2 if bodies.len() > 1 => {
                let pair = (bodies[below(bodies.len())], bodies[below(bodies.len())]);
                joints.extend(world.add_joint(&JointDef::ball(pair.0, pair.1).feedback()));
            }
            3 => {
                let id = world.add_character(&CharacterSettings::default(), [below(8) as Real, 0.0, 0.0])?;
                let counted = Box::new(below(100)); // freed with the filter
                world.set_character_filter(id, move |_, _| *counted < 1000)?;
                geoms.push(id);
            }
            4 if !bodies.is_empty() => drop(world.remove_body(bodies[below(bodies.len())])),
            5 if !joints.is_empty() => drop(world.remove_joint(joints[below(joints.len())])),
            6 if !geoms.is_empty() => drop(world.remove_geom(geoms[below(geoms.len())])),
            7 => rolled_back += i32::from(world.roll_back(1 + below(8) as i32).is_ok()),
            8 if !geoms.is_empty() => {
                if let Ok(mut geom) = world.geom_mut(geoms[below(geoms.len())]) {
                    drop(geom.character_walk([1.0, 0.0, 0.0], 0.0, 0.01));
                }
            }
            9 if below(40) == 0 => world.set_history(8)?,
            10 if below(20) == 0 => {
                let copy = world.try_clone()?;
                assert_eq!(copy.state_hash()?, world.state_hash()?);
            }
            _ => drop(world.step(0.01)),
        }
        for joint in world.joints() {
            assert!(world.joint(joint)?.feedback().is_some());
        }
        for body in world.bodies() {
            assert!(!world.body(body)?.geoms().is_empty());
        }
        bodies.drain(..bodies.len().saturating_sub(60));
    }
    assert!(rolled_back > 50, "{rolled_back}");
    Ok(())
}
