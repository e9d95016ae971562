#pragma once

#include <string>
#include <vector>

#include "core/io/files/check_output.h"
#include "core/study/provenance/provenance.h"

namespace noonmark {

/// Which files the outputs of a city may replace. `named`: the files and the project as the user named them.
/// `inputs`: the files from which the city was read; relative names are also looked up beside the named
/// files, because a project may have been moved together with its inputs.
OutputRules outputRules(const std::vector<std::string>& named, const std::vector<InputFile>& inputs,
                        bool overwrite);

/// Protects a region or lot as given on a command line (readRegion()) if it names a file.
void addPlace(OutputRules& rules, const std::string& place);

}  // namespace noonmark
