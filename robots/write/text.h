// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What the writers of all formats share: numbers and paths as text, names that are unique, the list of what is lost.
#pragma once

#include <initializer_list>
#include <pugixml.hpp>
#include <set>
#include <string>
#include <vector>

#include "robots/model.h"
#include "robots/numbers.h"

namespace epode::robots {

// The shortest that reads back as the same number.
std::string list_text(const std::vector<double>& values);
std::string text_of(Vec v);
std::string text_of(Quat q);  // w, x, y, z
std::string color_text(const float (&color)[4]);

void set(pugi::xml_node node, const char* attribute, const std::string& value);
void set(pugi::xml_node node, const char* attribute, double value);

// The file's path as seen from the folder.
std::string path_from(const std::string& folder, const std::string& path);
std::string text_of(const pugi::xml_document& document);

// Names for all of a list: their own, or made of a word and a number where that is missing or taken.
class Names {
  public:
    std::string unique(const std::string& wanted, const char* word, size_t number);

  private:
    std::set<std::string> taken_;
};

// Sentences, each once.
class Losses {
  public:
    void add(const std::string& sentence);
    std::vector<std::string> all;
};

// Turns about fixed axes x, y, z, as URDF has them.
Vec rpy_of(Quat q);
bool is_identity(const Pose& pose);

}  // namespace epode::robots
