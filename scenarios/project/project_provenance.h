#pragma once

#include <optional>
#include <string>

#include "scenarios/project/project_file.h"

namespace noonmark {

/// What of a project a result rests on.
struct MeasuredPart {
    std::string scenario = existingCity;
    std::string baseline;  ///< of a comparison; else empty
    Region region;
    std::optional<TimeWeights> weights;  ///< of a score
};

/// States what a result of the project was made from. `onDisk`: the project's file as it was last opened or
/// saved; null: it has none. The file counts as holding what was measured only if its content gives the same
/// contentSha256 and nobody else has saved it since. Costs a hash of the city, of each scenario's city and of
/// the file: some 0.3 s for 43,000 buildings.
Provenance provenanceOf(const Project& project, const ProjectFile* onDisk, const MeasuredPart& part);

/// Of the content that the part rests on, as contentHashWords says. Error: a scenario that is not there.
Result<std::string> hashContent(const Project& project, const MeasuredPart& part);

/// The warnings of reading the city go before those of computing.
void putBefore(Warnings& warnings, const Warnings& ofReading);

}  // namespace noonmark
