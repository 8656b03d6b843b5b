// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "state/world_copy.h"

#include <cstdio>
#include <cstring>

#include "base/check.h"
#include "base/streams/checksum.h"
#include "collide/surfaces/height_samples.h"
#include "state/world_archive.h"
#include "state/world_file.h"
#include "state/world_structure.h"

namespace epode {
namespace {

using Use = StructureStream::Use;
using Text = std::span<char>;

const char* put(Text text, const char* wrong)
{
    std::snprintf(text.data(), text.size(), "%s", wrong);
    return text.data();
}

// The state of the world in memory that is its own; null: out of memory.
WorldState* written_state(World& world, Seal with)
{
    WorldArchive* const archive = archive_of(world);
    return archive && archive->state.prepare() && archive->state.write(with) ? &archive->state : nullptr;
}

const char* append_state(World& world, Array<std::byte>& out)
{
    const WorldState* const state = written_state(world, Seal::kSealed);
    if (!state) return kOutOfMemory;
    const std::span<const std::byte> from = state->written();
    const std::size_t begin = std::size_t(out.size()), end = begin + from.size();
    if (end > std::size_t(std::numeric_limits<int>::max() / 2)) return "the world is too large for one file";
    if (!out.reserve(int(end))) return kOutOfMemory;
    (void)out.extend(int(from.size()));
    std::memcpy(out.data() + begin, from.data(), from.size());
    return nullptr;
}

// Builds a world from what the stream has and gives it its state.
const char* build(ShapeStream& stream, std::span<const std::byte> state, Seal with, WorldCopy& out,
                  HandleTable table, Text text)
{
    WorldStructure made(stream);
    World* const world = made.load();
    if (!world) return put(text, stream.text());
    const char* wrong = nullptr;
    WorldState states(*world);
    if (stream.left() >= 8)
        wrong = "it has more bytes than a world";
    else if (!states.prepare())
        wrong = kOutOfMemory;
    else
        wrong = states.set(state.data(), state.size(), with);
    if (wrong) {
        wrong = put(text, wrong);  // before its memory goes
        made.discard();
        return wrong;
    }
    table.write(made, 1);
    out = {world, made.space()};
    return nullptr;
}

// Height functions may change the world, so they are called before anything of it is saved.
const char* sample_heights(World& world, Space* space, HeightSamples& heights, Text text)
{
    Array<std::byte> none;
    ShapeStream stream(none, Use::kFile);
    WorldStructure found(world, space, stream);
    if (!found.gather()) return put(text, stream.text());
    for (const Geom* geom : found.geoms()) {
        if (geom->type->number != dHeightfieldClass) continue;
        const HeightfieldData* const data = static_cast<const ShapeGeom<Heightfield>*>(geom)->shape.field();
        if (data && !heights.take(*data)) return kOutOfMemory;
    }
    return nullptr;
}

}  // namespace

void HandleTable::write(const WorldStructure& from, int column) const
{
    int row = 0;
    const auto put_all = [&](const auto& objects) {
        for (const auto* object : objects) {
            if (row >= capacity) return;
            void*& place = column == 0 ? pairs[row].original : pairs[row].copy;
            place = to_handle(object);
            ++row;
        }
    };
    put_all(std::span<World* const>(&from.world(), 1));
    put_all(from.bodies()), put_all(from.joints()), put_all(from.geoms());
}

const char* clone_world(World& world, Space* space, WorldCopy& out, HandleTable table, char* text,
                        std::size_t text_size)
{
    const CopyMark mark(world);
    Array<std::byte> bytes;
    ShapeStream stream(bytes, Use::kClone);
    WorldStructure original(world, space, stream);
    if (original.gather()) original.save();
    if (stream.failed()) return put({text, text_size}, stream.text());
    const WorldState* const state = written_state(world, Seal::kUnsealed);
    if (!state) return kOutOfMemory;
    ShapeStream copy(bytes.span(), Use::kClone);
    const char* const wrong = build(copy, state->written(), Seal::kUnsealed, out, table, {text, text_size});
    if (!wrong) table.write(original, 0);
    return wrong;
}

const char* save_world(World& world, Space* space, Array<std::byte>& out, char* text, std::size_t text_size)
{
    const CopyMark mark(world);
    HeightSamples heights;
    if (const char* wrong = sample_heights(world, space, heights, {text, text_size})) return wrong;
    if (!out.resize(sizeof(WorldFileHeader))) return kOutOfMemory;
    ShapeStream stream(out, Use::kFile);
    stream.lend(heights);
    WorldStructure original(world, space, stream);
    if (original.gather()) original.save();
    if (stream.failed()) return put({text, text_size}, stream.text());
    const int padding = -out.size() & 7;
    if (!out.resize(out.size() + padding)) return kOutOfMemory;
    const std::size_t structure = std::size_t(out.size());
    if (const char* wrong = append_state(world, out)) return wrong;
    seal_file(out.span(), structure);
    return nullptr;
}

const char* load_world(std::span<const std::byte> file, WorldCopy& out, char* text, std::size_t text_size)
{
    WorldFileHeader header;
    if (const char* wrong = read_file_header(file, header, text, text_size)) return wrong;
    const std::span<const std::byte> structure = file.subspan(sizeof header, header.structure_size);
    const std::span<const std::byte> state =
        file.subspan(sizeof header + structure.size(), header.state_size);
    ShapeStream stream(structure, Use::kFile);
    stream.set_version(header.version);
    return build(stream, state, Seal::kSealed, out, {}, {text, text_size});
}

int count_handles(World& world, Space* space, char* text, std::size_t text_size)
{
    Array<std::byte> bytes;
    ShapeStream stream(bytes, Use::kClone);
    WorldStructure original(world, space, stream);
    if (!original.gather()) return put({text, text_size}, stream.text()), 0;
    return 1 + int(original.bodies().size() + original.joints().size() + original.geoms().size());
}

}  // namespace epode
