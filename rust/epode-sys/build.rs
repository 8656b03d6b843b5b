// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Where the library is: EPODE_LIB_DIR (a build's lib folder), or what pkg-config says of an installed Epode. Debian's libode has
// the same name and half of the functions, so the headers that pkg-config names must be Epode's.
use std::path::Path;
use std::process::Command;

fn main() {
    println!("cargo:rerun-if-env-changed=EPODE_LIB_DIR");
    println!("cargo:rerun-if-env-changed=PKG_CONFIG_PATH");
    if std::env::var_os("DOCS_RS").is_some() {
        return;
    }
    let (library, package) = if cfg!(feature = "single") { ("ode_single", "ode-single") } else { ("ode", "ode") };
    let folder = std::env::var("EPODE_LIB_DIR").unwrap_or_else(|_| installed(package));
    println!("cargo:rustc-link-search=native={folder}");
    println!("cargo:rustc-link-lib=dylib={library}");
    if cfg!(feature = "robots") {
        println!("cargo:rustc-link-lib=dylib=epode_robots");
    }
    println!("cargo:lib_dir={folder}");
    if !cfg!(windows) {
        println!("cargo:rustc-link-arg=-Wl,-rpath,{folder}");
    }
}

fn installed(package: &str) -> String {
    let include = variable(package, "includedir");
    if !Path::new(&include).join("ode/ext.h").exists() {
        panic!("the {package} that pkg-config finds is not Epode's ({include}/ode/ext.h is missing): set EPODE_LIB_DIR");
    }
    variable(package, "libdir")
}

fn variable(package: &str, name: &str) -> String {
    let program = std::env::var("PKG_CONFIG").unwrap_or_else(|_| "pkg-config".into());
    let found = Command::new(program).arg(format!("--variable={name}")).arg(package).output();
    match found {
        Ok(out) if out.status.success() => String::from_utf8_lossy(&out.stdout).trim().to_string(),
        _ => panic!("pkg-config finds no {package}: install Epode, or set EPODE_LIB_DIR to the folder of its library"),
    }
}
