// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Files that were dropped on the page, as a robot's reader wants them: by their paths, and (of files without their folders) also by the
// names that the robot's files have for them.
const kReference = /\b(?:filename|file|uri)\s*=\s*["']([^"']+)["']/g;
const kFolders = /\b(?:meshdir|assetdir|texturedir)\s*=\s*["']([^"']+)["']/g;
const kText = /\.(urdf|xml|mjcf)$/i;
const last_of = path => path.slice(path.lastIndexOf('/') + 1);
const folder_of = path => path.slice(0, path.lastIndexOf('/') + 1);

// Paths that a reference may have in the map, seen from the file that makes it.
function places_of(reference, folder, folders) {
    const scheme = /^(?:package|model|file):\/\//.exec(reference), plain = scheme ? reference.slice(scheme[0].length) : reference;
    if (scheme || plain.startsWith('/')) return [plain.replace(/^\/+/, '')];
    return [folder + plain, ...folders.map(inner => `${folder}${inner.replace(/\/$/, '')}/${plain}`)];
}

// The files, and under each name by which a text among them asks for one that is not there: the one whose own name is the same.
export function with_aliases(files) {
    const all = new Map(files), by_name = new Map([...files.keys()].map(path => [last_of(path).toLowerCase(), path]));
    for (const [path, content] of files) {
        if (!kText.test(path)) continue;
        const text = new TextDecoder().decode(content), folders = [...text.matchAll(kFolders)].map(found => found[1]);
        for (const [, reference] of text.matchAll(kReference)) {
            const found = by_name.get(last_of(reference).toLowerCase()), places = places_of(reference, folder_of(path), folders);
            if (!found || places.some(place => all.has(clean(place)))) continue;
            for (const place of places.map(clean)) if (place) all.set(place, files.get(found));
        }
    }
    return all;
}

// Without "." and ".."; what leads out of the folder stays at its top.
function clean(path) {
    const parts = [];
    for (const part of path.split('/')) {
        if (part === '..') parts.pop();
        else if (part !== '' && part !== '.') parts.push(part);
    }
    return parts.join('/');
}

// Of a drop or an <input>: paths and bytes, folders with all that is in them.
export async function files_of_drop(transfer) {
    const entries = [...transfer.items].map(item => item.webkitGetAsEntry?.()).filter(entry => entry);
    if (entries.length === 0) return files_of_list(transfer.files);
    const found = (await Promise.all(entries.map(entry => files_of_entry(entry)))).flat();
    return read_all(found);
}

export const files_of_list = list => read_all([...list].map(file => [file.webkitRelativePath || file.name, file]));

async function read_all(found) {
    return new Map(await Promise.all(found.map(async ([path, file]) => [path, new Uint8Array(await file.arrayBuffer())])));
}

async function files_of_entry(entry) {
    if (entry.isFile) return [[entry.fullPath.replace(/^\//, ''), await new Promise((resolve, reject) => entry.file(resolve, reject))]];
    const reader = entry.createReader(), all = [];
    for (;;) {
        const some = await new Promise((resolve, reject) => reader.readEntries(resolve, reject));
        if (some.length === 0) break;
        all.push(...some);
    }
    return (await Promise.all(all.map(inner => files_of_entry(inner)))).flat();
}
