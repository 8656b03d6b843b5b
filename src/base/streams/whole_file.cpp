// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "base/streams/whole_file.h"

#include <cerrno>
#include <climits>
#include <cstdio>
#include <cstring>

#include "base/check.h"
#include "base/streams/file_calls.h"

namespace epode {
namespace {

constexpr const char* kNoFile = "the path is not that of a regular file";

class Descriptor {
  public:
    explicit Descriptor(int number) : number_(number) {}
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    ~Descriptor() { (void)close(); }
    int number() const { return number_; }
    bool is_open() const { return number_ >= 0; }
    // A full disk may show only here.
    bool close()
    {
        const bool good = number_ < 0 || ::close(number_) == 0;
        number_ = -1;
        return good;
    }

  private:
    int number_;
};

const char* why(const char* path, char* text, std::size_t text_size)
{
    std::snprintf(text, text_size, "%.100s: %s", path, std::strerror(errno));
    return text;
}

// False: errno tells why.
bool read_all(int from, std::span<std::byte> to)
{
    while (!to.empty()) {
        const ssize_t got = ::read(from, to.data(), to.size());
        if (got < 0 && errno == EINTR) continue;
        if (got == 0) errno = EIO;  // it has become shorter
        if (got <= 0) return false;
        to = to.subspan(std::size_t(got));
    }
    return true;
}

bool write_all(int to, std::span<const std::byte> from)
{
    while (!from.empty()) {
        const ssize_t put = ::write(to, from.data(), from.size());
        if (put < 0 && errno == EINTR) continue;
        if (put <= 0) return false;
        from = from.subspan(std::size_t(put));
    }
    return true;
}

}  // namespace

// A pipe or a device would have no end.
const char* read_file(const char* path, Array<std::byte>& out, char* text, std::size_t text_size)
{
    const Descriptor file(open_to_read(path));
    struct stat about;
    if (!file.is_open() || ::fstat(file.number(), &about) != 0) return why(path, text, text_size);
    if (!S_ISREG(about.st_mode)) return kNoFile;
    if (about.st_size > INT_MAX) return "the file is larger than 2 GiB";
    if (!out.resize(int(about.st_size))) return kOutOfMemory;
    return read_all(file.number(), out.span()) ? nullptr : why(path, text, text_size);
}

// A link stays one, and what it leads to is replaced.
const char* write_file(const char* path, std::span<const std::byte> bytes, char* text, std::size_t text_size)
{
    struct stat about;
    char whole[4096];
    static_assert(sizeof whole >= PATH_MAX);
    if (const char* const end = end_of_links(path, whole)) path = end;
    if (::stat(path, &about) == 0 && !S_ISREG(about.st_mode)) return kNoFile;
    char fresh[4096];
    const int length = std::snprintf(fresh, sizeof fresh, "%s.%ld.new", path, process_number());
    if (length >= int(sizeof fresh)) return "the path is too long";
    Descriptor file(open_new(fresh));
    if (!file.is_open()) return why(path, text, text_size);
    const bool written = write_all(file.number(), bytes) && flush_to_disk(file.number()) == 0 &&
                         file.close() && replace_file(fresh, path) == 0;
    if (written) return nullptr;
    const char* const reason = why(path, text, text_size);
    (void)::unlink(fresh);
    return reason;
}

}  // namespace epode
