#pragma once

// The folder app/input/ prepares input for the window and the command line. load_city.h reads a city from
// files or makes a sample, load_project.h reads it from a project and project_of.h starts a project from it;
// all_engines.h lists the engines; output_rules.h protects the input files from being overwritten.

#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "core/study/study.h"

namespace noonmark {

/// A city and where it came from.
struct LoadedCity {
    std::vector<std::string> files;        ///< as the user named them; "sample:central-park-south"
    std::optional<ReadSettings> settings;  ///< empty: unknown (CityReading)
    CityRead read;
    std::vector<InputFile> inputs;  ///< samples have no bytes and no hash
    double seconds = 0;             ///< time to read it, without hashing the files
};

/// Reads the files, or makes the sample if the only "file" is sample:NAME.
Result<LoadedCity> loadCity(const std::vector<std::string>& files, const ReadSettings& settings,
                            Progress& progress, std::stop_token stop);

/// Provenance of a city read directly from its files.
Provenance provenanceOf(const LoadedCity& loaded);

/// Adds the time and the warnings of reading to the study.
void addReading(Study& study, const LoadedCity& loaded);

bool isSample(std::string_view file);
bool isParkSample(std::string_view file);  ///< Central Park South, which has streets and a park

/// Makes the sample of this name ("central-park-south", "grid") with its defaults. Error: an unknown name.
Result<City> sampleCity(const std::string& name);

/// The bounding box of all buildings.
Result<Region> cityRegion(const City& city);

/// A default region: the park for Central Park South, otherwise the main part of the city with a border of
/// 50 m, or where it is densest if that is more than `maxM` metres wide or high (core/city/main_part.h).
Region firstRegion(const LoadedCity& loaded, float maxM = 800);

}  // namespace noonmark
