// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// While it lives, printf writes numbers with a comma, as programs have it that called setlocale() in Berlin. The locale is compiled for
// the test; where that cannot be done, is_there() is false.
#pragma once

#include <clocale>
#include <cstdlib>
#include <filesystem>
#include <random>
#include <string>

namespace epode {

class CommaLocale {
  public:
    CommaLocale()
        : folder_(std::filesystem::temp_directory_path() /
                  ("epode_locale_" + std::to_string(std::random_device()())))
    {
        std::filesystem::create_directories(folder_);
        const std::string made = (folder_ / "de_DE.UTF-8").string();
        const std::string command = "localedef -i de_DE -f UTF-8 '" + made + "' >/dev/null 2>&1";
        if (std::system(command.c_str()) != 0) return;
        setenv("LOCPATH", folder_.c_str(), 1);
        is_there_ = std::setlocale(LC_NUMERIC, "de_DE.UTF-8") && *std::localeconv()->decimal_point == ',';
    }
    CommaLocale(const CommaLocale&) = delete;
    CommaLocale& operator=(const CommaLocale&) = delete;
    ~CommaLocale()
    {
        std::setlocale(LC_NUMERIC, "C");
        unsetenv("LOCPATH");
        std::filesystem::remove_all(folder_);
    }
    bool is_there() const { return is_there_; }

  private:
    std::filesystem::path folder_;
    bool is_there_ = false;
};

}  // namespace epode
