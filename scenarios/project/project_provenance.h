#pragma once

#include <optional>
#include <string>

#include "scenarios/project/project_file.h"

namespace noonmark {

/// The parts of a project on which a result depends.
struct MeasuredPart {
    std::string scenario = existingCity;
    std::string baseline;  ///< of a comparison; otherwise empty
    Region region;
    std::optional<TimeWeights> weights;  ///< of a score
};

/// States what a result of the project was made from. `onDisk`: the project's file as last opened or saved;
/// null where it has none. The file is recorded as the source only if its content gives the same
/// contentSha256 and no other program has saved it since. Costs a hash of the city, of each scenario's city
/// and of the file: about 0.3 s for 43,000 buildings.
Provenance provenanceOf(const Project& project, const ProjectFile* onDisk, const MeasuredPart& part);

/// SHA-256 of the content on which the result depends, as contentHashText describes. Error: an unknown
/// scenario.
Result<std::string> hashContent(const Project& project, const MeasuredPart& part);

/// Inserts the warnings of reading the city before those of the computation.
void prependWarnings(Warnings& warnings, const Warnings& ofReading);

}  // namespace noonmark
