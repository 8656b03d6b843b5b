// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The header: "P6", width, height, 255, apart by white space, with comments from # to the end of the line;
// one white space character; then rows from the top, 3 bytes a pixel.
#include "ppm.h"

#include <fstream>
#include <istream>
#include <limits>

namespace epode::drawstuff {

namespace {

constexpr int kMaxSide = 8192;

// The next number of the header; 0 if there is none.
int next_number(std::istream& in)
{
    while ((in >> std::ws) && in.peek() == '#') in.ignore(std::numeric_limits<std::streamsize>::max(), '\n');
    int number = 0;
    in >> number;
    return in ? number : 0;
}

}  // namespace

bool read_ppm(const std::string& path, viewer::Image& image)
{
    std::ifstream in(path, std::ios::binary);
    char magic[2] = {0, 0};
    if (!in.read(magic, 2) || magic[0] != 'P' || magic[1] != '6') return false;
    const int width = next_number(in), height = next_number(in), largest = next_number(in);
    if (width < 1 || height < 1 || width > kMaxSide || height > kMaxSide || largest != 255) return false;
    in.get();
    image.width = width;
    image.height = height;
    image.rgb.resize(3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    in.read(reinterpret_cast<char*>(image.rgb.data()), static_cast<std::streamsize>(image.rgb.size()));
    return in.gcount() == static_cast<std::streamsize>(image.rgb.size());
}

bool write_ppm(const std::string& path, const viewer::Image& image)
{
    std::ofstream out(path, std::ios::binary);
    out << "P6\n" << image.width << ' ' << image.height << "\n255\n";
    out.write(reinterpret_cast<const char*>(image.rgb.data()),
              static_cast<std::streamsize>(image.rgb.size()));
    out.close();
    return out.good();
}

}  // namespace epode::drawstuff
