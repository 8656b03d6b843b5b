#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""interface.py CLANG [OPTION...]: writes, as a JavaScript module, what the public headers say beyond functions and the
module for WebAssembly does not hold: `constants` {name: value} and `structures` {name: {size, fields: {name: [offset,
kind, count]}}}. Offsets are the compiler's own. Structures without a tag have no entry."""
import json
import re
import subprocess
import sys

HEADERS = "#include <ode/ode.h>\n#include <ode/ext.h>\n#include <epode/robots.h>\n"
KINDS = {"int": "Int32", "unsigned int": "Uint32", "unsigned long": "Uint32", "unsigned char": "Uint8", "unsigned short": "Uint16",
         "float": "Float32", "double": "Float64", "size_t": "Uint32", "dsizeint": "Uint32", "uint64_t": "BigUint64",
         "unsigned long long": "BigUint64", "time_t": "BigInt64"}
VECTORS = {"dVector3": 4, "dVector4": 4, "dQuaternion": 4, "dMatrix3": 12, "dMatrix4": 16}


def compiled(options, *more):
    return subprocess.run([*options, *more, "-fsyntax-only", "-x", "c", "-"], input=HEADERS, text=True, check=True,
                          stdout=subprocess.PIPE).stdout


def constants(tree):
    """Of all enumerations of ours, in their order."""
    found = {}
    for node in tree["inner"]:
        if node["kind"] != "EnumDecl":
            continue
        value = -1
        for item in node.get("inner", []):
            if item["kind"] != "EnumConstantDecl":
                continue
            given = item.get("inner", [{}])[0].get("value")
            value = value + 1 if given is None else int(given)
            if item["name"].startswith("d"):
                found[item["name"]] = value
    return found


def kind_of(text, real, enumerations):
    """The kind and count of a field's type."""
    array = re.fullmatch(r"(.+?)\[(\d+)\]", text)
    count = int(array[2]) if array else 1
    name = (array[1] if array else text).removeprefix("const ").strip()
    if name in VECTORS:
        return real, VECTORS[name] * count
    if name == "dReal":
        return real, count
    if "*" in name or re.fullmatch(r"d\w+ID", name):
        return "Uint32", count
    return ("Int32" if name in enumerations or name.startswith("enum ") else KINDS[name]), count


def structures(layouts, real, enumerations):
    found = {}
    for block in layouts.split("*** Dumping AST Record Layout")[1:]:
        head, *lines = block.strip().split("\n")
        name = re.fullmatch(r"0 \| struct (d\w+)", head.strip())
        if not name:
            continue
        fields, outer = {}, []
        for line in lines:
            size = re.search(r"\[sizeof=(\d+)", line)
            if size:
                found[name[1]] = {"size": int(size[1]), "fields": fields}
                break
            offset, depth, kind, field = re.fullmatch(r" *(\d+) \|( +)(.+?) (\w+)", line).groups()
            outer = outer[:len(depth) // 2 - 1]
            if kind.startswith("struct d") and "*" not in kind:
                outer.append(field)
                continue
            fields[".".join([*outer, field])] = [int(offset), *kind_of(kind, real, enumerations)]
    return found


def main():
    options = sys.argv[1:]
    tree = json.loads(compiled(options, "-Xclang", "-ast-dump=json"))
    enumerations = {n["name"] for n in tree["inner"] if n["kind"] == "TypedefDecl" and '"EnumType"' in json.dumps(n)}
    real = "Float32" if "-DdIDESINGLE" in options else "Float64"
    named = constants(tree)
    layouts = compiled(options, "-Xclang", "-fdump-record-layouts-complete")
    structs = structures(layouts, real, enumerations)
    if len(named) < 200 or len(structs) < 20:
        sys.exit("interface.py: hardly a name was found: the headers were not read")
    print("// Written by wasm/interface.py from the headers.")
    print("export const real = " + json.dumps(real) + ";")
    print("export const constants = Object.freeze(" + json.dumps(named, indent=0) + ");")
    print("export const structures = Object.freeze(" + json.dumps(structs) + ");")


main()
