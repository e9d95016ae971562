#pragma once

#include "core/study/provenance/command_words.h"
#include "core/study/provenance/provenance.h"

namespace noonmark {

/// Whether it is known which files the city was read from, and how.
bool namesCityFiles(const Provenance& provenance);

/// Adds these files and the options of reading them to a command line. Call it only if namesCityFiles().
void addCityFiles(CommandWords& line, const Provenance& provenance);

}  // namespace noonmark
