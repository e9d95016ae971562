#pragma once

#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "core/study/study.h"

namespace noonmark {

/// A city with what it was made of.
struct LoadedCity {
    std::vector<std::string> files;        ///< as they were named; "sample:central-park-south"
    std::optional<ReadSettings> settings;  ///< nothing: not known (CityReading)
    CityRead read;
    std::vector<InputFile> inputs;  ///< a sample has no bytes and no hash
    double seconds = 0;             ///< to read it; hashing the files is not in it
};

/// Reads the files, or makes the sample where the only "file" is sample:NAME.
Result<LoadedCity> loadCity(const std::vector<std::string>& files, const ReadSettings& settings,
                            Progress& progress, std::stop_token stop);

/// Of a city that came straight from its files.
Provenance provenanceOf(const LoadedCity& loaded);

/// What reading took and found belongs to the study as much as what computing did.
void addReading(Study& study, const LoadedCity& loaded);

bool isSample(std::string_view file);

/// The sample of a name ("central-park-south", "grid"), made with its defaults; error for an unknown name.
Result<City> sampleCity(const std::string& name);

/// The box around all buildings.
Region cityRegion(const City& city);

/// A region to begin with: the park of Central Park South; of other cities the middle with 50 m around, up
/// to `mostM` metres along a side.
Region firstRegion(const LoadedCity& loaded, float mostM = 800);

}  // namespace noonmark
