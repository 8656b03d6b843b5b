// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What is drawn over the shapes: axes of bodies, joints with axes and limits, contacts with forces, boxes.
#pragma once

#include "view/drawing.h"
#include "view/lines.h"

namespace epode::view {

void draw_body_axes(const Stage& stage, const Moment& now, double size, Lines& lines);
void draw_joints(const Session& session, const Moment& now, const Switches& switches, double size,
                 Lines& lines);
void draw_contacts(const Stage& stage, const Moment& now, const Switches& switches, double size,
                   Lines& lines);
void draw_boxes(const Stage& stage, const Moment& now, Lines& lines);

// A length that goes well with the scene's bodies: half the mean size of what moves.
double fitting_size(const Stage& stage, const Moment& now);

}  // namespace epode::view
