// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The names of Gazebo's libraries, of which there are two sets. Version 6 of gz-physics renamed namespaces, folders and macros from
// ignition to gz. The other files write the new names; this one provides them where only the old ones are installed, and includes all
// headers of Gazebo.
#pragma once

#if __has_include(<gz/physics/Feature.hh>)
#define GZ_HEADER(path) <gz/path>
#else
#define GZ_HEADER(path) <ignition/path>
namespace ignition {}
namespace gz = ignition;
#endif

// clang-format would put spaces into the paths.
// clang-format off
#include GZ_HEADER(common/Console.hh)
#include GZ_HEADER(common/HeightmapData.hh)
#include GZ_HEADER(common/ImageHeightmap.hh)
#include GZ_HEADER(common/Mesh.hh)
#include GZ_HEADER(common/MeshManager.hh)
#include GZ_HEADER(common/SubMesh.hh)
#include GZ_HEADER(common/Util.hh)
#include GZ_HEADER(math/Pose3.hh)
#include GZ_HEADER(physics/BoxShape.hh)
#include GZ_HEADER(physics/CapsuleShape.hh)
#include GZ_HEADER(physics/ConstructEmpty.hh)
#include GZ_HEADER(physics/ContactProperties.hh)
#include GZ_HEADER(physics/CylinderShape.hh)
#include GZ_HEADER(physics/EllipsoidShape.hh)
#include GZ_HEADER(physics/FixedJoint.hh)
#include GZ_HEADER(physics/ForwardStep.hh)
#include GZ_HEADER(physics/FrameSemantics.hh)
#include GZ_HEADER(physics/FreeGroup.hh)
#include GZ_HEADER(physics/Geometry.hh)
#include GZ_HEADER(physics/GetBoundingBox.hh)
#include GZ_HEADER(physics/GetContacts.hh)
#include GZ_HEADER(physics/GetEntities.hh)
#include GZ_HEADER(physics/Implements.hh)
#include GZ_HEADER(physics/Joint.hh)
#include GZ_HEADER(physics/Link.hh)
#include GZ_HEADER(physics/PlaneShape.hh)
#include GZ_HEADER(physics/PrismaticJoint.hh)
#include GZ_HEADER(physics/RemoveEntities.hh)
#include GZ_HEADER(physics/RevoluteJoint.hh)
#include GZ_HEADER(physics/Shape.hh)
#include GZ_HEADER(physics/SphereShape.hh)
#include GZ_HEADER(physics/World.hh)
#include GZ_HEADER(physics/heightmap/HeightmapShape.hh)
#include GZ_HEADER(physics/mesh/MeshShape.hh)
#include GZ_HEADER(physics/sdf/ConstructCollision.hh)
#include GZ_HEADER(physics/sdf/ConstructJoint.hh)
#include GZ_HEADER(physics/sdf/ConstructLink.hh)
#include GZ_HEADER(physics/sdf/ConstructModel.hh)
#include GZ_HEADER(physics/sdf/ConstructNestedModel.hh)
#include GZ_HEADER(physics/sdf/ConstructWorld.hh)
// clang-format on

#if !__has_include(<gz/physics/Feature.hh>)
#define GZ_PHYSICS_ADD_PLUGIN(...) IGN_PHYSICS_ADD_PLUGIN(__VA_ARGS__)
#endif

// Console messages, as all of Gazebo's parts print them.
#ifdef ignerr
#define EPODE_GAZEBO_ERROR ignerr << "[epode] "
#define EPODE_GAZEBO_WARNING ignwarn << "[epode] "
#else
#define EPODE_GAZEBO_ERROR gzerr << "[epode] "
#define EPODE_GAZEBO_WARNING gzwarn << "[epode] "
#endif
