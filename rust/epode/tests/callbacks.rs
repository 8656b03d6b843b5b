// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Functions of the program: what they receive, and that a panic in one of them goes on when the call is over.
use epode::{BodyDef, CharacterSettings, EventKind, EventSettings, Filter, GeomDef, GeomId, Real, Result, Shape, World, WorldDef};
use std::panic::{catch_unwind, AssertUnwindSafe};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Arc, Mutex};

fn ball_over_ground(world: &mut World) -> Result<(epode::BodyId, GeomId)> {
    let ground = world.add_geom(&GeomDef::new(Shape::ground()).tag(1))?;
    let ball = GeomDef::new(Shape::Sphere { radius: 0.5 }).tag(2);
    let body = world.add_body(&BodyDef::new().position([0.0, 0.0, 0.5]).geom(ball).tag(20))?;
    Ok((body, ground))
}

fn text(payload: Box<dyn std::any::Any + Send>) -> String {
    payload.downcast_ref::<&str>().map_or_else(|| "another".into(), |s| (*s).to_string())
}

#[test]
fn a_contact_filter_decides() -> Result<()> {
    let mut world = World::new()?;
    let (ball, ground) = ball_over_ground(&mut world)?;
    let seen = Arc::new(Mutex::new(Vec::new()));
    let kept = seen.clone();
    world.set_contact_filter(move |one, two| {
        kept.lock().unwrap().push((one, two));
        false
    })?;
    (0..20).try_for_each(|_| world.step(0.01))?;
    assert!(world.body(ball)?.position()[2] < 0.4, "it falls through");
    let (one, two) = seen.lock().unwrap()[0];
    assert_eq!([one.tag + two.tag, u64::from(one.geom == ground || two.geom == ground)], [3, 1]);
    assert!([one.body, two.body].contains(&Some(ball)));
    world.remove_contact_filter()?;
    assert_eq!(Arc::strong_count(&seen), 1, "the filter is gone");
    Ok(())
}

#[test]
fn panics_of_a_contact_filter_go_on_after_the_step() -> Result<()> {
    let mut world = World::new()?;
    let (ball, _) = ball_over_ground(&mut world)?;
    world.set_contact_filter(|_, _| panic!("no contact today"))?;
    let caught = catch_unwind(AssertUnwindSafe(|| world.step(0.01)));
    assert_eq!(text(caught.unwrap_err()), "no contact today");
    // The step was made: gravity, and the contact that a filter allows which does not answer.
    assert!(world.body(ball)?.linear_vel()[2].abs() < 0.05);
    world.remove_contact_filter()?;
    world.step(0.01)?;
    Ok(())
}

#[test]
fn moved_bodies_are_reported_and_panics_go_on() -> Result<()> {
    let mut world = World::new()?;
    let (ball, _) = ball_over_ground(&mut world)?;
    let other = world.add_body(&BodyDef::new().position([9.0, 0.0, 9.0]))?;
    world.body_mut(ball)?.report_moves(true)?;
    let moves = Arc::new(AtomicUsize::new(0));
    let counted = moves.clone();
    world.on_moved(move |moved| {
        assert_eq!((moved.body, moved.tag), (ball, 20));
        assert!((moved.position[2] - 0.5).abs() < 0.1);
        counted.fetch_add(1, Ordering::Relaxed);
    });
    (0..5).try_for_each(|_| world.step(0.01))?;
    assert_eq!(moves.load(Ordering::Relaxed), 5);
    world.body_mut(other)?.report_moves(true)?;
    let caught = catch_unwind(AssertUnwindSafe(|| world.step(0.01)));
    assert!(caught.is_err(), "the assertion about the other body");
    world.on_moved(|_| {});
    world.step(0.01)?;
    Ok(())
}

#[test]
fn a_query_within_a_querys_filter_reads_the_world() -> Result<()> {
    let mut world = World::new()?;
    let (ball, ground) = ball_over_ground(&mut world)?;
    let down: [Real; 3] = [0.0, 0.0, -1.0];
    let mut others = Vec::new();
    let mut inner = |geom: GeomId| {
        let hit = world.ray([5.0, 0.0, 2.0], down, 10.0, &Filter::new()).unwrap();
        others.push((geom, hit.unwrap().geom, world.body(ball).unwrap().tag()));
        geom == ground
    };
    let hit = world.ray([0.0, 0.0, 5.0], down, 10.0, &Filter::new().keep(&mut inner))?.unwrap();
    assert_eq!(hit.geom, ground);
    assert!(others.iter().all(|&(_, hit, tag)| hit == ground && tag == 20) && !others.is_empty());
    Ok(())
}

#[test]
fn a_panic_in_a_querys_filter_goes_on_after_the_query() -> Result<()> {
    let mut world = World::new()?;
    ball_over_ground(&mut world)?;
    let mut refuse = |_: GeomId| -> bool { panic!("no ray today") };
    let filter = Filter::new().keep(&mut refuse);
    let caught = catch_unwind(AssertUnwindSafe(|| world.ray_all([0.0, 0.0, 5.0], [0.0, 0.0, -1.0], 10.0, &filter)));
    assert_eq!(text(caught.unwrap_err()), "no ray today");
    assert_eq!(world.ray_all([0.0, 0.0, 5.0], [0.0, 0.0, -1.0], 10.0, &Filter::new())?.len(), 2);
    world.step(0.01)?;
    Ok(())
}

#[test]
fn a_world_is_stepped_within_the_callback_of_another() -> Result<()> {
    let mut inner = World::new()?;
    let falling = inner.add_body(&BodyDef::new())?;
    let mut outer = World::new()?;
    ball_over_ground(&mut outer)?;
    let results = Arc::new(Mutex::new(Vec::new()));
    let kept = results.clone();
    outer.set_contact_filter(move |_, _| {
        let refused = inner.step(-1.0).is_err();
        inner.step(0.01).unwrap();
        kept.lock().unwrap().push((refused, inner.body(falling).unwrap().linear_vel()[2]));
        true
    })?;
    outer.step(0.01)?;
    assert!(outer.step(-1.0).is_err(), "the refusals of one world are not those of another");
    let results = results.lock().unwrap();
    assert!(results.iter().all(|&(refused, v)| refused && v < 0.0) && !results.is_empty());
    Ok(())
}

#[test]
fn characters_walk_and_their_filter_decides() -> Result<()> {
    let mut world = World::new()?;
    let ground = world.add_geom(&GeomDef::new(Shape::ground()))?;
    let wall = world.add_geom(&GeomDef::new(Shape::Box { lengths: [0.2, 4.0, 4.0] }).position([1.0, 0.0, 2.0]))?;
    let walker = world.add_character(&CharacterSettings::default(), [0.0, 0.0, 0.0])?;
    let walk = |world: &mut World, steps: usize| -> Result<Real> {
        for _ in 0..steps {
            world.geom_mut(walker)?.character_walk([1.0, 0.0, 0.0], 0.0, 0.02)?;
            world.step(0.02)?;
        }
        Ok(world.geom(walker)?.character_position()?[0])
    };
    let before_wall = walk(&mut world, 100)?;
    assert!(before_wall < 0.7, "{before_wall}");
    let report = world.geom(walker)?.character_report()?;
    assert_eq!((report.ground, report.hit_wall), (Some(ground), true));
    world.set_character_filter(walker, move |other, velocity| {
        assert!(velocity[0] > 0.0);
        other != wall
    })?;
    assert!(walk(&mut world, 50)? > before_wall + 0.5, "the filter lets it through the wall");
    world.set_character_filter(walker, |_, _| panic!("no walk today"))?;
    let caught = catch_unwind(AssertUnwindSafe(|| walk(&mut world, 1)));
    assert_eq!(text(caught.unwrap_err()), "no walk today");
    world.remove_geom(walker)?;
    Ok(())
}

#[test]
fn events_name_what_was_removed() -> Result<()> {
    let mut world = WorldDef::new().events(EventSettings::default()).build()?;
    let (ball, ground) = ball_over_ground(&mut world)?;
    let geom = world.body(ball)?.geoms()[0];
    world.step(0.01)?;
    let begin = world.events();
    assert_eq!((begin[0].kind, begin[0].geom1, begin[0].geom2), (EventKind::ContactBegin, Some(geom), Some(ground)));
    world.remove_body(ball)?;
    assert_eq!(world.events()[0].geom1, Some(geom), "removed since the step, named all the same");
    world.step(0.01)?;
    let end = world.events();
    assert_eq!(end[0].kind, EventKind::ContactEnd);
    Ok(())
}
