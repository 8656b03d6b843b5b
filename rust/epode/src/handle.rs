// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Handles: number of the world, place in its table, generation of the place. Weighed against views that borrow the world (they
// cannot be stored next to it, which is what games do) and reference counts (not Send, or locked on every call; a removed body would
// need a state "removed" in any case). The library recognises dead handles itself, but only to the 63rd object in the same place;
// generations are 32 bits, and a place whose generations are used up is never used again.
use crate::World;

macro_rules! handle {
    ($name:ident, $what:literal) => {
        #[doc = concat!("Names a ", $what, " of a [`World`]. It is a number: copy it, keep it, send it; it names nothing else, ever.")]
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
        pub struct $name {
            pub(crate) world: u32,
            pub(crate) index: u32,
            pub(crate) generation: u32,
        }

        impl $name {
            #[doc = concat!("The counterpart of this ", $what, " in a copy of its world ([`World::try_clone`]); itself, for other worlds.")]
            pub fn in_world(self, copy: &World) -> Self {
                let shared = copy.shared();
                if shared.copied_from.get() == Some(self.world) {
                    return Self { world: shared.id, ..self };
                }
                self
            }
        }
    };
}

handle!(BodyId, "body");
handle!(JointId, "joint");
handle!(GeomId, "geom");
