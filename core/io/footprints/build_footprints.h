#pragma once

#include "core/io/footprints/place_features.h"
#include "core/io/pieces/read_part.h"

namespace noonmark {

/// Share of a reader's progress that reading takes; repair and semantics take the rest.
inline constexpr double shareOfReading = 0.8;

/// Makes buildings from features and adds them to `piece`: all steps after reading. Chooses the piece's frame
/// if the settings state none. `features` is not empty. Error: cancelled().
Result<void> buildFootprints(FilePiece& piece, std::vector<UnplacedFeature> features,
                             const ReadSettings& settings, Progress& progress, const std::stop_token& stop);

/// The most frequent warning, for an error; empty without warnings.
std::string findCommonest(const Warnings& warnings);

}  // namespace noonmark
