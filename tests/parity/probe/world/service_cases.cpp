// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Services: which handler is called with what, random sequences, printing and comparing matrices, opening and
// closing, configuration words, the working memory of steps, the shape of a timer report, self tests.
#include "case_list.h"

#include <algorithm>
#include <cctype>
#include <chrono>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <string>
#include <thread>
#include <vector>

namespace parity {
namespace {

double number(int x) { return static_cast<double>(x); }

std::vector<double> received;  // what handlers were called with

void* loud_alloc(dsizeint size)
{
    received.push_back(1);
    received.push_back(static_cast<double>(size));
    return std::malloc(size);
}

void* loud_realloc(void* p, dsizeint old_size, dsizeint new_size)
{
    received.push_back(2);
    received.push_back(static_cast<double>(old_size));
    received.push_back(static_cast<double>(new_size));
    return std::realloc(p, new_size);
}

void loud_free(void* p, dsizeint size)
{
    received.push_back(3);
    received.push_back(static_cast<double>(size));
    std::free(p);
}

void put_received(Output& out, const std::string& key)
{
    out.put(key, received.data(), static_cast<int>(received.size()));
    received.clear();
}

PARITY_CASE(service_memory)
{
    out.put("defaults", {dGetAllocHandler() ? 1.0 : 0.0, dGetReallocHandler() ? 1.0 : 0.0,
                         dGetFreeHandler() ? 1.0 : 0.0});
    char* plain = static_cast<char*>(dAlloc(100));
    std::memset(plain, 7, 100);
    plain = static_cast<char*>(dRealloc(plain, 100, 100000));
    out.put("kept", {number(plain[0]), number(plain[99])});
    dFree(plain, 100000);
    dFree(nullptr, 5);
    received.clear();
    dSetAllocHandler(loud_alloc);
    dSetReallocHandler(loud_realloc);
    dSetFreeHandler(loud_free);
    out.put("installed",
            {dGetAllocHandler() == loud_alloc ? 1.0 : 0.0, dGetReallocHandler() == loud_realloc ? 1.0 : 0.0,
             dGetFreeHandler() == loud_free ? 1.0 : 0.0});
    for (int i = 0; i < 20; ++i) {
        const dsizeint a = static_cast<dsizeint>(1 + rng.below(5000)),
                       b = static_cast<dsizeint>(1 + rng.below(5000));
        void* p = dAlloc(a);
        p = dRealloc(p, a, b);
        dFree(p, b);
        dFree(nullptr, a);
        put_received(out, "calls" + std::to_string(i));
    }
    dSetAllocHandler(nullptr);
    dSetReallocHandler(nullptr);
    dSetFreeHandler(nullptr);
    dFree(dRealloc(dAlloc(10), 10, 20), 20);
    put_received(out, "silent");
}

std::string said;

void record(int errnum, const char* msg, va_list ap)
{
    char text[200];
    std::vsnprintf(text, sizeof text, msg, ap);
    said += "[" + std::to_string(errnum) + ":" + text + "]";
}

PARITY_CASE(service_messages)
{
    dMessageFunction* const before = dGetMessageHandler();
    out.put("defaults", {dGetErrorHandler() ? 1.0 : 0.0, dGetDebugHandler() ? 1.0 : 0.0});
    dSetMessageHandler(record);
    dSetErrorHandler(record);
    dSetDebugHandler(record);
    out.put("installed",
            {dGetMessageHandler() == record ? 1.0 : 0.0, dGetErrorHandler() == record ? 1.0 : 0.0,
             dGetDebugHandler() == record ? 1.0 : 0.0});
    said.clear();
    dMessage(0, "plain");
    dMessage(7, "%s %d %.3f %%", "text", 42, 2.5);
    dMessage(-3, "%c%c", 'x', 'y');
    out.put_text("said", said);
    dSetErrorHandler(nullptr);
    dSetDebugHandler(nullptr);
    dSetMessageHandler(before);
}

PARITY_CASE(service_random_seeds)
{
    static const unsigned long seeds[] = {
        0, 1, 2, 0x7fffffffUL, 0x80000000UL, 0xffffffffUL, 0x100000000UL, 0x123456789abcdefUL};
    static const int limits[] = {1,   2,    3,     4,     5,     6,        7,         8,   9,
                                 15,  16,   17,    31,    32,    33,       255,       256, 257,
                                 258, 4095, 65535, 65536, 65537, 16777216, 2147483647};
    for (const unsigned long seed : seeds) {
        out.open_block("seed" + std::to_string(seed));
        dRandSetSeed(seed);
        out.put("kept", {static_cast<double>(dRandGetSeed())});
        for (int i = 0; i < 50; ++i) {
            const std::string k = std::to_string(i);
            out.put("rand" + k, {static_cast<double>(dRand())});
            out.put("real" + k, {dRandReal()});
            out.put("int" + k, {number(dRandInt(limits[i % 25]))});
        }
        out.put("test", {number(dTestRand())});
        out.put("after", {static_cast<double>(dRandGetSeed())});
    }
    for (int n = 1; n <= 40; ++n) {
        dRandSetSeed(static_cast<unsigned long>(n));
        double sum = 0, weighted = 0;
        for (int i = 0; i < 500; ++i) {
            const double r = dRandInt(n);
            sum += r;
            weighted += r * i;
        }
        out.put("sum" + std::to_string(n), {sum, weighted});
    }
    dReal v[10] = {0}, m[28];
    for (dReal& x : m) { x = 77; }
    dMakeRandomVector(v, 10, -3);
    dMakeRandomMatrix(m, 4, 5, 0.5);
    out.put("vector", v, 10);
    out.put("matrix", m, 28);
    dMakeRandomVector(v, 0, 3);
    dMakeRandomMatrix(m, 0, 3, 3);
    dMakeRandomMatrix(m, 3, 1, 3);
    out.put("column", m, 4);
}

std::string written(const std::function<void(FILE*)>& write)
{
    FILE* file = std::tmpfile();
    if (!file) { return "no temporary file"; }
    write(file);
    std::rewind(file);
    std::string text;
    for (int c; (c = std::fgetc(file)) != EOF;) {
        if (c == '\n') {
            text += "|";
        } else {
            text += static_cast<char>(c);
        }
    }
    std::fclose(file);
    return text;
}

PARITY_CASE(service_print_matrix)
{
    dReal a[40];
    for (dReal& x : a) { x = rng.range(-100, 100); }
    const int sizes[][2] = {{1, 1}, {3, 1}, {1, 3}, {2, 4}, {5, 5}, {3, 6}, {0, 3}, {2, 0}};
    for (const auto& size : sizes) {
        out.put_text("m" + std::to_string(size[0]) + "x" + std::to_string(size[1]),
                     written([&](FILE* f) { dPrintMatrix(a, size[0], size[1], "%10.4f ", f); }));
    }
}

PARITY_CASE(service_compare_matrices)
{
    for (int n = 0; n <= 12; ++n) {
        const int m = rng.below(13);
        std::vector<dReal> a(400), b(400);
        for (std::size_t i = 0; i < a.size(); ++i) {
            a[i] = rng.range(-1, 1);
            b[i] = a[i] + rng.range(-1e-3, 1e-3);
        }
        out.put("difference" + std::to_string(n), {dMaxDifference(a.data(), b.data(), n, m),
                                                   dMaxDifferenceLowerTriangle(a.data(), b.data(), n)});
        dClearUpperTriangle(a.data(), n);
        out.put("cleared" + std::to_string(n), a.data(), 200);
    }
}

PARITY_CASE(service_init)
{
    // The probe has opened the library once already.
    out.put("open", {number(dInitODE2(0)), number(dInitODE2(dInitFlagManualThreadCleanup))});
    out.put("thread", {number(dAllocateODEDataForThread(dAllocateFlagBasicData)),
                       number(dAllocateODEDataForThread(dAllocateFlagCollisionData)),
                       number(dAllocateODEDataForThread(static_cast<unsigned>(dAllocateMaskAll)))});
    dCleanupODEAllDataForThread();
    dCleanupODEAllDataForThread();
    out.put("again", {number(dAllocateODEDataForThread(static_cast<unsigned>(dAllocateMaskAll)))});
    dInitODE();
    dCloseODE();
    dCloseODE();
    dCloseODE();
    const dGeomID a = dCreateSphere(nullptr, 1), b = dCreateSphere(nullptr, 1);
    dContactGeom contact;
    out.put("still-open", {number(dCollide(a, b, 1, &contact, sizeof contact))});
    dGeomDestroy(a);
    dGeomDestroy(b);
}

PARITY_CASE(service_configuration)
{
    const char* tokens[] = {"ODE",
                            "ODE_double_precision",
                            "ODE_single_precision",
                            "ODE_EXT_no_debug",
                            "ode",
                            "ODE_EXT",
                            "ODE_double",
                            "double_precision",
                            "precision",
                            "ODE_double_precision2",
                            "ODE_EXT_trimesh",
                            "ODE_EXT_gimpact",
                            "ODE_EXT_opcode",
                            "ODE_OPC_new_collider",
                            "ODE_OPC_old_collider",
                            "ODE_EXT_mt_collisions",
                            "",
                            " ",
                            "ODE ODE_EXT_trimesh",
                            "no such words",
                            "ODE_OPC_16bit_indices"};
    for (const char* token : tokens) { out.put(token, {number(dCheckConfiguration(token))}); }
    const std::string all = dGetConfiguration();
    out.put_text("all", all);
    // Every word of the text is one that is found.
    int unknown = 0;
    for (std::size_t at = 0; at < all.size();) {
        const std::size_t end = std::min(all.find(' ', at), all.size());
        unknown += dCheckConfiguration(all.substr(at, end - at).c_str()) != 1;
        at = end + 1;
    }
    out.put("unknown-words", {number(unknown)});
}

// Digits become 0, so that the lay-out is compared and not the time.
std::string shape_of(std::string text)
{
    for (char& c : text) {
        if (std::isdigit(static_cast<unsigned char>(c))) { c = '0'; }
    }
    return text;
}

// More than the coarser of the two clocks shows, so that no share is nothing divided by nothing.
void wait_a_little() { std::this_thread::sleep_for(std::chrono::milliseconds(1)); }

PARITY_CASE(service_timer)
{
    for (int average = 0; average < 2; ++average) {
        dTimerStart("first");
        wait_a_little();
        dTimerNow("a much longer name");
        wait_a_little();
        dTimerNow("b");
        wait_a_little();
        dTimerEnd();
        std::string report = shape_of(written([average](FILE* f) { dTimerReport(f, average); }));
        // The clocks of the two libraries resolve differently; shares of nothing vary in width.
        report = report.substr(report.find(")|"));
        report = report.substr(0, report.find("(avg", report.find("TOTAL")));  // the original has none
        std::string words;
        for (const char c : report) {
            if (c != ' ' && c != '0' && c != '.') { words += c; }
        }
        while (words.ends_with('|')) { words.pop_back(); }
        out.put_text("report" + std::to_string(average), words);
    }
    dStopwatch watch;
    dStopwatchReset(&watch);
    out.put("reset", {dStopwatchTime(&watch)});
    dStopwatchStart(&watch);
    dStopwatchStop(&watch);
    out.put("small", {dStopwatchTime(&watch) >= 0 && dStopwatchTime(&watch) < 1 ? 1.0 : 0.0});
}

// ---- working memory of steps ----

int open_blocks, misfits;
std::vector<std::pair<void*, dsizeint>> blocks;

void* take_block(dsizeint size)
{
    void* p = std::malloc(size);
    blocks.emplace_back(p, size);
    ++open_blocks;
    return p;
}

void* shrink_block(void* p, dsizeint, dsizeint) { return p; }

void give_block(void* p, dsizeint size)
{
    --open_blocks;
    bool found = false;
    for (auto& [block, wanted] : blocks) {
        if (block != p) { continue; }
        found = wanted == size;
        block = nullptr;
    }
    misfits += !found;
    std::free(p);
}

dWorldID chain(int length, Random& random)
{
    const dWorldID w = dWorldCreate();
    dWorldSetGravity(w, 0, 0, -9.81);
    dBodyID last = nullptr;
    for (int i = 0; i < length; ++i) {
        const dBodyID body = dBodyCreate(w);
        dBodySetPosition(body, i, random.range(-0.1, 0.1), 0);
        const dJointID joint = dJointCreateBall(w, nullptr);
        dJointAttach(joint, body, last);
        dJointSetBallAnchor(joint, i - 0.5, 0, 0);
        last = body;
    }
    return w;
}

PARITY_CASE(service_step_memory)
{
    const dWorldStepMemoryFunctionsInfo manager = {sizeof manager, take_block, shrink_block, give_block};
    const dWorldStepReserveInfo policy = {sizeof policy, 2.0F, 1000}, larger = {sizeof larger + 8, 1.0F, 0};
    const dWorldID w = chain(10, rng), other = chain(3, rng), third = chain(2, rng);
    open_blocks = misfits = 0;
    out.put("null", {number(dWorldSetStepMemoryReservationPolicy(third, nullptr)),
                     number(dWorldSetStepMemoryManager(third, nullptr)),
                     number(dWorldUseSharedWorkingMemory(third, nullptr))});
    out.put("set", {number(dWorldSetStepMemoryReservationPolicy(w, &policy)),
                    number(dWorldSetStepMemoryReservationPolicy(w, &larger)),
                    number(dWorldSetStepMemoryManager(w, &manager))});
    out.put("share", {number(dWorldUseSharedWorkingMemory(other, w)),
                      number(dWorldUseSharedWorkingMemory(third, other))});
    out.put("before", {number(open_blocks)});
    out.put("step", {number(dWorldStep(w, 0.01)), open_blocks > 0 ? 1.0 : 0.0});
    dWorldCleanupWorkingMemory(other);
    out.put("cleaned", {number(open_blocks)});
    out.put("steps", {number(dWorldStep(w, 0.01)), number(dWorldQuickStep(other, 0.01)),
                      number(dWorldStep(third, 0.01)), open_blocks > 0 ? 1.0 : 0.0});
    dWorldDestroy(w);
    out.put("first-gone", {open_blocks > 0 ? 1.0 : 0.0});
    out.put("drop", {number(dWorldUseSharedWorkingMemory(other, nullptr)), open_blocks > 0 ? 1.0 : 0.0});
    dWorldDestroy(third);
    out.put("last-gone", {number(open_blocks), number(misfits)});
    out.put("new", {number(dWorldStep(other, 0.01)), number(open_blocks)});
    dWorldCleanupWorkingMemory(other);
    dWorldCleanupWorkingMemory(other);
    dWorldDestroy(other);
    out.put("end", {number(open_blocks), number(misfits)});
}

}  // namespace
}  // namespace parity
