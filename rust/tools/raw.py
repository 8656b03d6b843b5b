# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""The declarations of epode-sys: C types as Rust has them. An argument that is an array is a pointer, a pointer to a function an
Option, an enumeration the unsigned number that C passes; numbers of enumerations without a name are c_int. What the headers
compute (values of enumerators) is computed by the C compiler."""
import dataclasses
import glob
import os
import re
import subprocess
import tempfile

import c_functions
import c_types
import header_docs

HEAD = """// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Written by rust/tools/generate.py from the public headers.
"""
NUMBERS = {"int": "c_int", "unsigned": "c_uint", "unsigned int": "c_uint", "unsigned long": "c_ulong", "size_t": "usize", "float": "f32",
           "double": "f64", "char": "c_char", "unsigned char": "c_uchar", "short": "c_short", "void": "c_void", "time_t": "time_t",
           "dsizeint": "usize", "ddiffint": "isize", "duint32": "u32", "dint64": "i64", "duint64": "u64", "dintptr": "isize",
           "duintptr": "usize", "FILE": "FILE", "va_list": "va_list"}
ARRAYS = {"dVector3": 4, "dVector4": 4, "dQuaternion": 4, "dMatrix3": 12, "dMatrix4": 16, "dMatrix6": 48}
LEFT_OUT = {"double_t"}  # the C library's


@dataclasses.dataclass
class Api:
    """Everything that the headers declare."""
    declared: c_types.Declared
    functions: dict  # name: (result, parameters as C has them)
    of_robots: set  # the functions and types of libepode_robots
    docs: dict  # function: text
    comments: dict  # type, or type.field: text
    numbers: dict  # enumerator: value
    headers: list  # their names


def read(include, cc):
    ode = c_functions.preprocessed(include, cc)
    text = c_functions.preprocessed(include, cc, ("ode", "epode"))
    declared, own = c_types.declared(text), c_types.declared(ode)
    every = _functions(text)
    types = [*declared.enums, *declared.structures, *declared.opaque, *declared.names]
    known = {*own.enums, *own.structures, *own.opaque, *own.names}
    robots = {n for n in types if n not in known} | {n for n in every if n not in _functions(ode)}
    folders = [os.path.join(include, folder) for folder in ("ode", "epode")]
    docs, comments = {}, {}
    for folder in folders:
        docs |= header_docs.texts(folder)
        comments |= c_types.comments(folder)
    return Api(declared, every, robots, docs, comments, _values(include, cc, declared), _headers(include))


def _functions(text):
    found = {}
    for m in re.finditer(r"EPODE_EXPORTED ([^;{]*?)(\bd[A-Z]\w*) ?\(([^;]*)\);", text):
        parameters = c_functions.split(m[3]) + (["..."] if m[3].rstrip().endswith("...") else [])
        found.setdefault(m[2], (m[1].replace("EPODE_EXPORTED", "").strip(), parameters))
    return found


def _values(include, cc, declared):
    names = [n for of in declared.enums.values() for n in of]
    shown = "".join(f'    printf("{n} %ld\\n", (long){n});\n' for n in names)
    headers = "".join(f"#include <{h}>\n" for h in _headers(include))
    with tempfile.TemporaryDirectory() as folder:
        source, program = os.path.join(folder, "values.c"), os.path.join(folder, "values")
        with open(source, "w", encoding="ascii") as f:
            f.write(f"#include <stdio.h>\n{headers}int main(void)\n{{\n{shown}    return 0;\n}}\n")
        subprocess.run([cc, "-I" + include, "-w", source, "-o", program], check=True)
        out = subprocess.run([program], capture_output=True, text=True, check=True).stdout
    return {name: int(value) for name, value in (line.split() for line in out.splitlines())}


def _headers(include):
    """The names of all headers, as programs include them."""
    paths = [path for folder in ("ode", "epode") for path in sorted(glob.glob(os.path.join(include, folder, "*.h")))]
    return [os.path.relpath(path, include) for path in paths if not re.search(c_functions.INCLUDED_BY_OTHERS, path)]


class Types:
    """C types as Rust has them."""

    def __init__(self, declared):
        self.declared = declared
        self.own = {*declared.names, *declared.structures, *declared.enums, *declared.opaque, *ARRAYS, "dReal"} - NUMBERS.keys()

    def value(self, ctype):
        """Of a field or a result."""
        ctype = ctype.strip()
        array = re.fullmatch(r"(.*)\[(\d+)\]", ctype)
        if array:
            return f"[{self.value(array[1])}; {array[2]}]"
        function = re.fullmatch(r"(.*)\(\*\)\((.*)\)", ctype)
        if function:
            return self.function(function[1], c_functions.split(function[2]))
        if ctype.endswith("const*"):
            return "*const " + self.value(ctype.removesuffix("const*"))
        if ctype.endswith("*"):
            of = ctype[:-1].strip()
            if of in self.declared.callbacks:
                return of
            const = of.startswith("const ") and not of.endswith("*")
            return ("*const " if const else "*mut ") + self.value(of.removeprefix("const ") if const else of)
        ctype = ctype.removeprefix("const ").removeprefix("struct ").removeprefix("enum ")
        if ctype in self.own:
            return ctype
        return NUMBERS[ctype]

    def parameter(self, declaration, index):
        """(name, type) of a parameter as C has it."""
        if declaration == "...":
            return None, "..."
        function = re.fullmatch(r"(.*?)\( ?\* ?(\w*)\) ?\((.*)\)", declaration)
        if function:
            return function[2] or f"arg{index}", self.function(function[1], c_functions.split(function[3]))
        array = re.fullmatch(r"(.*?)(\w+)\[\w*\]", declaration)
        if array:
            return array[2], self.value(array[1].strip() + "*")
        whole = re.fullmatch(r"(.*[ *])(\w+)", declaration)
        bare = declaration.removeprefix("const ")
        ctype, name = (declaration, f"arg{index}") if bare in self.own or bare in NUMBERS or not whole else (whole[1].strip(), whole[2])
        base = ctype.removeprefix("const ").strip()
        if base in ARRAYS:
            return name, ("*const " if ctype.startswith("const ") else "*mut ") + "dReal"
        return name, self.value(ctype.replace(" *", "*"))

    def function(self, result, parameters):
        types = ", ".join(self.parameter(p, i)[1] for i, p in enumerate(parameters))
        return f"Option<unsafe extern \"C\" fn({types}){self.returned(result)}>"

    def returned(self, result):
        return "" if result.strip() == "void" else " -> " + self.value(result.strip().replace(" *", "*"))


def doc(text, indent=""):
    """A comment as rustdoc has it: nothing in it is a link, an emphasis or a tag."""
    lines = re.sub(r"([\[\]<>*_`|#~$\\])", r"\\\1", text).splitlines()
    return "".join(f"{indent}/// {line}".rstrip() + "\n" for line in lines)


def identifier(name):
    return f"r#{name}" if name in ("in", "type", "fn", "impl", "ref", "use", "move", "box") else name


def files(api):
    types = Types(api.declared)
    return {"epode-sys/src/ode.rs": _part(api, types, False), "epode-sys/src/robots.rs": _part(api, types, True),
            "epode-sys/tests/names/mod.rs": _names(api)}


def _part(api, types, robots):
    here = lambda name: (name in api.of_robots) == robots
    d = api.declared
    out = [HEAD, "use super::*;\n\n"]
    filled = {n for n in d.structures}
    for name in d.opaque:
        if here(name) and name not in filled:
            out.append(f"#[repr(C)]\npub struct {name} {{\n    _private: [u8; 0],\n    _marker: Unshared,\n}}\n")
    for name, ctype in d.names.items():
        if here(name) and name not in LEFT_OUT | NUMBERS.keys() and name != "dReal":
            out.append(f"{doc(api.comments.get(name, ''))}pub type {name} = {types.value(ctype)};\n")
    if not robots:
        out += [f"{doc(api.comments.get(n, ''))}pub type {n} = [dReal; {size}];\n" for n, size in ARRAYS.items()]
    for name, (result, parameters) in d.callbacks.items():
        if not robots:
            out.append(f"{doc(api.comments.get(name, ''))}pub type {name} = {types.function(result, parameters)};\n")
    for name, of in d.enums.items():
        of = [n for n in of if not name or here(name)] if name or not robots else []
        if not of:
            continue
        kind = name or "c_int"
        if name:
            signed = any(api.numbers[n] < 0 for n in of)
            out.append(f"{doc(api.comments.get(name, ''))}pub type {name} = {'c_int' if signed else 'c_uint'};\n")
        for n in of:
            text = api.comments.get(f"{name}.{n}", "")
            out.append(f"{doc(text)}pub const {n}: {kind} = {api.numbers[n]};\n")
    for name, fields in d.structures.items():
        if not here(name):
            continue
        out.append(f"{doc(api.comments.get(name, ''))}#[repr(C)]\n#[derive(Clone, Copy, Debug)]\npub struct {name} {{\n")
        for ctype, field in fields:
            out.append(f"{doc(api.comments.get(f'{name}.{field}', ''), '    ')}    pub {identifier(field)}: {types.value(ctype)},\n")
        out.append("}\n")
    out.append('extern "C" {\n')
    for name, (result, parameters) in api.functions.items():
        if here(name):
            taken = [types.parameter(p, i) for i, p in enumerate(parameters)]
            written = ", ".join("..." if n is None else f"{identifier(n)}: {t}" for n, t in taken)
            never = " -> !" if name in ("dError", "dDebug") else types.returned(result)
            out.append(f"{doc(api.docs.get(name, ''), '    ')}    pub fn {name}({written}){never};\n")
    out.append("}\n")
    return "".join(out)


def _names(api):
    """Macros that hand the names to another one."""
    d = api.declared

    def group(robots):
        here = lambda name: (name in api.of_robots) == robots
        structures = "".join(f"        {n} {{ {' '.join(identifier(f) for _, f in fields)} }}\n" for n, fields in d.structures.items() if here(n))
        numbers = "".join(f"        {n}\n" for name, of in d.enums.items() for n in of if (here(name) if name else not robots))
        functions = "".join(f"        {n}\n" for n in api.functions if here(n))
        word = "robots" if robots else "ode"
        return "".join(f"#[macro_export]\nmacro_rules! {word}_{what} {{\n    ($to:ident) => {{ $to! {{\n{names}    }} }};\n}}\n"
                       for what, names in (("structures", structures), ("numbers", numbers), ("functions", functions)))
    headers = "".join(f'    "{name}",\n' for name in api.headers)
    return HEAD + f"pub const HEADERS: &[&str] = &[\n{headers}];\n" + group(False) + group(True)
