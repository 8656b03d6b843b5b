// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Where the pictures of a video go: into ffmpeg, which makes the file, or, where there is no ffmpeg, one by
// one into PNG files.
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <string>
#include <vector>

namespace epode::cli {

class Film {
  public:
    Film() = default;
    ~Film();
    Film(const Film&) = delete;
    Film& operator=(const Film&) = delete;

    bool open(const std::string& path, int width, int height, double fps);
    // Rows from the top, 3 bytes a pixel.
    bool add(const std::vector<std::uint8_t>& rgb);
    bool close();
    const std::string& problem() const { return problem_; }
    // The name of the first PNG file; "" where ffmpeg makes a video.
    const std::string& first_png() const { return first_png_; }

  private:
    bool start_encoder(const std::string& path, double fps);
    std::string png_name(int number) const;

    std::string path_, problem_, first_png_;
    int width_ = 0, height_ = 0, pictures_ = 0;
    int pipe_ = -1;
    pid_t encoder_ = -1;
};

}  // namespace epode::cli
