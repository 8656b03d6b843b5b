#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""generate.py ENGINE CC OUTPUT PARTS: writes the binding of every public C function and structure as C++, with the text
of the headers as docstrings; written_texts.h, the signatures and texts of functions that are bound by hand; _c.pyi, the
types of all of it for type checkers; and coverage.json, which says of each function how it is reached or why it is not.

A parameter's type tells what it becomes: a handle, a number, fixed numbers of reals that are read, or (not const)
written and returned; a structure is passed as an object. Whatever needs more is in rules.py."""
import json
import os
import re
import sys

sys.path.insert(0, os.path.join(sys.argv[1], "tools"))
import header_docs
import rules
from c_functions import FIXED, HANDLES, SCALARS, enumerators, functions, preprocessed, structures

# What a type checker reads of arrays: FloatArray is numpy's, of float64.
ARRAY_IN, ARRAY_OUT = "ArrayLike", "FloatArray"
RETURNED = [(r"Rotation", "matrix_of(r)"), (r"Quaternion", "array_of(r, 4)"), (r"LastTransform", "array_of(r, 16)"),
            (r"", "array_of(r, 3)")]


class Parameter:
    """How one C parameter is taken from Python (signature, before the call), passed, and handed back."""

    def __init__(self, ctype, name, function, structs):
        self.name, self.taken, self.before, self.passed, self.out, self.uses = name, None, "", name, None, False
        self.type, self.out_type = None, ARRAY_OUT  # as Python names them
        const, base = ctype.startswith("const "), ctype.removeprefix("const ").strip()
        in_and_out = re.fullmatch(rules.READ_AND_WRITTEN, function)
        if base in HANDLES:
            kind = HANDLES[base]
            self.taken, self.uses = f"const {kind}Handle* {name}", True
            self.passed = f"space_of({name})" if kind == "Space" else f"get({name})"
            self.arg = f'"{name}"_a.none()'
            self.type = base + " | None"
        elif base in SCALARS:
            self.taken, self.arg, self.type = f"{SCALARS[base]} {name}", f'"{name}"_a', scalar_type(base)
            if base == "dJointType":
                self.passed = f"dJointType({name})"
        elif base in FIXED and (const or in_and_out):
            self.taken, self.arg, self.type = f"nb::object {name}", f'"{name}"_a', ARRAY_IN
            self.before = f'auto {name}_v = numbers<{FIXED[base]}>({name}, "{name}");'
            self.passed = f"{name}_v.v"
            self.out = written(base, f"{name}_v.v") if in_and_out else None
        elif base in FIXED:
            self.before = f"dReal {name}[{FIXED[base]}] = {{}};"
            self.out = written(base, name)
        elif ctype in ("dReal*", "int*"):
            self.before, self.passed, self.out = f"{ctype[:-1]} {name} = 0;", f"&{name}", f"nb::cast({name})"
            self.out_type = scalar_type(ctype[:-1])
        elif ctype == "const char*":
            self.taken, self.passed, self.arg = f"const std::string& {name}", f"{name}.c_str()", f'"{name}"_a'
            self.type = "str"
        elif base.endswith("*") and base[:-1] in structs | {"dQueryFilter": 0}:
            bound = "Filter" if base == "dQueryFilter*" else base[:-1]
            self.taken = f"{bound}* {name}"
            self.arg = f'"{name}"_a.none()'
            self.type = base[:-1] + " | None"
            self.passed = f"filter_of({name})" if bound == "Filter" else name
        else:
            raise KeyError(f"{ctype} {name}")


def scalar_type(ctype):
    return "float" if ctype in ("dReal", "double", "float") else "int"


def written(base, v):
    if base == "dMatrix3":
        return f"matrix_of({v})"
    return f"array_of({v}, {FIXED[base]})" if base != "dVector3" else f"array_of({v}, 3)"


def result_of(ctype, name, structs):
    if ctype == "const dReal*":
        return next(code for pattern, code in RETURNED if re.search(pattern, name))
    if ctype in HANDLES:
        return "wrapped(r)"
    if ctype in SCALARS:
        return "nb::cast(int(r))" if ctype == "dJointType" else "nb::cast(r)"
    if ctype == "const char*":
        return "nb::cast(std::string(r ? r : \"\"))"
    raise KeyError(f"returns {ctype}")


def type_of_result(ctype, name):
    if ctype == "void":
        return []
    if ctype == "const dReal*":
        return [ARRAY_OUT]
    if ctype in HANDLES:  # what cannot be made is refused, what is not there is None
        return [ctype if "Create" in name else ctype + " | None"]
    return ["str" if ctype == "const char*" else scalar_type(ctype)]


def signature(name, taken, result):
    """As _c.pyi has it."""
    parameters = ", ".join(f"{p.name}: {p.type}" for p in taken if p.taken)
    types = type_of_result(result, name) + [p.out_type for p in taken if p.out]
    returned = "None" if not types else types[0] if len(types) == 1 else f"tuple[{', '.join(types)}]"
    return f"def {name}({parameters}) -> {returned}"


def binding(result, name, typed, structs, doc):
    """The C++ of a function and its signature."""
    taken = [Parameter(t, n, name, structs) for t, n in typed]
    lines = [p.before for p in taken if p.before] + ["Call call;"]
    lines += [f"call.uses({p.passed});" for p in taken if p.uses]
    call = f"{name}({', '.join(p.passed for p in taken)})"
    outs = [p.out for p in taken if p.out]
    kept = "" if result == "void" else "auto r = "
    if re.fullmatch(rules.STEPS, name):
        lines.append(f"int r; dWorldID stepped = {taken[0].passed}; {{ Released released(&stepped, 1); r = {call}; }}")
    else:
        lines.append(f"{kept}{call};")
    lines.append("call.done();")
    lines += [code.format(taken[0].passed) for pattern, code in rules.AFTER.items() if re.fullmatch(pattern, name)]
    results = ([] if result == "void" else [result_of(result, name, structs)]) + outs
    if len(results) == 1:
        lines.append(f"return nb::object({results[0]});")
    elif results:
        lines.append(f"return nb::object(nb::make_tuple({', '.join(results)}));")
    else:
        lines.append("return nb::object(nb::none());")
    arguments = "".join(", " + p.arg for p in taken if p.taken)
    taken_here = ", ".join(p.taken for p in taken if p.taken)
    body = "\n        ".join(lines)
    sig = signature(name, taken, result)
    return (f'    m.def("{name}", []({taken_here}) -> nb::object {{\n        {body}\n    }}{arguments}, '
            f'nb::sig({quoted(sig)}), {quoted(doc)});'), sig


def quoted(text):
    return json.dumps(text, ensure_ascii=True)


def field_code(struct, ctype, field, structs):
    array = ARRAY_FIELD.fullmatch(field)
    if array and ctype == "dReal":
        field, n = array.groups()
        return (f'.def_prop_rw("{field}", [](const {struct}& s) {{ return array_of(s.{field}, {n}); }}, '
                f'[]({struct}& s, nb::object v) {{ read_some(v, s.{field}, {n}, "{field}"); }})')
    if array:
        raise KeyError(f"{ctype} {field}")
    get, args = f"[](const {struct}& s)", f'"{field}"'
    if ctype in FIXED:
        n = FIXED[ctype]
        out = "matrix_of" if ctype == "dMatrix3" else "array_of"
        shown = f"{out}(s.{field})" if ctype == "dMatrix3" else f"{out}(s.{field}, {n})"
        return (f'.def_prop_rw({args}, {get} {{ return {shown}; }}, []({struct}& s, nb::object v) '
                f'{{ auto n = numbers<{n}>(v, {args}); std::copy_n(n.v, {n}, s.{field}); }})')
    if ctype in HANDLES:
        put = f"[]({struct}& s, const {HANDLES[ctype]}Handle* v) {{ s.{field} = {'space_of' if ctype == 'dSpaceID' else 'get'}(v); }}"
        return f'.def_prop_rw({args}, {get} {{ return wrapped(s.{field}); }}, {put}, nb::for_setter(nb::arg("v").none()))'
    if ctype in structs:
        return f".def_rw({args}, &{struct}::{field})"
    if ctype in SCALARS or ctype == "float":
        return f".def_rw({args}, &{struct}::{field})"
    if re.fullmatch(r"d\w+Kind", ctype):
        return f'.def_prop_ro({args}, {get} {{ return int(s.{field}); }})'
    raise KeyError(f"{ctype} {field}")


def structure_code(name, fields, structs):
    init = "*s = {};"
    if fields[0][1] == "struct_size":
        init += f" s->struct_size = sizeof({name});"
        if f"{name}Init" in structs["#names"]:
            init = f"{name}Init(s, sizeof({name}));"
    members = "\n        ".join(field_code(name, t, f, structs) for t, f in fields if f != "struct_size")
    return (f'    nb::class_<{name}>(m, "{name}")\n'
            f'        .def("__init__", []({name}* s) {{ {init} }})\n        {members};')


# dReal ratios[10]: an array of so many numbers; of one that is set, the rest is 0.
ARRAY_FIELD = re.compile(r"(\w+)\[(\d+)\]")


def field_type(ctype):
    if ctype in FIXED:
        return ARRAY_OUT
    if ctype in HANDLES:
        return ctype + " | None"
    is_structure = ctype.startswith("d") and ctype not in SCALARS and not ctype.endswith("Kind")
    return ctype if is_structure else scalar_type(ctype)


def structure_stub(name, fields):
    lines = [f"class {name}:", "    def __init__(self) -> None: ..."]
    for ctype, field in fields:
        if field == "struct_size":
            continue
        getter = ["    @property", f"    def {field}(self) -> {field_type(ctype)}: ..."]
        array = ARRAY_FIELD.fullmatch(field)
        if array:
            field, getter = array[1], ["    @property", f"    def {array[1]}(self) -> {ARRAY_OUT}: ..."]
        if ctype in FIXED or array:  # whatever numpy takes may be assigned
            lines += getter + [f"    @{field}.setter", f"    def {field}(self, value: {ARRAY_IN}) -> None: ..."]
        elif ctype.endswith("Kind"):
            lines += getter
        else:
            lines.append(f"    {field}: {field_type(ctype)}")
    return "\n".join(lines)


def function_stub(sig, doc):
    if not doc:
        return sig + ": ..."
    text = doc.replace("\\", "\\\\").replace("\n", "\n    ")
    return f'{sig}:\n    """{text}"""'


STUB_HEAD = """# Written by python/tools/generate.py from the public headers.
from typing import Any, Callable, Iterator, Sequence

import numpy as np
from numpy.typing import ArrayLike, NDArray

FloatArray = NDArray[np.float64]


class _Handle:
    @property
    def id(self) -> int: ...
    def __hash__(self) -> int: ...
    def __eq__(self, other: object) -> bool: ...


"""

HEAD = '// Written by python/tools/generate.py from the public headers.\n#include "calls.h"\n#include "filter.h"\n\n#include <algorithm>\n\n'


def main():
    engine, cc, output, parts = sys.argv[1], sys.argv[2], sys.argv[3], int(sys.argv[4])
    text = preprocessed(os.path.join(engine, "include"), cc)
    text = re.sub(rules.POINTERS_LEFT_OUT, "", text)
    every = list({name: (r, name, typed) for r, name, typed in functions(text)}.values())
    docs, all_structs = header_docs.texts(os.path.join(engine, "include", "ode")), structures(text)
    all_structs["#names"] = {name for _, name, _ in every}
    structs, codes, coverage = {"#names": all_structs["#names"]}, [], {}
    bound_structs, stubs, texts_of_written = [], [], []
    for name, fields in all_structs.items():
        if name == "#names" or name.startswith(("dWorldStepReserve", "dWorldStepMemory", "dThreadingF", "dThreaded", "dGeomClass", "dStopwatch", "dManifold")):
            continue
        try:
            bound_structs.append(structure_code(name, fields, all_structs))
            structs[name] = fields
            stubs.append(structure_stub(name, fields))
        except KeyError as e:
            print(f"structure {name} left out: {e}")
    for result, name, typed in every:
        if name in rules.WRITTEN:
            coverage[name] = "written"
            sig = f"def {name}{rules.WRITTEN[name]}"
            stubs.append(function_stub(sig, docs.get(name, "")))
            texts_of_written.append(f"#define TEXT_{name} nb::sig({quoted(sig)}), {quoted(docs.get(name, ''))}\n")
            continue
        reason = next((why for p, why in rules.LEFT_OUT.items() if re.fullmatch(p, name)), None)
        if reason:
            coverage[name] = "left out: " + reason
            continue
        try:
            code, sig = binding(result, name, typed, structs, docs.get(name, ""))
            codes.append(code)
            stubs.append(function_stub(sig, docs.get(name, "")))
            coverage[name] = "generated"
        except KeyError as e:
            coverage[name] = f"unknown: {e.args[0]}: see python/tools/rules.py"
    per = -(-len(codes) // parts)
    for i in range(parts):
        with open(os.path.join(output, f"functions_{i}.cpp"), "w", encoding="ascii") as f:
            f.write(HEAD + f"void bind_functions_{i}(nb::module_& m)\n{{\n" + "\n".join(codes[i * per:(i + 1) * per]) + "\n}\n")
    with open(os.path.join(output, "structures.cpp"), "w", encoding="ascii") as f:
        f.write(HEAD + "".join(f"void bind_functions_{i}(nb::module_& m);\n" for i in range(parts)))
        f.write("void bind_functions(nb::module_& m)\n{\n" + "".join(f"    bind_functions_{i}(m);\n" for i in range(parts)) + "}\n\n")
        f.write("void bind_structures(nb::module_& m)\n{\n" + "\n".join(bound_structs) + "\n")
        f.write("".join(f'    m.attr("{n}") = long({n});\n' for n in enumerators(text)) + "}\n")
    with open(os.path.join(output, "written_texts.h"), "w", encoding="ascii") as f:
        f.write("// Written by python/tools/generate.py: signatures and texts of functions that are bound by hand.\n#pragma once\n\n")
        f.write("#define TEXT(name) TEXT_##name\n" + "".join(texts_of_written))
    with open(os.path.join(output, "_c.pyi"), "w", encoding="utf-8") as f:
        handles = "".join(f"class {n}({'dGeomID' if n == 'dSpaceID' else '_Handle'}): ...\n" for n in HANDLES)
        numbers = "".join(f"{n}: int\n" for n in enumerators(text))
        f.write("\n\n".join([STUB_HEAD + handles, rules.WRITTEN_CLASSES, *stubs, numbers]))
    with open(os.path.join(output, "coverage.json"), "w", encoding="ascii") as f:
        json.dump({"functions": coverage}, f)


if __name__ == "__main__":
    main()
