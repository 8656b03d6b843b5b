// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Robots of files: kinematics by closed form, drives, and what may be removed.
#![cfg(feature = "robots")]
use epode::{BodyDef, ErrorKind, RobotJointKind, RobotModel, Shape, WorldDef};

const ARM: &str = r#"<?xml version="1.0"?>
<robot name="arm">
  <link name="base"/>
  <link name="upper"><inertial><origin xyz="0.5 0 0"/><mass value="2"/><inertia ixx="0.1" iyy="0.1" izz="0.1" ixy="0" ixz="0" iyz="0"/></inertial>
    <collision><origin xyz="0.5 0 0"/><geometry><box size="0.8 0.1 0.1"/></geometry></collision></link>
  <link name="lower"><inertial><origin xyz="0.5 0 0"/><mass value="1"/><inertia ixx="0.05" iyy="0.05" izz="0.05" ixy="0" ixz="0" iyz="0"/></inertial></link>
  <joint name="shoulder" type="continuous"><parent link="base"/><child link="upper"/><axis xyz="0 1 0"/></joint>
  <joint name="elbow" type="revolute"><parent link="upper"/><child link="lower"/><origin xyz="1 0 0"/><axis xyz="0 1 0"/>
    <limit lower="-2" upper="2" effort="100" velocity="10"/></joint>
</robot>"#;

fn arm() -> epode::Result<RobotModel> {
    // A base without mass is fixed to the world by a model that says so; here it is a frame above the ground.
    RobotModel::from_text(
        "arm.urdf",
        &ARM.replace("<link name=\"base\"/>", "<link name=\"world\"/>").replace("link=\"base\"", "link=\"world\""),
    )
}

#[test]
fn an_arm_has_the_dynamics_of_a_double_pendulum() -> epode::Result<()> {
    let model = arm()?;
    assert_eq!((model.num_positions(), model.num_velocities()), (2, 2));
    let joints = model.joints();
    assert_eq!((joints[0].name.as_str(), joints[0].kind), ("shoulder", RobotJointKind::Hinge));
    assert!((joints[1].limits[1] - 2.0).abs() < 1e-6);
    // Stretched out level: the torques that hold it against gravity are m1 g l/2 + m2 g 3l/2 and m2 g l/2.
    let hold = model.inverse_dynamics(&[0.0, 0.0], &[0.0, 0.0], &[0.0, 0.0])?;
    assert!((hold[0].abs() - 9.81 * (2.0 * 0.5 + 1.5)).abs() < 1e-3 && (hold[1].abs() - 9.81 * 0.5).abs() < 1e-3, "{hold:?}");
    // M11 = I1 + m1/4 + I2 + m2 (3/2)^2 there.
    let m = model.mass_matrix(&[0.0, 0.0])?;
    assert!((m[0] - (0.1 + 0.5 + 0.05 + 2.25)).abs() < 1e-4, "{m:?}");
    assert!(model.mass_matrix(&[0.0]).is_err() && model.inverse_dynamics(&[0.0; 2], &[0.0; 3], &[0.0; 2]).is_err());
    let lower = model.find_link("lower").unwrap();
    assert!((model.poses(&[0.0, 0.0])?[lower][0] - 1.0).abs() < 1e-6);
    assert_eq!(model.find_link("no such link"), None);
    Ok(())
}

#[test]
fn a_robot_is_one_object_of_its_world() -> epode::Result<()> {
    let model = arm()?;
    let mut world = WorldDef::new().history(5).build()?;
    let other = world.add_body(&BodyDef::new().position([9.0, 0.0, 9.0]).shape(Shape::cube(1.0)))?;
    world.set_history(5)?;
    world.step(0.001)?;
    let robot = world.add_robot(&model, [0.0, 0.0, 2.0], [1.0, 0.0, 0.0, 0.0])?;
    drop(model);
    world.robot_mut(robot)?.set_positions(&[0.3, 0.2])?;
    world.robot_mut(robot)?.set_target(0, 0.3, 500.0, 50.0)?;
    world.robot_mut(robot)?.set_target(1, 0.2, 500.0, 50.0)?;
    for _ in 0..2000 {
        world.robot_mut(robot)?.add_forces(0.001)?;
        world.step(0.001)?;
    }
    // The springs hold it, and give way by torque over stiffness.
    let q = world.robot(robot)?.positions()?;
    assert!((q[0] - 0.3).abs() < 0.06 && (q[1] - 0.2).abs() < 0.02, "{q:?}");
    let body = world.robot(robot)?.body(2)?.unwrap();
    assert!(world.remove_body(body).unwrap_err().text().contains("robot"));
    let elbow = world.robot(robot)?.joint(1)?.unwrap();
    assert!(world.remove_joint(elbow).is_err());
    for bad in [&[f64::NAN as epode::Real, 0.0] as &[epode::Real], &[0.0], &[0.0; 3]] {
        assert_eq!(world.robot_mut(robot)?.set_positions(bad).unwrap_err().kind(), ErrorKind::Refused);
    }
    assert!(world.robot(robot)?.body(99).is_err());
    let (bodies, joints) = (world.bodies().len(), world.joints().len());
    let second = world.add_robot(&arm()?, [0.0, 3.0, 2.0], [1.0, 0.0, 0.0, 0.0])?;
    world.step(0.001)?;
    world.roll_back(1)?;
    assert!(world.robot(second).is_err(), "it had not been made then");
    assert_eq!((world.bodies().len(), world.joints().len()), (bodies, joints));
    world.remove_robot(robot)?;
    assert!(world.robot(robot).is_err() && world.body(body).is_err());
    assert_eq!(world.bodies(), [other]);
    world.step(0.001)?;
    world.roll_back(1)?; // its bodies come back as bodies, without the robot
    assert!(world.body(body).is_ok() && world.robot(robot).is_err());
    world.remove_body(body)?;
    world.step(0.001)
}

#[test]
fn files_with_errors_are_refused() {
    for text in ["", "<robot/>", "<robot name='a'><joint name='j'/></robot>", "no file"] {
        assert!(RobotModel::from_text("a.urdf", text).is_err(), "{text}");
    }
    let missing = RobotModel::load("/no/such.urdf").err().unwrap();
    assert!(missing.text().contains("/no/such.urdf"), "{missing}");
    assert!(RobotModel::from_text("a\0b", ARM).is_err());
}
