//! The table of simple schemas, those of one action beside each other.
//!
//! What is known of one action is a slice: testing, predicting and competing cost what that action
//! has, not what the table has.

use crate::growth::{Entry, Evidence, SimpleSchema};
use crate::snapshot::stored;
use crate::word::{ActionId, ItemSet, SchemaText, SignedItems};

/// Up to `SCHEMAS` schemas of `ACTIONS` actions.
#[derive(Clone, Debug)]
pub(super) struct Table<const SCHEMAS: usize, const ACTIONS: usize> {
    schemas: heapless::Vec<SimpleSchema, SCHEMAS, u16>,
    /// Where the schemas of each action end; they begin where those of the action before it end.
    ends: [u16; ACTIONS],
    evicted: u32,
    refused: u32,
}

impl<const SCHEMAS: usize, const ACTIONS: usize> Table<SCHEMAS, ACTIONS> {
    pub(super) const fn new() -> Self {
        const {
            assert!(
                SCHEMAS > 0 && SCHEMAS < u16::MAX as usize,
                "1 to 65,534 schemas"
            );
        }
        Self {
            schemas: heapless::Vec::new(),
            ends: [0; ACTIONS],
            evicted: 0,
            refused: 0,
        }
    }

    pub(super) fn clear(&mut self) {
        self.schemas.clear();
        self.ends = [0; ACTIONS];
        (self.evicted, self.refused) = (0, 0);
    }

    pub(super) fn all(&self) -> &[SimpleSchema] {
        &self.schemas
    }

    /// Schemas that made room for others, and schemas that found none.
    pub(super) const fn losses(&self) -> (u32, u32) {
        (self.evicted, self.refused)
    }

    fn range(&self, action: u8) -> (usize, usize) {
        let action = usize::from(action);
        let end = |at: usize| usize::from(self.ends.get(at).copied().unwrap_or(0));
        let start = if action == 0 { 0 } else { end(action - 1) };
        (start, end(action))
    }

    /// The schemas of an action.
    pub(super) fn of(&self, action: u8) -> &[SimpleSchema] {
        let (start, end) = self.range(action);
        self.schemas.get(start..end).unwrap_or(&[])
    }

    fn copy(&mut self, from: usize, to: usize) {
        if let Some(&schema) = self.schemas.get(from)
            && let Some(place) = self.schemas.get_mut(to)
        {
            *place = schema;
        }
    }

    /// Gives the schema a place behind those of its action; false when there is none.
    fn insert(&mut self, schema: SimpleSchema) -> bool {
        let action = usize::from(schema.action().0);
        let mut hole = self.schemas.len();
        if action >= ACTIONS || self.schemas.push(schema).is_err() {
            return false;
        }
        // Each later action gives its first place to the one before it and gets one behind its last.
        for other in (action + 1..ACTIONS).rev() {
            let (start, _) = self.range(other as u8);
            self.copy(start, hole);
            hole = start;
        }
        if let Some(place) = self.schemas.get_mut(hole) {
            *place = schema;
        }
        for end in self.ends.iter_mut().skip(action) {
            *end = end.saturating_add(1);
        }
        true
    }

    fn remove(&mut self, action: u8, at: usize) {
        let mut hole = at;
        for other in action..ACTIONS as u8 {
            let (_, end) = self.range(other);
            if let Some(last) = end.checked_sub(1) {
                self.copy(last, hole);
                hole = last;
            }
        }
        for end in self.ends.iter_mut().skip(usize::from(action)) {
            *end = end.saturating_sub(1);
        }
        let _ = self.schemas.pop();
    }

    /// Takes out the schemas of an action that are not wanted any more.
    fn retain(&mut self, action: u8, mut wanted: impl FnMut(&mut SimpleSchema) -> bool) {
        let (mut at, mut end) = self.range(action);
        while at < end {
            let Some(schema) = self.schemas.get_mut(at) else {
                return;
            };
            if wanted(schema) {
                at += 1;
            } else {
                self.remove(action, at);
                end -= 1;
            }
        }
    }

    /// Gives a schema a place unless one that is as general has it; those that say less leave.
    ///
    /// A full table gives up the schema that has been idle longest, of equally idle ones the one with
    /// the fewest successes.
    pub(super) fn enter(&mut self, new: SimpleSchema) -> Entry {
        let action = new.action().0 as u8;
        if self.of(action).iter().any(|old| old.covers(&new)) {
            return Entry::Covered;
        }
        self.retain(action, |old| !new.covers(old));
        if self.insert(new) {
            return Entry::Stored;
        }
        let uselessness = |it: &(usize, &SimpleSchema)| (u8::MAX - it.1.idle(), it.1.successes());
        let victim = self.schemas.iter().enumerate().min_by_key(uselessness);
        match victim.map(|(at, old)| (at, *old)) {
            Some((at, old)) if old.idle() > 0 || old.successes() <= new.successes() => {
                self.remove(old.action().0 as u8, at);
                self.evicted = self.evicted.saturating_add(1);
                if self.insert(new) {
                    Entry::Stored
                } else {
                    Entry::Refused
                }
            }
            _ => {
                self.refused = self.refused.saturating_add(1);
                Entry::Refused
            }
        }
    }

    /// Lets every schema of an action that applied see what came of it, and drops those that `keep`
    /// does not want any more; a schema whose result nobody knows has no trial.
    ///
    /// Of the schemas that foresaw the same change the one with the most successes explains it; the
    /// others were idle.
    pub(super) fn record<const WORDS: usize, E: Evidence<WORDS>>(
        &mut self,
        action: ActionId,
        sample: &E,
        mut keep: impl FnMut(&SimpleSchema, bool) -> bool,
    ) {
        let (on, off, telling) = (sample.on_before(), sample.off_before(), sample.telling());
        let action = action.0 as u8;
        // Successes of the best explanation of each item.
        let mut best = [[0_u16; 32]; WORDS];
        self.retain(action, |schema| {
            if !schema.holds_in(&on, &off) {
                return true;
            }
            let Some(success) = schema.success(sample) else {
                return true;
            };
            schema.record(success);
            if success && let Some(most) = slot(&mut best, schema) {
                *most = schema.successes().max(*most);
            }
            keep(schema, success)
        });
        let (start, end) = self.range(action);
        for schema in self.schemas.get_mut(start..end).unwrap_or(&mut []) {
            if !telling.contains(schema.result_item())
                || !schema.holds_in(&on, &off)
                || schema.success(sample) != Some(true)
            {
                continue;
            }
            let Some(most) = slot(&mut best, schema) else {
                continue;
            };
            let explains = schema.successes() == *most;
            schema.was_idle(!explains);
            if explains {
                // Of equally successful ones the first explains.
                *most = u16::MAX;
            }
        }
    }

    /// The changes of a sample that a schema foresees; what nobody knows is not foreseen.
    pub(super) fn foreseen<const WORDS: usize, E: Evidence<WORDS>>(
        &self,
        action: u8,
        sample: &E,
    ) -> ItemSet<WORDS> {
        let (on, off, telling) = (sample.on_before(), sample.off_before(), sample.telling());
        let mut foreseen = ItemSet::EMPTY;
        for schema in self.of(action) {
            let item = schema.result_item();
            if telling.contains(item)
                && schema.success(sample) == Some(true)
                && schema.holds_in(&on, &off)
            {
                let _ = foreseen.insert(item);
            }
        }
        foreseen
    }

    /// What is expected to be on after an action, of what is on now: of two schemas that contradict
    /// each other the one with more successes is believed; what no schema speaks of stays.
    pub(super) fn predict<const WORDS: usize>(
        &self,
        on: &ItemSet<WORDS>,
        action: u8,
    ) -> ItemSet<WORDS> {
        let mut stay = [[0_u16; 32]; WORDS];
        let mut change = [[0_u16; 32]; WORDS];
        let mut changing = ItemSet::<WORDS>::EMPTY;
        for schema in self.of(action) {
            if !schema.applies(on) {
                continue;
            }
            let stays = schema.succeeds(on);
            let votes = if stays { &mut stay } else { &mut change };
            if let Some(most) = slot(votes, schema) {
                *most = schema.successes().saturating_add(1).max(*most);
            }
            if !stays {
                let _ = changing.insert(schema.result_item());
            }
        }
        let mut after = *on;
        for item in changing.iter() {
            let at = usize::from(item.0);
            let votes = |side: &[[u16; 32]; WORDS]| side.as_flattened().get(at).copied();
            if votes(&change) > votes(&stay) {
                if on.contains(item) {
                    after.remove(item);
                } else {
                    let _ = after.insert(item);
                }
            }
        }
        after
    }

    /// The schemas that foresee what changes between two states, as one: of each change the one with
    /// the most successes.
    pub(super) fn reason<const WORDS: usize>(
        &self,
        on: &ItemSet<WORDS>,
        after: &ItemSet<WORDS>,
        action: ActionId,
    ) -> SchemaText<WORDS> {
        let mut why = SchemaText {
            context: SignedItems::EMPTY,
            action,
            result: SignedItems::EMPTY,
        };
        for item in on.symmetric_difference(after).iter() {
            let sign = after.contains(item);
            let foresees = |it: &&SimpleSchema| {
                it.result_item() == item && it.result_sign() == sign && it.applies(on)
            };
            let of = u8::try_from(action.0).map_or(&[][..], |action| self.of(action));
            let best = of.iter().filter(foresees).max_by_key(|it| it.successes());
            if let Some(schema) = best {
                for (named, sign) in schema.context() {
                    let _ = why.context.insert(named, sign);
                }
                let _ = why.result.insert(item, sign);
            }
        }
        why
    }
}

fn slot<'a, const WORDS: usize>(
    of: &'a mut [[u16; 32]; WORDS],
    schema: &SimpleSchema,
) -> Option<&'a mut u16> {
    of.as_flattened_mut()
        .get_mut(usize::from(schema.result_item().0))
}

impl<const SCHEMAS: usize, const ACTIONS: usize> Table<SCHEMAS, ACTIONS> {
    /// Drops schemas that cannot be so and lays those of one action beside each other; answers how
    /// many were dropped, and whether anything was out of its place.
    pub(super) fn audit(&mut self) -> (u32, bool) {
        let before = self.schemas.len();
        self.schemas.retain(|it| it.can_be(ACTIONS as u16));
        let dropped = (before - self.schemas.len()) as u32;
        let ends = self.ends;
        let mut next = 0;
        let mut moved = false;
        for (action, end) in self.ends.iter_mut().enumerate() {
            let mut at = next;
            while let Some(schema) = self.schemas.get(at) {
                if usize::from(schema.action().0) == action {
                    moved |= at != next;
                    self.schemas.swap(at, next);
                    next += 1;
                }
                at += 1;
            }
            *end = next as u16;
        }
        (dropped, moved || self.ends != ends)
    }
}

stored! {
    impl[const SCHEMAS: usize, const ACTIONS: usize] Table<SCHEMAS, ACTIONS> {
        schemas, ends if |it: &[u16; ACTIONS]| it.is_sorted(), evicted, refused
    }
}

#[cfg(test)]
#[path = "table_tests.rs"]
mod tests;
