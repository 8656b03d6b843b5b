// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Sizes, alignments and offsets of all structures, and all numbers, as a C compiler has them from the headers: a program of C
// prints a line for each, this one makes the same lines. The macros with all names are in names/mod.rs.
use epode_sys::*;
use std::fmt::Write;
use std::mem::{align_of, offset_of, size_of};
use std::path::PathBuf;
use std::process::Command;

#[rustfmt::skip]
mod names;

const ROBOTS: bool = cfg!(feature = "robots");

fn c_prints(source: &str) -> String {
    let root = PathBuf::from(env!("CARGO_MANIFEST_DIR"));
    let include = std::env::var_os("EPODE_INCLUDE_DIR").map_or(root.join("../../include"), PathBuf::from);
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR"));
    let name = format!("layout_{}_{}", std::process::id(), source.len());
    let (c, program) = (folder.join(format!("{name}.c")), folder.join(name));
    let precision = if cfg!(feature = "single") { "-DdIDESINGLE" } else { "-DdIDEDOUBLE" };
    std::fs::write(&c, source).unwrap();
    // Of the library only the layouts are wanted: nothing is linked.
    let built = Command::new(std::env::var("CC").unwrap_or_else(|_| "cc".into()))
        .args(["-w", precision, "-I"])
        .arg(include)
        .arg("-DODE_API=")
        .arg(&c)
        .arg("-o")
        .arg(&program)
        .arg("-Wl,--unresolved-symbols=ignore-all")
        .status()
        .expect("a C compiler is needed");
    assert!(built.success());
    let out = Command::new(&program).output().unwrap();
    assert!(out.status.success());
    String::from_utf8(out.stdout).unwrap()
}

macro_rules! lines_of_structures {
    ($($name:ident { $($field:ident)* })*) => {
        fn lines(c: &mut String, rust: &mut String) {
            $(
                let it = stringify!($name);
                writeln!(c, "printf(\"{it} %zu %zu\\n\", sizeof({it}), _Alignof({it}));").unwrap();
                writeln!(rust, "{it} {} {}", size_of::<$name>(), align_of::<$name>()).unwrap();
                $(
                    let field = stringify!($field).trim_start_matches("r#");
                    writeln!(c, "printf(\"{it}.{field} %zu\\n\", offsetof({it}, {field}));").unwrap();
                    writeln!(rust, "{it}.{field} {}", offset_of!($name, $field)).unwrap();
                )*
            )*
        }
    };
}
macro_rules! lines_of_numbers {
    ($($name:ident)*) => {
        fn lines(c: &mut String, rust: &mut String) {
            $(
                writeln!(c, "printf(\"{0} %lld\\n\", (long long)({0}));", stringify!($name)).unwrap();
                writeln!(rust, "{} {}", stringify!($name), i64::from($name)).unwrap();
            )*
        }
    };
}

fn compare(lines: &[fn(&mut String, &mut String)], least: usize) {
    let headers: String = names::HEADERS.iter().map(|name| format!("#include <{name}>\n")).collect();
    let (mut c, mut rust) = (format!("{headers}#include <stddef.h>\n#include <stdio.h>\nint main(void)\n{{\n"), String::new());
    lines.iter().for_each(|one| one(&mut c, &mut rust));
    c.push_str("return 0;\n}\n");
    let said = c_prints(&c);
    for (theirs, ours) in said.lines().zip(rust.lines()) {
        assert_eq!(theirs, ours, "C on the left, Rust on the right");
    }
    assert_eq!(said.lines().count(), rust.lines().count());
    assert!(rust.lines().count() >= least, "only {} lines were compared", rust.lines().count());
}

mod structures_of_ode {
    use super::*;
    ode_structures!(lines_of_structures);
    pub const LINES: fn(&mut String, &mut String) = lines;
}
mod numbers_of_ode {
    use super::*;
    ode_numbers!(lines_of_numbers);
    pub const LINES: fn(&mut String, &mut String) = lines;
}
#[cfg(feature = "robots")]
mod of_robots {
    use super::*;
    pub mod structures {
        use super::*;
        robots_structures!(lines_of_structures);
        pub const LINES: fn(&mut String, &mut String) = lines;
    }
    pub mod numbers {
        use super::*;
        robots_numbers!(lines_of_numbers);
        pub const LINES: fn(&mut String, &mut String) = lines;
    }
}

#[test]
fn structures_have_the_layout_of_c() {
    compare(&[structures_of_ode::LINES], 200);
    #[cfg(feature = "robots")]
    compare(&[of_robots::structures::LINES], 60);
}

#[test]
fn numbers_have_the_values_of_c() {
    compare(&[numbers_of_ode::LINES], 250);
    #[cfg(feature = "robots")]
    compare(&[of_robots::numbers::LINES], 30);
}

macro_rules! addresses {
    ($($name:ident)*) => { vec![$((stringify!($name), $name as *const ())),*] };
}

#[test]
fn every_declared_function_is_in_the_library() {
    // The linker has found them all; an address shows that none was left out for being unused.
    let ode = ode_functions!(addresses);
    assert!(ode.len() > 800, "{} functions", ode.len());
    assert!(ode.iter().all(|(_, address)| !address.is_null()));
    #[cfg(feature = "robots")]
    assert!(robots_functions!(addresses).iter().all(|(_, address)| !address.is_null()));
}

macro_rules! words {
    ($($name:ident)*) => { vec![$(stringify!($name)),*] };
}

#[test]
fn every_function_of_the_library_is_declared() {
    let Ok(folder) = std::env::var("EPODE_LIB_DIR") else { return };
    let mut libraries = vec![(if cfg!(feature = "single") { "ode_single" } else { "ode" }, ode_functions!(words))];
    if ROBOTS {
        libraries.push(("epode_robots", robots_functions!(words)));
    }
    for (library, declared) in libraries {
        let path = format!("{folder}/lib{library}.so");
        let Ok(out) = Command::new("nm").args(["-D", "--defined-only", "--format=posix", &path]).output() else { return };
        let text = String::from_utf8(out.stdout).unwrap();
        let exported = text.lines().filter_map(|line| line.split_once(" T ")).map(|(name, _)| name.split('@').next().unwrap());
        let ours: Vec<_> = exported.filter(|n| n.starts_with('d') && n.as_bytes()[1].is_ascii_uppercase()).collect();
        assert!(ours.len() > 50, "nm has found {} functions in {path}", ours.len());
        let missing: Vec<_> = ours.into_iter().filter(|n| !declared.contains(n)).collect();
        assert!(missing.is_empty(), "{library} exports what epode-sys lacks: {missing:?}; run rust/tools/generate.py");
    }
}
