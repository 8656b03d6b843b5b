// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A GLB of a tetrahedron with corners at the origin and at 1 on each axis, with the nodes of a text of JSON.
#pragma once

#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

namespace epode::robots {

inline std::string chunk(std::uint32_t kind, std::string bytes, char padding)
{
    while (bytes.size() % 4) bytes += padding;
    std::string head(8, '\0');
    const std::uint32_t size = std::uint32_t(bytes.size());
    std::memcpy(&head[0], &size, 4), std::memcpy(&head[4], &kind, 4);
    return head + bytes;
}

inline std::string glb_file(const std::string& json, const std::string& binary)
{
    const std::string body = chunk(0x4E4F534A, json, ' ') + chunk(0x004E4942, binary, '\0');
    const std::uint32_t head[3] = {0x46546C67, 2, std::uint32_t(12 + body.size())};
    return std::string(reinterpret_cast<const char*>(head), sizeof head) + body;
}

inline std::string tetrahedron_glb(const std::string& nodes = R"({"mesh":0})", const std::string& more = "")
{
    const float vertices[12] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
    const std::uint16_t indices[12] = {0, 2, 1, 0, 1, 3, 1, 2, 3, 0, 3, 2};
    const std::string binary = std::string(reinterpret_cast<const char*>(vertices), sizeof vertices) +
                               std::string(reinterpret_cast<const char*>(indices), sizeof indices);
    return glb_file(
        R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[)" + nodes +
            R"(],"meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}],"accessors":[
{"bufferView":0,"componentType":5126,"count":4,"type":"VEC3"},{"bufferView":1,"componentType":5123,"count":12,"type":"SCALAR"}],
"bufferViews":[{"buffer":0,"byteLength":48},{"buffer":0,"byteOffset":48,"byteLength":24}],"buffers":[{"byteLength":72}])" +
            more + "}",
        binary);
}

}  // namespace epode::robots
