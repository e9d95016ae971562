#pragma once

// The folder scenarios/project/ holds the project and its file. This file defines the Project value;
// project_file.h opens and saves it as a GeoPackage through read_project.h, write_project.h and edit_json.h,
// and stores unsaved work; project_provenance.h states what a result was made from. results/ converts saved
// results to and from their JSON, and tables/ holds the SQLite and GeoPackage layer.

#include <chrono>
#include <filesystem>
#include <glm/vec3.hpp>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/base/units.h"
#include "core/city/city.h"
#include "core/city/map_context.h"
#include "core/geo/grid.h"
#include "core/io/heights/height_facts.h"
#include "core/receivers/parcels/parcel_lines.h"
#include "core/receivers/place.h"
#include "core/receivers/receivers.h"
#include "core/study/elements/element_map.h"
#include "core/study/provenance/provenance.h"
#include "core/sun/civil_time.h"
#include "core/sun/period.h"
#include "scenarios/project/title_block.h"
#include "scenarios/scenario.h"
#include "scenarios/weights/time_weights.h"

namespace noonmark {

/// A date and a time of day, in the time zone of the study.
struct ViewMoment {
    CivilDate date{};
    std::chrono::minutes at{0};  ///< since midnight, 0 to 24 h
    bool operator==(const ViewMoment&) const = default;
};

/// What a view shows of the city: a box along east, north and up, local metres.
struct ViewBox {
    glm::dvec3 lowM{0};   ///< west, south, bottom
    glm::dvec3 highM{0};  ///< east, north, top; each above lowM
    bool operator==(const ViewBox&) const = default;
};

/// Whether each side is above 0 and lies within 1e7 m.
bool isBox(const ViewBox& box);

/// A view of the city under a name: camera, projection, moment and section box.
struct SavedView {
    std::string name;                    ///< unique in a project
    glm::dvec3 targetM{0};               ///< point that the camera looks at, local metres
    double distanceM = 1000;             ///< from the eye to the target, above 0
    double headingDeg = 0;               ///< clockwise from true north, 0 to 360
    double pitchDeg = 45;                ///< below the horizontal, 0 to 90
    bool parallel = false;               ///< parallel (orthographic) projection, not perspective
    std::optional<ViewMoment> moment{};  ///< none: the view shows the whole period
    std::optional<ViewBox> section{};    ///< none: the view shows the whole city
    bool operator==(const SavedView&) const = default;
};

/// Error: a number out of range.
Result<void> validate(const SavedView& view);

struct Project;

/// A picture of the ground that a project refers to: a file of its own, not copied into the project.
struct GroundPictureFile {
    std::filesystem::path path;  ///< absolute
    std::string sha256;          ///< lower-case hex, of the file when it was chosen
    std::string attribution;     ///< whose picture it is; printed wherever it is drawn; may be empty
    double opacity = 1;          ///< 0 to 1
    bool shown = true;           ///< on ground, maps and sheets
    bool operator==(const GroundPictureFile&) const = default;
};

/// As JSON, for the project's file.
std::string formatText(const GroundPictureFile& picture);
/// Nothing for any text that formatText() does not write: the file may come from anywhere.
std::optional<GroundPictureFile> parseGroundPicture(const std::string& text);

/// `project` with this picture on its ground, or none. `raster`: its pixels; null: they are not at hand, and
/// nothing is drawn.
Project withGroundPicture(Project project, std::optional<GroundPictureFile> file,
                          std::shared_ptr<const GroundRaster> raster);

/// A lot: ground that may be built on.
struct NamedLot {
    std::string name;
    Footprint outline;
    std::vector<RoadFront> roads{};  ///< along its sides; at most one on each
    bool operator==(const NamedLot&) const = default;
};

/// How the city was read from its files, and the warnings of reading. Every result about the city or one of
/// its scenarios repeats these warnings.
struct CityReading {
    /// Empty: unknown, because the project file is of version 1.
    std::optional<ReadSettings> settings = ReadSettings{};
    Warnings warnings;
    HeightFacts heights;  ///< the fields from which heights were read
};

struct NamedPeriod {
    std::string name;
    Period period;
    bool operator==(const NamedPeriod&) const = default;
};

/// One map of a saved result.
struct SavedLayer {
    std::string name;           ///< "gross shadow"
    std::string unit;           ///< "min/day"
    std::vector<float> values;  ///< grid order, NaN where there is no receiver
};

/// A result saved in the project, with everything it is based on.
struct SavedResult {
    std::string name;      ///< unique in a project
    std::string kind;      ///< key of its question (app/questions): "study", "impact", "score"...
    std::string scenario;  ///< whose city was measured
    std::string baseline;  ///< the scenario compared with; empty: none
    std::string settings;  ///< JSON: engine, period, region and figures, as in study.json
    std::string inputs;    ///< JSON: path, bytes and sha256 of every file from which the city was read
    Grid grid;             ///< of a study at points one cell, which means nothing
    std::vector<SavedLayer> layers;
    std::vector<MeasuredElement> elements{};  ///< of a study at points
};

/// What the sheets of a project carry, and the units in which its results are shown.
struct SheetSettings {
    TitleBlock titleBlock;
    UnitSystem units = UnitSystem::metric;
    bool operator==(const SheetSettings&) const = default;
};

/// The whole content of one project file. A value: cheap to copy for undo, because the city and the results
/// are shared. City, results and reading compare by pointer.
struct Project {
    std::shared_ptr<const City> city =
        std::make_shared<const City>();  ///< existing city; ids unique, never null
    std::string attribution;
    std::vector<InputFile> inputs;  ///< the files from which the city was read
    /// How those files were read; shared like the city, never null.
    std::shared_ptr<const CityReading> reading = std::make_shared<const CityReading>();
    std::vector<NamedLot> lots;
    std::vector<Region> regions;
    std::vector<Place> places;  ///< areas whose sunlight matters
    std::vector<Scenario> scenarios;
    std::vector<TimeWeights> weights{makeMonthlyWeights()};
    std::vector<NamedPeriod> periods;
    std::vector<SavedView> views;
    std::vector<std::shared_ptr<const SavedResult>> results;
    SheetSettings sheets;
    /// What City::context draws of it depends on whether its file is at hand (withGroundPicture()).
    std::optional<GroundPictureFile> groundPicture{};
    std::map<std::string, std::string> view;  ///< camera, layout, switches: the window defines the keys
};

/// Finds an entry by name. Error: there is none; the Error lists the existing names.
Result<NamedLot> findLot(const Project& project, const std::string& name);
Result<Region> findRegion(const Project& project, const std::string& name);
/// Upper and lower case are equal. The error suggests names that are spelled alike.
Result<Place> findPlace(const Project& project, const std::string& name);
std::vector<Place> placesOfKind(const Project& project, PlaceKind kind);
Result<TimeWeights> findWeights(const Project& project, const std::string& name);
Result<NamedPeriod> findPeriod(const Project& project, const std::string& name);
Result<std::shared_ptr<const SavedResult>> findResult(const Project& project, const std::string& name);
Result<Scenario> findScenarioByName(const Project& project, const std::string& name);

/// The city of a scenario or of existingCity.
Result<EditedCity> cityOf(const Project& project, const std::string& scenario);

/// The most cells that the layers of all results of a project have together: 2 GB of float32.
inline constexpr std::size_t maxLayerCells = 500'000'000;

/// Error: a name is missing or used twice, a scenario or weight table is invalid, or the results have more
/// than maxLayerCells.
Result<void> validate(const Project& project);

}  // namespace noonmark
