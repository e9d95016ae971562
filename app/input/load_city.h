#pragma once

// The folder app/input/ prepares input for the window and the command line. This file reads a city from files
// or makes a sample, and reads what belongs to it: places, context and photographs. load_project.h reads a
// city from a project or starts a project from it; all_engines.h lists the engines; load_city.h protects
// the input files from being overwritten.

#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/io/context/read_context.h"
#include "core/io/files/check_output.h"
#include "core/io/places/read_places.h"
#include "core/study/provenance/provenance.h"
#include "core/study/study.h"
#include "scenarios/project/project.h"

namespace noonmark {

/// Which files the outputs of a city may replace. `named`: the files and the project as the user named them.
/// `inputs`: the files from which the city was read; relative names are also looked up beside the named
/// files, because a project may have been moved together with its inputs.
OutputRules outputRules(const std::vector<std::string>& named, const std::vector<InputFile>& inputs,
                        bool overwrite);

/// Protects a region or lot as given on a command line (readRegion()) if it names a file.
void addPlace(OutputRules& rules, const std::string& place);

/// What those files of a city that are maps (OpenStreetMap's) draw for orientation. Nothing from samples and
/// other formats. Error: a file cannot be read; cancelled().
Result<ContextRead> loadCityContext(const std::vector<std::string>& files, const Frame& frame,
                                    Progress& progress, const std::stop_token& stop);

/// Joins what another file draws to a city's context, which may be null.
std::shared_ptr<const MapContext> joinContext(const std::shared_ptr<const MapContext>& before,
                                              MapContext added);

/// The ground that a photograph of this city is read for: its buildings with 500 m around them, local metres.
Box2 photographBox(const City& city);

/// A photograph's pixels, and its file with the file's hash.
struct Photograph {
    GroundPictureFile file;
    std::shared_ptr<const GroundRaster> raster;
};
/// Reads the file of `wanted`, whose hash is set. Error: readGroundRaster()'s; cancelled().
Result<Photograph> loadPhotograph(const GroundPictureFile& wanted, const City& city, Progress& progress,
                                  const std::stop_token& stop);

/// `project` with the photograph that its file names on the ground. A file that is missing, has changed or
/// cannot be read gives a warning, and the project stays as it is: without pixels.
Project withLoadedPhotograph(Project project, Warnings& warnings, Progress& progress,
                             const std::stop_token& stop);

/// The places of those files of a city that state them: OpenStreetMap's; where streets are wanted, also the
/// lines of others.
/// Names are unique. Error: a file cannot be read; cancelled().
Result<PlacesRead> loadCityPlaces(const std::vector<std::string>& files, const PlaceSettings& settings,
                                  const Frame& frame, Progress& progress, const std::stop_token& stop);

/// The places of all these files, of any format that readPlaces() reads, joined to those of `before`. Names
/// are unique.
Result<PlacesRead> loadPlaceFiles(const std::vector<std::string>& files, const PlaceSettings& settings,
                                  const Frame& frame, PlacesRead before, Progress& progress,
                                  const std::stop_token& stop);

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
/// 50 m, or where it is densest if that is more than `maxM` metres wide or high (core/city/city_position.h).
Region firstRegion(const LoadedCity& loaded, float maxM = 800);

}  // namespace noonmark
