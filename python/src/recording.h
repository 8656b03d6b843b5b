// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Recordings of worlds that Python steps: everything they hold is in memory, and is written when asked for.
#pragma once

#include "calls.h"
#include "record/file/recording.h"
#include "record/watch/recorder.h"

struct WorldRecording {
    WorldRecording() : recorder(recording) {}
    epode::record::Recording recording;
    epode::record::Recorder recorder;  // holds a reference to the recording
};

// From the eye towards the target, or from where all can be seen (none); what is up in the picture (none: z); the field of view
// from the lowest to the highest row, rad (0: a narrow one).
struct View {
    nb::object eye = nb::none(), target = nb::none(), up = nb::none();
    double field = 0;
};

// A state as pixels, three bytes each, rows from the top. Throws what went wrong.
nb::bytes picture_of(const epode::record::Recording& recording, size_t state, int width, int height,
                     const View& view);

void bind_recording(nb::module_& m);
void bind_picture(nb::module_& m);
