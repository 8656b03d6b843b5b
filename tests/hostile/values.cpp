// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "values.h"

#include <cstdint>
#include <cstdio>
#include <cstring>

#include "value_lists.h"

namespace hostile {
namespace {

// ---- where handles do not belong ----

alignas(64) char g_zeros[256];
alignas(64) char g_letters[256];

struct Wrong {
    void* pointer;
    const char* text;
};

void* bits(std::uintptr_t value) { return reinterpret_cast<void*>(value); }
void* inside(void* object, std::size_t at) { return static_cast<char*>(object) + at; }

template <typename Table>
Value from_integers(const Table& table, int index)
{
    Value v;
    const Integer& i = table[std::size_t(index)];
    v.integer = i.value;
    v.text = i.text;
    v.trait = index == 0 ? Trait::kFine : Trait::kStrange;
    return v;
}

Value null_value()
{
    Value v;
    v.pointer = nullptr;
    v.trait = Trait::kNull;
    v.text = "null";
    return v;
}

void (*function_of(Kind kind))()
{
    switch (kind) {
        case Kind::kNearCallback:
            return reinterpret_cast<void (*)()>(near_nothing);
        case Kind::kContactFilter:
            return reinterpret_cast<void (*)()>(any_pair);
        case Kind::kHeightCallback:
            return reinterpret_cast<void (*)()>(flat_height);
        case Kind::kManifoldFunction:
            return reinterpret_cast<void (*)()>(same_manifold);
        case Kind::kFluidSurface:
            return reinterpret_cast<void (*)()>(flat_sea);
        case Kind::kFluidCurrent:
            return reinterpret_cast<void (*)()>(no_current);
        case Kind::kCollider:
            return reinterpret_cast<void (*)()>(no_contacts);
        case Kind::kReadyCallback:
            return reinterpret_cast<void (*)()>(ready_nothing);
        case Kind::kMovedCallback:
            return reinterpret_cast<void (*)()>(moved_nothing);
        case Kind::kMessageFunction:
            return reinterpret_cast<void (*)()>(dGetMessageHandler());
        case Kind::kAllocFunction:
            return reinterpret_cast<void (*)()>(dGetAllocHandler());
        case Kind::kTriCallback:
            return reinterpret_cast<void (*)()>(any_triangle);
        case Kind::kTriArrayCallback:
            return reinterpret_cast<void (*)()>(any_triangles);
        case Kind::kTriRayCallback:
            return reinterpret_cast<void (*)()>(any_hit);
        case Kind::kTriMergeCallback:
            return reinterpret_cast<void (*)()>(first_triangle);
        case Kind::kReallocFunction:
            return reinterpret_cast<void (*)()>(dGetReallocHandler());
        default:
            return reinterpret_cast<void (*)()>(dGetFreeHandler());
    }
}

bool is_function(Kind kind) { return int(kind) >= int(Kind::kMessageFunction); }

std::FILE* nowhere()
{
    static std::FILE* const file = std::fopen("/dev/null", "w");
    return file;
}

// What the world's state is now, its difference from itself, or a buffer for one.
void* state_of(dWorldID world, Kind kind)
{
    static std::array<unsigned char, kStateBuffer> whole, delta, buffer;
    if (kind == Kind::kStateBuffer) return buffer.data();
    (void)dWorldGetState(world, whole.data(), whole.size());
    if (kind == Kind::kState) return whole.data();
    (void)dWorldGetStateDelta(world, whole.data(), whole.size(), delta.data(), delta.size());
    return delta.data();
}

// A world of one body, as bytes and as a file to be loaded, and the name of one to be saved.
struct WorldFile {
    std::array<unsigned char, kStateBuffer> bytes{};
    const char* const loaded = "hostile_loaded.epw";
    const char* const saved = "hostile_saved.epw";
    WorldFile()
    {
        const dWorldID world = dWorldCreate();
        dBodyCreate(world);
        (void)dWorldSaveToBuffer(world, nullptr, bytes.data(), bytes.size());
        (void)dWorldSave(world, nullptr, loaded);
        dWorldDestroy(world);
    }
    ~WorldFile() { std::remove(loaded), std::remove(saved); }
    WorldFile(const WorldFile&) = delete;
    WorldFile& operator=(const WorldFile&) = delete;
};

WorldFile& world_file()
{
    static WorldFile file;
    return file;
}

constexpr std::size_t kMostContacts = 65536;
constexpr int kWrongHandles = 15, kHandleLists = 3;

}  // namespace

const char* name_of(Kind kind)
{
    static constexpr const char* kNames[] = {"world",       "body",         "joint",     "group",     "geom",
                                             "space",       "heights",      "fluid",     "threading", "pool",
                                             "cooperative", "requirements", "container", "triangles"};
    return is_handle(kind) ? kNames[int(kind)] : "";
}

int Values::count(Kind kind)
{
    if (is_handle(kind)) return int(scene_.live[std::size_t(kind)].size()) + kWrongHandles;
    if (is_function(kind)) return 2;
    switch (kind) {
        case Kind::kReal:
            return int(std::size(kReals));
        case Kind::kInt:
            return int(std::size(kInts));
        case Kind::kSize:
            return int(std::size(kSizes));
        case Kind::kBufferSize:
            return int(std::size(kBufferSizes));
        case Kind::kParameterNumber:
            return int(std::size(kParameters));
        case Kind::kLength:
            return int(std::size(kLengths));
        case Kind::kSampleCount:
            return int(std::size(kSampleCounts));
        case Kind::kContactFlags:
            return int(std::size(kContactFlags));
        case Kind::kSkip:
            return int(std::size(kSkips));
        case Kind::kStructSize:
            return int(std::size(kStructSizes));
        case Kind::kThreadCount:
            return int(std::size(kThreadCounts));
        case Kind::kBehaviour:
            return int(std::size(kBehaviours));
        case Kind::kFaceCount:
            return int(std::size(kFaceCounts));
        case Kind::kPointCount:
            return int(std::size(kPointCounts));
        case Kind::kVertexStride:
            return int(std::size(kVertexStrides));
        case Kind::kVertexCount:
            return int(std::size(kVertexCounts));
        case Kind::kTriangleStride:
            return int(std::size(kTriangleStrides));
        case Kind::kCornerCount:
            return int(std::size(kCornerCounts));
        case Kind::kVertices:
            return int(vertices().size()) + 1;
        case Kind::kCorners:
            return int(corners().size()) + 1;
        case Kind::kExtraData:
            return int(extra_data().size()) + 1;
        case Kind::kFacePlanes:
            return int(face_planes().size()) + 1;
        case Kind::kFacePoints:
            return int(face_points().size()) + 1;
        case Kind::kFaces:
            return int(faces().size()) + 1;
        case Kind::kThreadingFunctions:
            return int(threading_functions().size()) + 1;
        case Kind::kReserveInfo:
            return int(reserve_infos().size()) + 1;
        case Kind::kMemoryFunctions:
            return int(memory_functions().size()) + 1;
        case Kind::kMass:
            return int(masses().size()) + 1;
        case Kind::kMaterial:
            return int(materials().size()) + 1;
        case Kind::kQueryFilter:
            return int(filters().size()) + 1;
        case Kind::kDrive:
            return int(drives().size()) + 1;
        case Kind::kDriveBuffer:
            return int(reports<dDrive>().size()) + 1;
        case Kind::kEventSettings:
            return int(event_settings().size()) + 1;
        case Kind::kEventSettingsBuffer:
            return int(reports<dEventSettings>().size()) + 1;
        case Kind::kCharacterSettings:
            return int(character_settings().size()) + 1;
        case Kind::kCharacterSettingsBuffer:
            return int(reports<dCharacterSettings>().size()) + 1;
        case Kind::kCharacterReport:
            return int(reports<dCharacterReport>().size()) + 1;
        case Kind::kFluidSettings:
            return int(fluid_settings().size()) + 1;
        case Kind::kFluidSettingsBuffer:
            return int(reports<dFluidSettings>().size()) + 1;
        case Kind::kVehicleSettings:
            return int(vehicle_settings().size()) + 1;
        case Kind::kVehicleSettingsBuffer:
            return int(reports<dVehicleSettings>().size()) + 1;
        case Kind::kVehicleWheel:
            return int(vehicle_wheels().size()) + 1;
        case Kind::kVehicleWheelBuffer:
            return int(reports<dVehicleWheel>().size()) + 1;
        case Kind::kVehicleControls:
            return int(vehicle_controls().size()) + 1;
        case Kind::kVehicleControlsBuffer:
            return int(reports<dVehicleControls>().size()) + 1;
        case Kind::kVehicleReport:
            return int(reports<dVehicleReport>().size()) + 1;
        case Kind::kVehicleWheelReport:
            return int(reports<dVehicleWheelReport>().size()) + 1;
        case Kind::kBones:
            return int(bone_lists().size()) + 1;
        case Kind::kBoneBuffer:
            return int(bone_buffers().size()) + 1;
        case Kind::kPose:
            return int(poses().size()) + 1;
        case Kind::kRopeSettings:
            return int(rope_settings().size()) + 1;
        case Kind::kFractureParts:
            return int(part_lists(scene_).size()) + 1;
        case Kind::kFractures:
            return int(fracture_lists(scene_).size()) + 1;
        case Kind::kContact:
            return int(hostile::contacts().size()) + 1;
        case Kind::kGeomClass:
            return int(classes().size()) + 1;
        case Kind::kWorldReport:
        case Kind::kIslandReport:
            return int(reports<dWorldStepReport>().size()) + 1;
        case Kind::kLedger:
            return int(reports<dEnergyLedger>().size()) + 1;
        case Kind::kWorldList:
        case Kind::kBodyList:
        case Kind::kJointHandles:
            return kHandleLists + 1;
        case Kind::kText:
            return int(texts(false).size()) + 1;
        case Kind::kSavePath:
        case Kind::kLoadPath:
            return int(paths("").size()) + 1;
        case Kind::kFormat:
            return int(texts(true).size()) + 1;
        case Kind::kIndices:
            return int(indices().size()) + 1;
        case Kind::kIntPointer:
            return int(pointed_ints().size()) + 1;
        case Kind::kBytes:
        case Kind::kShorts:
            return int(samples<short>().size()) + 1;
        case Kind::kFloats:
        case Kind::kDoubles:
            return int(samples<double>().size()) + 1;
        case Kind::kFaceBuffer:
        case Kind::kSizePointer:
        case Kind::kBytesPointer:
        case Kind::kRows:
        case Kind::kContacts:
        case Kind::kQueryHits:
        case Kind::kStopwatch:
        case Kind::kFile:
        case Kind::kData:
        case Kind::kControl:
        case Kind::kState:
        case Kind::kStateDelta:
        case Kind::kStateBuffer:
        case Kind::kWorldFile:
        case Kind::kSpacePointer:
        case Kind::kBlock:
        case Kind::kJointList:
        case Kind::kFeedback:
            return 2;
        default:
            return int(arrays(kind).size()) + 1;
    }
}

Value Values::handle(Kind kind, int index) const
{
    const auto& live = scene_.live[std::size_t(kind)];
    Value v;
    if (index < int(live.size())) {
        v.pointer = live[std::size_t(index)];
        v.text = "live";
        return v;
    }
    const auto other = [&](Kind k) { return scene_.live[std::size_t(k)][0]; };
    const Wrong wrong[kWrongHandles] = {
        {nullptr, "null"},
        {scene_.dead[std::size_t(kind)], "destroyed"},
        {other(Kind::kWorld), "world"},
        {other(Kind::kBody), "body"},
        {other(Kind::kJoint), "joint"},
        {other(Kind::kGroup), "group"},
        {other(Kind::kGeom), "geom"},
        {other(Kind::kSpace), "space"},
        {other(Kind::kHeightfieldData), "heights"},
        {g_zeros, "zeros"},
        {g_letters, "letters"},
        {inside(live.empty() ? other(Kind::kWorld) : live[0], 8), "8 bytes into an object"},
        {bits(1), "1"},
        {bits(64), "64"},
        {bits(~std::uintptr_t(0)), "-1"}};
    g_letters[0] = 'x';
    const int which = index - int(live.size());
    v.pointer = wrong[which].pointer;
    v.text = wrong[which].text;
    v.trait = which == 0 ? Trait::kNull : Trait::kBad;
    // Objects of the right kind after all: of the scene, and spaces, which are geoms.
    const bool right = which >= 2 && which < 9 && which - 2 == int(kind);
    if (right || (kind == Kind::kGeom && which == 7)) v.trait = Trait::kStrange;
    return v;
}

Value Values::get(Kind kind, int index, int position)
{
    Value v;
    if (is_handle(kind)) return handle(kind, index);
    if (is_function(kind)) {
        if (index == 1) return null_value();
        v.function = function_of(kind);
        v.text = "function";
        return v;
    }
    switch (kind) {
        case Kind::kReal:
            v.real = kReals[index].value;
            v.trait = kReals[index].trait;
            v.text = kReals[index].text;
            return v;
        case Kind::kInt:
            return from_integers(kInts, index);
        case Kind::kSize:
            return from_integers(kSizes, index);
        case Kind::kBufferSize:
            return from_integers(kBufferSizes, index);
        case Kind::kParameterNumber:
            return from_integers(kParameters, index);
        case Kind::kLength:
            return from_integers(kLengths, index);
        case Kind::kSampleCount:
            return from_integers(kSampleCounts, index);
        case Kind::kContactFlags:
            return from_integers(kContactFlags, index);
        case Kind::kSkip:
            return from_integers(kSkips, index);
        case Kind::kStructSize:
            return from_integers(kStructSizes, index);
        case Kind::kThreadCount:
            return from_integers(kThreadCounts, index);
        case Kind::kBehaviour:
            return from_integers(kBehaviours, index);
        case Kind::kVertexStride:
            return from_integers(kVertexStrides, index);
        case Kind::kVertexCount:
            return from_integers(kVertexCounts, index);
        case Kind::kTriangleStride:
            return from_integers(kTriangleStrides, index);
        case Kind::kCornerCount:
            return from_integers(kCornerCounts, index);
        case Kind::kFaceCount:
            return from_integers(kFaceCounts, index);
        case Kind::kPointCount:
            return from_integers(kPointCounts, index);
        default:
            break;
    }
    if (index == count(kind) - 1) return null_value();
    return memory(kind, index, position);
}

// A block is taken from the library for each value, and given back by the call.
Trait Values::trait(Kind kind, int index)
{
    if (kind == Kind::kBlock) return index == 0 ? Trait::kFine : Trait::kNull;
    return get(kind, index, 0).trait;
}

void* Values::fill(Kind kind, int position, const void* content, std::size_t size)
{
    Block& block = blocks_[{int(kind), position}];
    if (block.size != size) {
        block.size = size;
        block.data = std::make_unique<char[]>(size);
        block.filled = std::make_unique<char[]>(size);
    }
    std::memcpy(block.data.get(), content, size);
    std::memcpy(block.filled.get(), content, size);
    return block.data.get();
}

bool Values::untouched(Kind kind, int position, const Value& value) const
{
    const auto found = blocks_.find({int(kind), position});
    if (found == blocks_.end() || found->second.data.get() != value.pointer) return true;
    const Block& b = found->second;
    return std::memcmp(b.data.get(), b.filled.get(), b.size) == 0;
}

Value Values::memory(Kind kind, int index, int position)
{
    Value v;
    v.text = "room";
    const auto item = [&](const auto& list) {
        const auto& chosen = list[std::size_t(index)];
        v.trait = chosen.trait;
        v.text = chosen.text;
        v.pointer = fill(kind, position, &chosen.value, sizeof chosen.value);
        return v;
    };
    static const std::array<char, 4096> kZeros{};
    switch (kind) {
        case Kind::kMass:
            return item(masses());
        case Kind::kMaterial:
            return item(materials());
        case Kind::kQueryFilter:
            return item(filters());
        case Kind::kDrive:
            return item(drives());
        case Kind::kDriveBuffer:
            return item(reports<dDrive>());
        case Kind::kEventSettings:
            return item(event_settings());
        case Kind::kEventSettingsBuffer:
            return item(reports<dEventSettings>());
        case Kind::kCharacterSettings:
            return item(character_settings());
        case Kind::kCharacterSettingsBuffer:
            return item(reports<dCharacterSettings>());
        case Kind::kCharacterReport:
            return item(reports<dCharacterReport>());
        case Kind::kFluidSettings:
            return item(fluid_settings());
        case Kind::kFluidSettingsBuffer:
            return item(reports<dFluidSettings>());
        case Kind::kVehicleSettings:
            return item(vehicle_settings());
        case Kind::kVehicleSettingsBuffer:
            return item(reports<dVehicleSettings>());
        case Kind::kVehicleWheel:
            return item(vehicle_wheels());
        case Kind::kVehicleWheelBuffer:
            return item(reports<dVehicleWheel>());
        case Kind::kVehicleControls:
            return item(vehicle_controls());
        case Kind::kVehicleControlsBuffer:
            return item(reports<dVehicleControls>());
        case Kind::kVehicleReport:
            return item(reports<dVehicleReport>());
        case Kind::kVehicleWheelReport:
            return item(reports<dVehicleWheelReport>());
        case Kind::kBones:
            return item(bone_lists());
        case Kind::kBoneBuffer:
            return item(bone_buffers());
        case Kind::kPose:
            return item(poses());
        case Kind::kRopeSettings:
            return item(rope_settings());
        case Kind::kFractureParts:
            return item(part_lists(scene_));
        case Kind::kFractures:
            return item(fracture_lists(scene_));
        case Kind::kContact:
            return item(hostile::contacts());
        case Kind::kGeomClass:
            return item(classes());
        case Kind::kWorldReport:
            return item(reports<dWorldStepReport>());
        case Kind::kThreadingFunctions:
            return item(threading_functions());
        case Kind::kReserveInfo:
            return item(reserve_infos());
        case Kind::kMemoryFunctions:
            return item(memory_functions());
        case Kind::kIslandReport:
            return item(reports<dIslandStepReport>());
        case Kind::kLedger:
            return item(reports<dEnergyLedger>());
        case Kind::kIndices:
            return item(indices());
        case Kind::kIntPointer:
            return item(pointed_ints());
        case Kind::kBytes:
            return item(samples<unsigned char>());
        case Kind::kShorts:
            return item(samples<short>());
        case Kind::kFloats:
            return item(samples<float>());
        case Kind::kDoubles:
            return item(samples<double>());
        case Kind::kVertices:
            return item(vertices());
        case Kind::kCorners:
            return item(corners());
        case Kind::kExtraData:
            return item(extra_data());
        case Kind::kFacePlanes:
            return item(face_planes());
        case Kind::kFacePoints:
            return item(face_points());
        case Kind::kFaces:
            return item(faces());
        case Kind::kText:
        case Kind::kSavePath:
        case Kind::kLoadPath:
        case Kind::kFormat: {
            const auto& list = kind == Kind::kSavePath   ? paths(world_file().saved)
                               : kind == Kind::kLoadPath ? paths(world_file().loaded)
                                                         : texts(kind == Kind::kFormat);
            const auto& chosen = list[std::size_t(index)];
            v.pointer = const_cast<char*>(chosen.value);
            v.trait = chosen.trait;
            v.text = chosen.text;
            return v;
        }
        case Kind::kFaceBuffer:
            v.pointer = fill(kind, position, kZeros.data(), sizeof(Solid::faces));
            return v;
        case Kind::kSizePointer:
        case Kind::kBytesPointer:
            v.pointer = fill(kind, position, kZeros.data(), sizeof(void*));
            return v;
        case Kind::kStopwatch:
            v.pointer = fill(kind, position, kZeros.data(), sizeof(dStopwatch));
            return v;
        case Kind::kFeedback:
            v.pointer = fill(kind, position, kZeros.data(), sizeof(dJointFeedback));
            return v;
        case Kind::kQueryHits:
            v.pointer = fill(kind, position, kZeros.data(), kZeros.size());
            return v;
        case Kind::kWorldList:
        case Kind::kBodyList:
        case Kind::kJointHandles: {
            const Kind of = kind == Kind::kWorldList  ? Kind::kWorld
                            : kind == Kind::kBodyList ? Kind::kBody
                                                      : Kind::kJoint;
            const auto& live = scene_.live[std::size_t(of)];
            void* const dead = scene_.dead[std::size_t(of)];
            void* const lists[kHandleLists][8] = {
                {live[0], live[1]}, {live[0], live[0], live[0]}, {live[0], dead}};
            v.trait = index == 0 ? Trait::kFine : Trait::kStrange;
            v.pointer = fill(kind, position, lists[index], sizeof lists[index]);
            return v;
        }
        case Kind::kJointList:
            v.pointer = fill(kind, position, kZeros.data(), 256 * sizeof(dJointID));
            return v;
        case Kind::kControl:
            v.pointer = fill(kind, position, kZeros.data(), 16);
            return v;
        case Kind::kData:
            v.pointer = g_letters;
            return v;
        case Kind::kSpacePointer:
            static void* space;
            space = scene_.live[std::size_t(Kind::kSpace)][0];
            v.pointer = &space;
            return v;
        case Kind::kWorldFile:
            v.pointer = world_file().bytes.data();
            return v;
        case Kind::kState:
        case Kind::kStateDelta:
        case Kind::kStateBuffer:
            v.pointer = state_of(static_cast<dWorldID>(scene_.live[std::size_t(Kind::kWorld)][0]), kind);
            return v;
        case Kind::kFile:
            v.pointer = nowhere();
            return v;
        case Kind::kBlock:
            v.pointer = dAlloc(64);
            return v;
        case Kind::kContacts: {
            static const auto contacts = std::make_unique<dContact[]>(kMostContacts);
            v.pointer = contacts.get();
            return v;
        }
        case Kind::kRows: {
            static dReal rows[8][8] = {};
            static dReal* const pointers[8] = {rows[0], rows[1], rows[2], rows[3],
                                               rows[4], rows[5], rows[6], rows[7]};
            v.pointer = fill(kind, position, pointers, sizeof pointers);
            return v;
        }
        default:
            break;
    }
    const Array& chosen = arrays(kind)[std::size_t(index)];
    v.trait = chosen.trait;
    v.text = chosen.text.c_str();
    v.pointer = fill(kind, position, chosen.values.data(), chosen.values.size() * sizeof(dReal));
    return v;
}

}  // namespace hostile
