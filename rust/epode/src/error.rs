// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What the library says becomes an Error. Its handlers are process-wide, and it sends one message for each refused call on the
// thread that called; so the handlers write to a list of the thread, with the level of the call: calls nest (a callback calls the
// library), and each takes its own. A call that says nothing looks at two numbers of its thread and no more. What is said outside of
// the crate's calls goes where it went before.
use epode_sys as sys;
use std::cell::{Cell, RefCell};
use std::ffi::{c_char, c_int};
use std::fmt;
use std::io::Write;
use std::panic::{catch_unwind, AssertUnwindSafe};
use std::sync::{Mutex, Once, OnceLock};

/// What kind of mistake an [`Error`] is about.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum ErrorKind {
    /// The library refuses an argument, or the crate does so for it.
    Refused,
    /// The object has been removed.
    Removed,
    /// The object belongs to another world.
    OtherWorld,
    /// The library could not do it, as for want of memory.
    Failed,
}

/// A call that has changed nothing, and why. The text is the library's.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Error {
    kind: ErrorKind,
    text: String,
}

/// What fallible calls return.
pub type Result<T> = std::result::Result<T, Error>;

impl Error {
    pub(crate) fn new(kind: ErrorKind, text: impl Into<String>) -> Self {
        Self { kind, text: text.into() }
    }
    pub(crate) fn refused(text: impl Into<String>) -> Self {
        Self::new(ErrorKind::Refused, text)
    }
    /// What kind of mistake it is.
    pub fn kind(&self) -> ErrorKind {
        self.kind
    }
    /// The library's text.
    pub fn text(&self) -> &str {
        &self.text
    }
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.text)
    }
}
impl std::error::Error for Error {}

struct Said {
    level: u32,
    refused: bool,
    number: i32,
    text: String,
}

thread_local! {
    static LEVEL: Cell<u32> = const { Cell::new(0) }; // of the innermost call; 0: none
    static SPOKE: Cell<bool> = const { Cell::new(false) }; // the list has something
    static SAID: RefCell<Vec<Said>> = const { RefCell::new(Vec::new()) };
}

type Hook = Box<dyn Fn(i32, &str) + Send + Sync>;
static HOOK: Mutex<Option<std::sync::Arc<Hook>>> = Mutex::new(None);

/// Calls `hook` with the number and text of every message that is no refusal, such as the notes of a step, on the thread that
/// caused it; `None`, the default, prints them to the standard error stream. A panic of the hook goes no further: C may be around it.
pub fn on_message(hook: Option<Hook>) {
    *HOOK.lock().unwrap_or_else(std::sync::PoisonError::into_inner) = hook.map(std::sync::Arc::new);
}

fn report(number: i32, text: &str) {
    let hook = HOOK.lock().unwrap_or_else(std::sync::PoisonError::into_inner).clone();
    match hook {
        Some(hook) => {
            let _ = catch_unwind(AssertUnwindSafe(|| hook(number, text)));
        }
        None => drop(writeln!(std::io::stderr(), "Epode: {text}")), // which may be closed
    }
}

extern "C" {
    fn vsnprintf(to: *mut c_char, size: usize, format: *const c_char, arguments: sys::va_list) -> c_int;
}

// Handlers that a C part of the program had installed.
static BEFORE: OnceLock<(sys::dMessageFunction, sys::dMessageFunction)> = OnceLock::new();

unsafe extern "C" fn on_refusal(number: c_int, format: *const c_char, arguments: sys::va_list) {
    collect(true, number, format, arguments)
}
unsafe extern "C" fn on_note(number: c_int, format: *const c_char, arguments: sys::va_list) {
    collect(false, number, format, arguments)
}

unsafe fn collect(refused: bool, number: c_int, format: *const c_char, arguments: sys::va_list) {
    let level = LEVEL.get();
    let before = BEFORE.get().and_then(|(refusals, notes)| if refused { *refusals } else { *notes });
    if let (0, Some(handler)) = (level, before) {
        return handler(number, format, arguments);
    }
    let mut bytes = [0u8; 2000];
    vsnprintf(bytes.as_mut_ptr().cast(), bytes.len(), format, arguments);
    let end = bytes.iter().position(|&b| b == 0).unwrap_or(bytes.len());
    let text = String::from_utf8_lossy(&bytes[..end]).into_owned();
    // Functions of robots refuse by a message that begins with their name.
    let refused = refused || (text.starts_with("dRobot") && text.contains(": refused"));
    // A thread that is ending has no list any more: what is dropped there is reported at once.
    let kept = level > 0 && SAID.try_with(|said| said.borrow_mut().push(Said { level, refused, number, text: text.clone() })).is_ok();
    if kept {
        SPOKE.set(true);
    } else {
        report(number, &text);
    }
}

/// Opens the library and installs the handlers, once in a process.
pub(crate) fn start() {
    static ONCE: Once = Once::new();
    ONCE.call_once(|| unsafe {
        let _ = BEFORE.set((sys::dGetDebugHandler(), sys::dGetMessageHandler()));
        sys::dSetDebugHandler(Some(on_refusal));
        sys::dSetMessageHandler(Some(on_note));
        sys::dInitODE2(0);
        sys::dAllocateODEDataForThread(sys::dAllocateMaskAll as u32);
    });
}

/// A call into the library, which ends also when it is left by a panic.
struct Level(u32);

impl Level {
    fn begin() -> Self {
        let level = LEVEL.get() + 1;
        LEVEL.set(level);
        Self(level)
    }
    /// What was said in this call, and in none around it.
    #[cold]
    fn said(&self) -> Vec<Said> {
        let take = |said: &RefCell<Vec<Said>>| {
            let mut all = said.borrow_mut();
            let first = all.iter().position(|one| one.level >= self.0).unwrap_or(all.len());
            let own = all.split_off(first);
            SPOKE.set(!all.is_empty());
            own
        };
        SAID.try_with(take).unwrap_or_default()
    }
}
impl Drop for Level {
    fn drop(&mut self) {
        LEVEL.set(self.0 - 1);
        if SPOKE.get() {
            self.said();
        }
    }
}

/// Calls the library: what it refuses is an error. (Notes go to the hook.)
pub(crate) fn call<T>(f: impl FnOnce() -> T) -> Result<T> {
    let level = Level::begin();
    let result = f();
    if !SPOKE.get() {
        return Ok(result);
    }
    let said = level.said();
    drop(level);
    match refusal_of(said) {
        None => Ok(result),
        Some(text) => Err(Error::refused(text)),
    }
}

/// A call whose notes belong to its result: (the result, the texts of what was said).
#[cfg(feature = "robots")]
pub(crate) fn with_notes<T>(f: impl FnOnce() -> T) -> (T, Vec<String>) {
    let level = Level::begin();
    let result = f();
    let said = level.said();
    (result, said.into_iter().map(|one| one.text).collect())
}

#[cold]
fn refusal_of(said: Vec<Said>) -> Option<String> {
    let mut refusal = None;
    for one in said {
        if !one.refused {
            report(one.number, &one.text);
        } else if refusal.is_none() {
            refusal = Some(one.text);
        }
    }
    refusal
}

/// A call that nothing can make the library refuse.
pub(crate) fn sure<T>(f: impl FnOnce() -> T) -> T {
    call(f).unwrap_or_else(|error| panic!("a live object was refused: {error}"))
}

/// A call that returns 0 where it fails without a refusal.
pub(crate) fn done(f: impl FnOnce() -> c_int) -> Result<()> {
    match call(f)? {
        0 => Err(Error::new(ErrorKind::Failed, "the library could not do it: there is no memory left, or a file cannot be written")),
        _ => Ok(()),
    }
}

/// A pointer of the library's that is null where it fails without a refusal.
pub(crate) fn made<T>(f: impl FnOnce() -> *mut T) -> Result<*mut T> {
    let pointer = call(f)?;
    if pointer.is_null() {
        return Err(Error::new(ErrorKind::Failed, "the library could not make it: there is no memory left"));
    }
    Ok(pointer)
}
