// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// random_sequences [--operations N] [--seed S] [--first SEQUENCE] [--save FILE] [--plant]
// Plays random sequences of calls until N operations are done, each sequence from dInitODE to dCloseODE, with
// memory handlers that keep count: what is not given back by then is a leak. A sequence runs in a child
// process, so that a crash, a sanitizer's report or a hang is a failure like any other. The first one that
// fails is cut down (delta debugging, Zeller and Hildebrandt 2002) and written to FILE as a C program.
// --first begins with that sequence of the seed, to come back to one that failed.
// --plant lets the model make a mistake, to show that mistakes are found.
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <sstream>

#include "player.h"

namespace epode::sequences {
namespace {

std::atomic<long> g_blocks{0};  // held by the library

void* counted_alloc(dsizeint size)
{
    void* p = std::malloc(size);
    if (p) ++g_blocks;
    return p;
}
void* counted_realloc(void* p, dsizeint, dsizeint size) { return std::realloc(p, size); }
void counted_free(void* p, dsizeint)
{
    --g_blocks;
    std::free(p);
}

using Operations = std::vector<std::uint64_t>;

struct Settings {
    long operations = 20000;
    std::uint64_t seed = 1;
    long first = 0;
    const char* save = "failed_sequence.c";
    bool plant = false;
};

struct Tally {  // shared with the children
    long operations, refused, sequences;
    long current;  // number of the sequence in play
    long reached;  // operation of it that was begun last
    char complaint[256];
};

std::string toolbox()
{
    std::ifstream file(SEQUENCES_TOOLBOX);
    std::stringstream all;
    all << file.rdbuf();
    return all.str();
}

// One sequence from beginning to end.
bool play(const Operations& operations, bool plant, Tally* tally, std::FILE* record)
{
    dSetAllocHandler(counted_alloc);
    dSetReallocHandler(counted_realloc);
    dSetFreeHandler(counted_free);
    dInitODE2(0);
    std::string complaint;
    {
        Player player;
        player.script.record = record;
        player.model.forgetful = plant;
        bool good = true;
        for (std::size_t i = 0; good && i < operations.size(); ++i) {
            if (tally) tally->reached = long(i);
            good = player.play(operations[i]);
        }
        good = good && player.check() && player.tear_down(operations.empty() ? 1 : operations[0]);
        complaint = player.complaint();
        if (tally) tally->operations += player.calls, tally->refused += player.refused, ++tally->sequences;
    }
    dCloseODE();
    if (complaint.empty() && g_blocks != 0) complaint = std::to_string(g_blocks) + " blocks of memory leak";
    if (tally && !complaint.empty())
        std::snprintf(tally->complaint, sizeof tally->complaint, "%s", complaint.c_str());
    return complaint.empty();
}

bool g_quiet = false;

// Runs `work` in a child; true when that ended well.
template <typename Work>
bool in_child(bool quiet, unsigned seconds, Work&& work)
{
    std::fflush(nullptr);
    const pid_t child = fork();
    if (child < 0) return false;
    if (child == 0) {
        g_quiet = quiet;
        if (quiet && !(std::freopen("/dev/null", "w", stderr))) _exit(3);
        alarm(seconds);  // a hang is a failure
        std::exit(work() ? 0 : 1);
    }
    int status = 0;
    waitpid(child, &status, 0);
    return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

Operations sequence(std::uint64_t seed, long number)
{
    Dice dice(seed * 0x2545f4914f6cdd1du + std::uint64_t(number));
    static constexpr int kLengths[] = {50, 200, 1000, 4000};
    Operations operations(static_cast<std::size_t>(kLengths[dice.below(4)]));
    for (auto& op : operations) op = dice.next();
    return operations;
}

bool fails(const Operations& operations, bool plant)
{
    return !in_child(true, 30, [&] { return play(operations, plant, nullptr, nullptr); });
}

// Leaves out ever smaller pieces as long as what remains still fails.
Operations shrink(Operations operations, bool plant)
{
    for (std::size_t piece = operations.size() / 2; piece > 0;) {
        bool shorter = false;
        for (std::size_t at = 0; at < operations.size();) {
            Operations tried(operations.begin(), operations.begin() + long(at));
            const std::size_t after = std::min(at + piece, operations.size());
            tried.insert(tried.end(), operations.begin() + long(after), operations.end());
            if (!tried.empty() && fails(tried, plant)) {
                operations.swap(tried);
                shorter = true;
            } else {
                at += piece;
            }
        }
        if (!shorter || piece > operations.size()) piece = std::min(piece / 2, operations.size());
    }
    return operations;
}

std::string text_of(std::FILE* file)
{
    std::string all;
    std::rewind(file);
    for (int c; (c = std::fgetc(file)) != EOF;) all += char(c);
    return all;
}

void save_program(const Operations& operations, const Settings& settings, Tally& tally)
{
    std::FILE* record = std::tmpfile();
    if (!record) return;
    std::setvbuf(record, nullptr, _IONBF, 0);
    tally.complaint[0] = '\0';
    in_child(false, 30, [&] { return play(operations, settings.plant, &tally, record); });
    const char* why = tally.complaint[0] ? tally.complaint : "ends the program, or never ends";
    std::ofstream(settings.save) << Script::program(toolbox(), why, text_of(record));
    std::fclose(record);
    std::printf("%s\n%d operations remain of it, in C: %s\n", why, int(operations.size()), settings.save);
}

bool play_all(const Settings& settings, Tally& tally)
{
    return in_child(false, 7200, [&] {
        for (; tally.operations < settings.operations; ++tally.current)
            if (!play(sequence(settings.seed, tally.current), settings.plant, &tally, nullptr)) return false;
        return true;
    });
}

Settings read(int count, char** words)
{
    Settings settings;
    for (int i = 1; i < count; ++i) {
        const std::string word = words[i];
        const char* value = i + 1 < count ? words[i + 1] : "0";
        if (word == "--plant") {
            settings.plant = true;
            continue;
        }
        if (word == "--operations") settings.operations = std::atol(value);
        if (word == "--seed") settings.seed = std::strtoull(value, nullptr, 10);
        if (word == "--first") settings.first = std::atol(value);
        if (word == "--save") settings.save = value;
        ++i;
    }
    return settings;
}

int run(const Settings& settings)
{
    void* memory = mmap(nullptr, sizeof(Tally), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (memory == MAP_FAILED) return 2;
    Tally& tally = *new (memory) Tally{};
    tally.current = settings.first;
    const bool good = play_all(settings, tally);
    std::printf("%ld operations in %ld sequences, %ld of them refused as the rules want\n", tally.operations,
                tally.sequences, tally.refused);
    if (good) return 0;
    std::printf("sequence %ld of seed %llu fails: %s\n", tally.current, (unsigned long long)settings.seed,
                tally.complaint);
    // What follows the failure cannot have caused it, unless it shows only at the end.
    Operations whole = sequence(settings.seed, tally.current), part(whole);
    part.resize(std::size_t(tally.reached) + 1);
    save_program(shrink(fails(part, settings.plant) ? part : whole, settings.plant), settings, tally);
    return 1;
}

}  // namespace
}  // namespace epode::sequences

// The address sanitizer's report takes a second to write, and nobody reads that of a try.
extern "C" void __asan_on_error()
{
    if (epode::sequences::g_quiet) _exit(3);
}

int main(int count, char** words) { return epode::sequences::run(epode::sequences::read(count, words)); }
