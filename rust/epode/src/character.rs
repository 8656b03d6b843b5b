// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Characters: geoms that walk. Their filter belongs to their place in the world's table, which lives as long as the geom.
use crate::callbacks::{character_filter, CharacterFilter};
use crate::error::{done, made};
use crate::owned::Owned;
use crate::prelude::*;
use std::cell::RefCell;

impl World {
    /// Adds a character with its feet at `position`, m. Move it by [`GeomMut::character_walk`] after each step.
    /// C: `dCharacterCreate`.
    pub fn add_character(&mut self, settings: &CharacterSettings, position: Vec3) -> Result<GeomId> {
        let raw = settings.to_raw();
        let geom = made(|| unsafe { sys::dCharacterCreate(self.space(), &raw) })?;
        let id = self.register_geom(geom, None);
        if let Err(error) = self.geom_mut(id)?.set_character_position(position) {
            self.remove_geom(id)?;
            return Err(error);
        }
        Ok(id)
    }

    /// Lets `decide` say what a character collides with, of each other geom and the velocity that the move was asked for: not if it
    /// returns false.
    pub fn set_character_filter(&mut self, id: GeomId, decide: impl FnMut(GeomId, Vec3) -> bool + Send + 'static) -> Result<()> {
        let geom = self.shared().geom(id)?;
        let filter = Owned::new(CharacterFilter { shared: self.shared_pointer(), decide: RefCell::new(Box::new(decide)) });
        let mut raw = CharacterSettings::empty();
        done(|| unsafe { sys::dCharacterGetSettings(geom, &mut raw) })?;
        raw.filter = Some(character_filter);
        raw.data = filter.pointer().cast();
        done(|| unsafe { sys::dCharacterSetSettings(geom, &raw) })?;
        self.shared().geoms.borrow_mut().data_mut(id.index).filter = Some(filter);
        Ok(())
    }
}

impl Geom<'_> {
    /// The settings of a character. C: `dCharacterGetSettings`.
    pub fn character_settings(&self) -> Result<CharacterSettings> {
        let mut raw = CharacterSettings::empty();
        done(|| unsafe { sys::dCharacterGetSettings(self.raw(), &mut raw) })?;
        Ok(CharacterSettings::from_raw(&raw, self.shared()))
    }
}

impl GeomMut<'_> {
    /// Other settings of a character, whose shape, radius, height and up stay. Its filter stays. C: `dCharacterSetSettings`.
    pub fn set_character_settings(&mut self, settings: &CharacterSettings) -> Result<()> {
        let mut now = CharacterSettings::empty();
        done(|| unsafe { sys::dCharacterGetSettings(self.raw(), &mut now) })?;
        let raw = sys::dCharacterSettings { filter: now.filter, data: now.data, ..settings.to_raw() };
        done(|| unsafe { sys::dCharacterSetSettings(self.raw(), &raw) })
    }
}
