#pragma once

#include "core/io/read_city.h"

namespace noonmark {

/// What one reader makes of one file, in the frame that it was given or chose. readCity() joins these.
struct FilePiece {
    std::optional<Frame> frame;  ///< set when the reader chose it
    std::vector<std::shared_ptr<const Building>> buildings;
    /// Local z of the ground that each building was put on; nothing where the file does not say it, so that
    /// readCity() puts the building on the terrain. Empty: all z are the file's own and stay.
    std::vector<std::optional<float>> groundM;
    std::shared_ptr<const Terrain> terrain;
    Warnings warnings;
    std::string format;
    std::size_t features = 0;
    std::string attribution;
    HeightFacts heights;
};

/// One reader per family of formats; each in a .cpp that bears its backend's name. `settings.frame` is set
/// when an earlier file fixed it; otherwise the reader chooses the middle of its data.
Result<FilePiece> readFootprints(const std::filesystem::path& file, const ReadSettings& settings,
                                 Progress& progress,
                                 std::stop_token stop);  ///< read_footprints_gdal.cpp
Result<FilePiece> readCityJson(const std::filesystem::path& file, const ReadSettings& settings,
                               Progress& progress,
                               std::stop_token stop);  ///< read_cityjson.cpp
Result<FilePiece> readMesh(const std::filesystem::path& file, const ReadSettings& settings,
                           Progress& progress,
                           std::stop_token stop);  ///< read_mesh.cpp, by way of mesh_reader_process.h
Result<FilePiece> readTerrain(const std::filesystem::path& file, const ReadSettings& settings,
                              Progress& progress,
                              std::stop_token stop);  ///< read_terrain_gdal.cpp

}  // namespace noonmark
