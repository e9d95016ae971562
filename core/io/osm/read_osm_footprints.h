#pragma once

#include "core/io/footprints/footprint_scan.h"
#include "core/io/osm/osm_map.h"
#include "core/io/read_part.h"

namespace noonmark {

/// readFootprints() for OpenStreetMap, which is read whole.
Result<FilePiece> readOsmFootprints(const std::filesystem::path& file, OsmFormat format,
                                    const ReadSettings& settings, Progress& progress,
                                    const std::stop_token& stop);

/// scanFootprints() for OpenStreetMap; its areas are in memory meanwhile.
Result<FootprintScan> scanOsmFootprints(const std::filesystem::path& file, OsmFormat format,
                                        const ReadSettings& settings, Progress& progress,
                                        const std::stop_token& stop);

}  // namespace noonmark
