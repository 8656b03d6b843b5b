// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Hostile numbers are refused with the library's text, and change nothing.
use epode::{
    BodyDef, Continuous, Defaults, ErrorKind, EventSettings, Filter, GeomDef, JointDef, JointKind, Mass, Material, Method, Param, Quat,
    Real, Result, Shape, Vec3, World,
};
use std::sync::{Arc, Mutex};

const HOSTILE: [Real; 5] = [Real::NAN, Real::INFINITY, Real::NEG_INFINITY, 1e30 as Real, -1e30 as Real];

fn refused<T>(result: Result<T>, what: &str) {
    match result {
        Err(error) => {
            assert_eq!(error.kind(), ErrorKind::Refused, "{what}: {error}");
            assert!(!error.text().is_empty());
        }
        Ok(_) => panic!("{what} was not refused"),
    }
}

#[test]
fn hostile_numbers_are_refused_and_change_nothing() -> Result<()> {
    let mut world = World::new()?;
    let body = world.add_body(&BodyDef::new().shape(Shape::cube(1.0)))?;
    let geom = world.body(body)?.geoms()[0];
    let hinge = world.add_joint(&JointDef::hinge(body, None).axis([0.0, 0.0, 1.0]))?;
    world.step(0.01)?;
    let before = (world.save_state()?, world.to_bytes()?);
    for bad in [Real::NAN, Real::INFINITY] {
        for i in 0..3 {
            let mut v: Vec3 = [1.0, 2.0, 3.0];
            v[i] = bad;
            refused(world.body_mut(body)?.set_position(v), "a position");
            refused(world.body_mut(body)?.set_linear_vel(v), "a velocity");
            refused(world.body_mut(body)?.add_force(v), "a force");
            refused(world.geom_mut(geom)?.set_offset_position(v), "an offset");
            refused(world.set_gravity(v), "gravity");
            refused(world.joint_mut(hinge)?.set_hinge_anchor(v), "an anchor");
            refused(world.add_body(&BodyDef::new().position(v)), "a new body's position");
            refused(world.add_body(&BodyDef::new().shape(Shape::Box { lengths: v })), "a new body's shape");
            refused(world.ray(v, [1.0, 0.0, 0.0], 1.0, &Filter::new()), "a ray");
            refused(world.cast(geom, v, &Filter::new()), "a motion");
        }
        refused(world.step(bad), "a step");
        refused(world.body_mut(body)?.set_mass(&Mass::diagonal(bad, [1.0; 3])), "a mass");
        refused(world.add_geom(&GeomDef::new(Shape::Sphere { radius: bad })), "a radius");
        refused(world.set_cfm(bad), "a CFM");
    }
    for bad in HOSTILE {
        refused(world.add_geom(&GeomDef::new(Shape::Hull { points: &[[bad; 3]; 4] })), "a hull");
    }
    for q in [[0.0; 4], [Real::NAN, 0.0, 0.0, 0.0]] as [Quat; 2] {
        refused(world.body_mut(body)?.set_quaternion(q), "a quaternion");
    }
    for h in [0.0, -0.01] {
        for method in [Method::Exact, Method::Quick, Method::Hybrid, Method::Substeps(3)] {
            refused(world.step_by(method, h), "a step size");
        }
    }
    refused(world.add_geom(&GeomDef::new(Shape::Sphere { radius: -1.0 })), "a negative radius");
    refused(world.body_mut(body)?.set_mass(&Mass::diagonal(-1.0, [1.0; 3])), "a negative mass");
    refused(world.body_mut(body)?.set_mass(&Mass::diagonal(1.0, [1.0, 1.0, -1.0])), "an inertia of no body");
    refused(world.joint_mut(hinge)?.set_hinge_axis([0.0; 3]), "no axis");
    refused(world.joint(hinge)?.slider_position(), "a slider's position of a hinge");
    refused(world.joint_mut(hinge)?.set_hinge_param(Param::HI_STOP, Real::NAN), "a stop");
    refused(world.add_joint(&JointDef::new(JointKind::Hinge, body, body)), "a joint of a body with itself");
    refused(world.add_joint(&JointDef::new(JointKind::Contact, body, None)), "a contact joint");
    refused(world.add_joint(&JointDef::fixed(body, None).axis([1.0, 0.0, 0.0])), "an axis of a fixed joint");
    refused(world.geom_mut(geom)?.set_material(Some(&Material { friction: -1.0, ..Material::default() })), "negative friction");
    refused(world.set_event_settings(Some(&EventSettings { capacity: 0, ..EventSettings::default() })), "no events");
    refused(world.set_history(-1), "a history");
    refused(world.roll_back(1), "a roll-back without a history");
    refused(world.joint(hinge)?.axis_position(5), "a joint's axis");
    assert_eq!((world.save_state()?, world.to_bytes()?), before, "something has changed");
    assert_eq!((world.bodies().len(), world.geoms().len(), world.joints().len()), (1, 1, 1));
    Ok(())
}

#[test]
fn arrays_of_the_wrong_length_are_refused() -> Result<()> {
    let mut world = World::new()?;
    let flat = [0.0; 9];
    let field = |columns, rows| Shape::Heights { heights: &flat, columns, rows, width: 1.0, depth: 1.0 };
    refused(world.add_geom(&GeomDef::new(field(3, 4))), "too few heights");
    refused(world.add_geom(&GeomDef::new(field(usize::MAX, 2))), "too many samples");
    world.add_geom(&GeomDef::new(field(3, 3)))?;
    let vertices = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
    let mesh = |triangles| Shape::Mesh { vertices: &vertices, triangles };
    refused(world.add_geom(&GeomDef::new(mesh(&[[0, 1, 3]]))), "an index beyond the vertices");
    refused(world.add_geom(&GeomDef::new(mesh(&[[0, 1, u32::MAX]]))), "an index far beyond the vertices");
    world.add_geom(&GeomDef::new(mesh(&[[0, 1, 2]])))?;
    let body = world.add_body(&BodyDef::new())?;
    let fields = epode::Fields::POSITION | epode::Fields::LINEAR_VEL;
    refused(world.body_states(&[body], fields, &mut [0.0; 5]), "too short a row");
    refused(world.set_body_states(&[body, body], fields, &[0.0; 6]), "a row too few");
    refused(world.ray_batch(&[[0.0; 3]], &[], &[1.0], &Filter::new(), 1), "a ray without a direction");
    Ok(())
}

#[test]
fn what_is_refused_says_why_in_the_librarys_words() -> Result<()> {
    let mut world = World::new()?;
    let body = world.add_body(&BodyDef::new())?;
    let error = world.body_mut(body)?.set_position([Real::NAN, 0.0, 0.0]).unwrap_err();
    assert!(error.text().contains("dBodySetPosition"), "{error}");
    let plane = world.add_geom(&GeomDef::new(Shape::ground()))?;
    assert!(world.geom(plane)?.position().unwrap_err().text().contains("dGeomGetPosition"));
    assert!(world.geom_mut(plane)?.set_continuous(Continuous::On).is_err());
    assert!(World::from_bytes(b"no world").is_err());
    assert!(World::load("/no/such/file").unwrap_err().text().contains("/no/such/file"));
    Ok(())
}

#[test]
fn defaults_are_those_of_the_library() -> Result<()> {
    assert!((Material::default().friction - 0.6).abs() < 1e-6);
    assert_eq!(EventSettings::default().capacity, 1024);
    let mut world = World::new()?;
    world.use_defaults(Defaults::Game)?;
    assert_eq!(world.method(), Method::Hybrid);
    assert!(world.auto_disable_flag());
    assert_eq!(world.step_report(), None);
    world.set_step_report_mode(true)?;
    world.add_body(&BodyDef::new())?;
    world.step(0.01)?;
    assert_eq!(world.step_report().map(|report| report.bodies), Some(1));
    Ok(())
}

#[test]
fn notes_go_to_the_hook_whose_panics_go_no_further() -> Result<()> {
    let mut world = World::new()?;
    let notes = Arc::new(Mutex::new(Vec::new()));
    let kept = notes.clone();
    epode::on_message(Some(Box::new(move |number, text| {
        kept.lock().unwrap().push((std::thread::current().id(), number, text.to_string()));
        panic!("in the hook");
    })));
    // The mass that no body can have is a note; that a body must not have it is a refusal.
    refused(world.add_body(&BodyDef::new().shape(Shape::cube(1.0)).density(-5.0)), "a negative density");
    epode::on_message(None);
    let here = std::thread::current().id();
    let own: Vec<_> = notes.lock().unwrap().iter().filter(|note| note.0 == here).cloned().collect();
    assert!(own.iter().any(|note| note.2.contains("mass")), "{own:?}");
    assert!(world.bodies().is_empty() && world.geoms().is_empty());
    world.step(0.01)
}
