// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Tests and examples of this crate find the library where epode-sys has found it.
fn main() {
    let Ok(folder) = std::env::var("DEP_ODE_LIB_DIR") else { return };
    println!("cargo:rustc-env=EPODE_LINKED={folder}");
    if !cfg!(windows) {
        println!("cargo:rustc-link-arg=-Wl,-rpath,{folder}");
    }
}
