#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""generate.py FOLDER EXPORTS WITH_ROBOTS: writes to the folder what the npm package has of the public headers: methods of its classes (methods.mjs, joints.mjs,
geoms.mjs), enumerations and structures as its objects have them (enums.mjs, fields.mjs), with the headers' texts as JSDoc, of which tsc
makes the declarations; and to the files EXPORTS and WITH_ROBOTS the linker's options for the C functions that the package calls, without and with
those of robots. A function that no rule covers stops it.

What reads the headers is Rust's and Python's: rust/tools/raw.py, tools/header_docs.py."""
import dataclasses
import os
import pathlib
import re
import sys

HERE = pathlib.Path(__file__).resolve().parent
ENGINE = HERE.parent.parent.parent
sys.path[:0] = [str(ENGINE / "tools"), str(ENGINE / "rust" / "tools"), str(HERE)]
import methods
import package_rules as rules
import raw
import safe
import safe_rules
from methods import camel, comment, decapital

HEAD = """// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Written by wasm/npm/tools/generate.py from the public headers.
"""
CHECKS = "import {flag, int32, matrix, name_of, number_of, quaternion, real, uint32, vector} from './checks.mjs';\n"
IMPORTS = ("/** @import {Vector3, Vector4, Quaternion, Matrix3, Box6, VectorLike, QuaternionLike, MatrixLike} from './checks.mjs' */\n"
           "/** @import * as E from './enums.mjs' */\n/** @import * as F from './fields.mjs' */\n"
           "/** @import {Body} from './body.mjs' */\n")
USES = "import {enums} from './enums.mjs';\nimport {get_structure, prepare_structure, put_structure} from './structures.mjs';\n"


@dataclasses.dataclass
class Read:
    """What the methods need of the headers."""
    docs: dict
    enums: dict


def enumerations(api):
    """{name: ({JavaScript's name: number}, text)}"""
    found = {}
    for name, of, prefix, said in (*safe_rules.ENUMS, *rules.ENUMS):
        names = api.declared.enums[of] if isinstance(of, str) else of
        values = {}
        for n in names:
            short = methods.words(n.removeprefix(prefix).removesuffix("Class") or n)
            short = {"016": "ode016", "1": "v1"}.get(short, decapital(short))
            values[short] = api.numbers[n]
        found[name] = (values, said or api.comments.get(of, "") or f"C: {of}.")
    parameters = {decapital(methods.words(n.removeprefix("dParam"))): v for n, v in api.numbers.items()
                  if re.fullmatch(r"dParam[A-Z]\w*", n) and not re.search(r"Group|s_Out|Group\d", n)}
    found["Parameter"] = (parameters, "A parameter of a joint's axis; a 2 or 3 at the end is that of the second or third axis.")
    return found


def enums_text(enums):
    out = [HEAD]
    for name, (values, text) in enums.items():
        out.append(comment(text, ["@typedef {" + " | ".join(f"'{v}'" for v in values) + "} " + name], ""))
    out.append("/** The numbers that C has for the names. @type {{[name: string]: {[name: string]: number}}} */\nexport const enums = {\n")
    for name, (values, _) in enums.items():
        out.append(f"    {name}: {{" + ", ".join(f"{n}: {v}" for n, v in values.items()) + "},\n")
    return "".join(out) + "};\n"


PLAIN = {"dReal": ("real", "number"), "int": ("int32", "number"), "unsigned": ("uint32", "number"), "unsigned int": ("uint32", "number"),
         "unsigned long": ("uint32", "number"), "size_t": ("uint32", "number"), "double": ("real", "number"), "dVector3": ("vector", "Vector3"),
         "dVector4": ("vector", "Vector3"), "dMatrix3": ("matrix", "Matrix3")}


def field_kind(key, ctype):
    """(kind for structures.mjs, type of JSDoc) of a field."""
    kinds = safe_rules.KINDS_OF_FIELDS | rules.KINDS_OF_FIELDS
    if key in safe_rules.OPTIONAL_FIELDS:
        of = safe_rules.OPTIONAL_FIELDS[key]
        return f"{of}?", f"{of} | null"
    if key in kinds:
        return kinds[key], kinds[key]
    if key in safe_rules.FLAGS_OF_FIELDS | rules.FLAGS_OF_FIELDS:
        return "flag", "boolean"
    array = re.fullmatch(r"dReal\[(\d+)\]", ctype)
    if array:
        return f"reals:{array[1]}", "number[]"
    if ctype in methods.OBJECTS:
        return "object", {"dBodyID": "Body", "dGeomID": "Geom", "dJointID": "Joint"}[ctype] + " | null"
    kind = re.fullmatch(r"d(ContactEventKind|EventKind)", ctype)
    return (kind[1], kind[1]) if kind else PLAIN[ctype]


def field_name(name):
    return {"I": "inertia", "c": "centre", "pos": "position", "g1": "geom1", "g2": "geom2", "pos1": "position1", "pos2": "position2"}.get(name, camel(name))


def fields_text(api):
    out = [HEAD, "/** @import {Vector3, Matrix3} from './checks.mjs' */\n/** @import {Body} from './body.mjs' */\n"
           "/** @import {Geom} from './geom.mjs' */\n/** @import {Joint} from './joint.mjs' */\n/** @import {" +
           ", ".join(sorted({*safe_rules.KINDS_OF_FIELDS.values(), *rules.KINDS_OF_FIELDS.values(), *safe_rules.OPTIONAL_FIELDS.values()})) +
           "} from './enums.mjs' */\n"]
    table = []
    for ctype, (name, _, left_out) in methods.STRUCTURES.items():
        rows, tags = [], []
        for of, field in api.declared.structures[ctype]:
            array = re.fullmatch(r"(\w+)\[(\d+)\]", field)
            of, field = (f"{of}[{array[2]}]", array[1]) if array else (of, field)
            if field == "struct_size" or field in left_out:
                continue
            kind, shown = field_kind(f"{ctype}.{field}", of)
            text = " ".join(api.comments.get(f"{ctype}.{field}", "").split()).replace("@", "(at)")
            rows.append(f"{field_name(field)}: ['{field}', '{kind}']")
            tags.append(f"@property {{{shown}}} {field_name(field)} {text}".rstrip())
        out.append(comment(api.comments.get(ctype, "") or f"C: {ctype}.", [f"@typedef {{object}} {name}", *tags], ""))
        table.append(f"    {ctype}: {{\n        " + ",\n        ".join(rows) + ",\n    },\n")
    out.append("/** Of each structure its fields here: [C's name, kind]. @type {{[structure: string]: {[field: string]: [string, string]}}} */\n"
               "export const fields = {\n" + "".join(table) + "};\n")
    return "".join(out)


def gather(api, read):
    found, unknown, called = {}, [], set()
    for name, (result, parameters) in api.functions.items():
        typed = [safe.split_parameter(p, i) for i, p in enumerate(parameters)]
        if name in api.of_robots or not typed or not methods.owner_of(name) or typed[0][0] not in ("dWorldID", "dBodyID", "dJointID", "dGeomID"):
            continue
        left_out = methods.matches(rules.LEFT_OUT, name) or methods.matches(safe_rules.LEFT_OUT, name)
        if left_out or methods.matches(rules.WRITTEN, name) or methods.matches(safe_rules.WRITTEN, name):
            continue
        try:
            method = methods.Method(name, result, typed, read)
        except methods.Unknown as e:
            unknown.append(str(e))
            continue
        found.setdefault(method.owner, []).append(method)
    if unknown:
        raise SystemExit("generate.py: see wasm/npm/tools/package_rules.py:\n  " + "\n  ".join(unknown))
    return found


def qualified(of, enums):
    """A type with the file it is from."""
    of = re.sub(rf"\b({'|'.join(enums)})\b", r"E.\1", of)
    structures = "|".join(name for name, _, _ in methods.STRUCTURES.values())
    return re.sub(rf"(?<![.\w])({structures})\b", r"F.\1", of)


def members(owner, found, enums):
    """The text of a class's methods, and [(name, type)] of its properties that can be set."""
    setters = {decapital(methods.words(m.rest)): m for m in found if m.verb == "Set" and len(m.taken) == 1}
    getters = {m.name: m for m in found if m.verb in ("Get", "") and not m.taken and (m.verb == "Get" or re.match("Is[A-Z]", m.rest))}
    out, settable = [], []
    for m in found:
        label = f"{owner}.{m.name}"
        of, _ = m.returned()
        of = qualified(of, enums)
        if getters.get(m.name) is m:
            out.append(comment(m.text, ["", f"C: `{m.c}`.", f"@returns {{{of}}}"]) + f"    get {m.name}() {{\n{m.body(label)}    }}\n")
            s = setters.get(m.name)
            if s and len(m.results) == 1:
                js, taken, _ = s.taken[0]
                taken = qualified(taken, enums)
                settable.append((m.name, taken, s.text))
                out.append(comment(s.text, ["", f"C: `{s.c}`.", f"@param {{{taken}}} {js}"]) + f"    set {m.name}({js}) {{\n{s.body(label)}    }}\n")
            continue
        g = getters.get(decapital(methods.words(m.rest)))
        if setters.get(decapital(methods.words(m.rest))) is m and g and len(g.results) == 1:
            continue
        tags = [f"@param {{{qualified(t, enums)}}} {js} {what}".rstrip() for js, t, what in m.taken]
        arguments = ", ".join(js for js, _, _ in m.taken)
        out.append(comment(m.text, ["", f"C: `{m.c}`.", *tags, f"@returns {{{of}}}"]) + f"    {m.name}({arguments}) {{\n{m.body(label)}    }}\n")
    return "\n".join(out), settable


def options(name, settable):
    tags = [f"@property {{{of}}} [{n}] {' '.join(text.split())}".rstrip().replace("@s", "@s") for n, of, text in settable]
    return comment(f"What a new {name} may be given: its properties that can be set.", [f"@typedef {{object}} {name}Options", *tags], "")


def class_text(name, base, found, enums, owner):
    text, settable = members(owner, found, enums)
    doc = comment(f"The {owner}: what the C functions of its kind do.", [], "") if base == "Handle" else comment(f"A {owner}.", [], "")
    kind = "" if base == "Handle" else f"    /** The name of this kind. @readonly */\n    static kind = {decapital(name)!r};\n\n"
    return doc + f"export class {name} extends {base} {{\n{kind}{text}}}\n\n" + options(owner, settable), [n for n, _, _ in settable]


def kinds_text(names, what):
    """typedefs and a table of a family of classes by their names."""
    small = {decapital(n): n for n in names}
    return (comment(f"The classes of {what}s by their names.", [f"@typedef {{object}} {what}Kinds", *(f"@property {{{n}}} {k}" for k, n in small.items())], "") +
            comment(f"What each kind of {what.lower()} may be given.",
                    [f"@typedef {{object}} {what}KindOptions", *(f"@property {{{n}Options}} {k}" for k, n in small.items())], ""))


def files(api):
    enums = enumerations(api)
    found = gather(api, Read(api.docs, enums))
    settable, out = {}, {"enums.mjs": enums_text(enums), "fields.mjs": fields_text(api)}
    text = HEAD + CHECKS + "import {Handle} from './handle.mjs';\n" + USES + IMPORTS + "/** @import {Geom} from './geom.mjs' */\n\n"
    for name, base, begin in rules.CLASSES:
        owner = begin[1:]
        one, settable[owner] = class_text(name, base, found.pop(owner), enums, owner)
        text += one
    out["methods.mjs"] = text
    for file, base, names in (("joints.mjs", "Joint", rules.JOINTS), ("geoms.mjs", "Geom", rules.GEOMS)):
        text = HEAD + CHECKS + f"import {{{base}}} from './{base.lower()}.mjs';\n" + USES + IMPORTS + "\n"
        for name in names:
            one, settable[name] = class_text(name, base, found.pop(name, []), enums, name)
            text += one
        out[file] = text + kinds_text(names, base)
    if found:
        raise SystemExit(f"generate.py: of no class: {', '.join(found)}")
    out["settable.mjs"] = (HEAD + "/** The properties of each class that its options may have. @type {{[name: string]: string[]}} */\n"
                           "export const settable = {\n" + "".join(f"    {n}: {s},\n" for n, s in settable.items()) + "};\n")
    return out


def exported(api, generated):
    """The C functions that the package's files name, each of which the headers must have."""
    text = "".join(generated.values()) + "".join(p.read_text(encoding="utf-8") for p in (HERE.parent / "src").glob("*.mjs"))
    low = "".join((ENGINE / "wasm" / name).read_text(encoding="utf-8") for name in ("epode.mjs",))
    names = set(re.findall(r"\bc\.(d[A-Z]\w*)", text)) | set(re.findall(r"'(d[A-Z]\w*)'", text + low)) | set(re.findall(r"\bode\.(d[A-Z]\w*)", low))
    names |= {f"{ctype}Init" for ctype in methods.STRUCTURES} | {f"dJointCreate{name}" for name in rules.JOINTS}
    return sorted(n for n in names if n in api.functions)


def main():
    folder = pathlib.Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    api = raw.read(str(ENGINE / "include"), os.environ.get("CC", "cc"))
    generated = files(api)
    for name, text in generated.items():
        (folder / name).write_text(text, encoding="utf-8")
    names = exported(api, generated)
    for path, its in ((sys.argv[2], [n for n in names if n not in api.of_robots]), (sys.argv[3], names)):
        pathlib.Path(path).write_text("".join(f"--export={name}\n" for name in its), encoding="ascii")


if __name__ == "__main__":
    main()
