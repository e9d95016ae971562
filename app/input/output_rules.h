#pragma once

#include <string>
#include <vector>

#include "core/io/files/check_output.h"
#include "core/study/provenance/provenance.h"

namespace noonmark {

/// What the outputs of a city may be written over. `named`: the files and the project as a command or the
/// window names them. `inputs`: what the city was read from; where their names are relative, a project may
/// have been moved together with them, and they are looked for beside the named files too.
OutputRules outputRules(const std::vector<std::string>& named, const std::vector<InputFile>& inputs,
                        bool overwrite);

/// A region or lot as a command line states it (readRegion): an input where it names a file.
void addPlace(OutputRules& rules, const std::string& place);

}  // namespace noonmark
