#pragma once

#include "core/io/footprints/footprint_scan.h"
#include "core/io/pieces/read_part.h"

namespace noonmark {

/// Reads the buildings of OpenStreetMap; always the whole file.
Result<FilePiece> readOsmFootprints(const std::filesystem::path& file, const ReadSettings& settings,
                                    Progress& progress, std::stop_token stop);

/// scanFootprints() of OpenStreetMap; its areas are in memory meanwhile.
Result<FootprintScan> scanOsmFootprints(const std::filesystem::path& file, const ReadSettings& settings,
                                        Progress& progress, std::stop_token stop);

}  // namespace noonmark
