#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <set>
#include <stop_token>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/base/warnings.h"
#include "core/geo/frame.h"
#include "core/receivers/place.h"

namespace noonmark {

struct PlaceSettings {
    /// Most places of one file: more would be a register of a whole country.
    static constexpr std::size_t maxPlaces = 50'000;

    std::set<PlaceKind> kinds;  ///< only these; empty: all
    /// Also lines, as streets: those of OpenStreetMap's classes of streets, or of a layer of lines, as wide
    /// as stated, else as is usual.
    bool streets = false;
    bool wholeStreets = true;  ///< of each street name one place; else streets are cut at their junctions
    /// Beside the carriageways of streets, strips of this width on both sides as places of their own; 0:
    /// none.
    double sidewalkM = 0;
    static constexpr double maxSidewalkM = 20, defaultSidewalkM = 4;
    bool unnamed = true;      ///< also places without a name
    double minAreaM2 = 0;     ///< smaller places are left out
    double farAwayM = 60000;  ///< features farther from the frame's origin are left out, with a warning

    // Files other than OpenStreetMap's:
    std::string nameField;             ///< any case; empty: name, or another usual field
    PlaceKind kind = PlaceKind::park;  ///< of features whose kind the file does not state
    std::string layer;                 ///< empty: the only one, or those that state kinds
    std::optional<std::string> crs;    ///< "EPSG:2263", for files that state none
    bool listLayers = false;           ///< several layers that state nothing are listed, not refused
};

/// A layer of which nobody but the user knows whether it holds places.
struct UnknownLayer {
    std::string name;
    std::size_t features = 0;             ///< as the file states it
    std::vector<std::string> textFields;  ///< one may hold the names
};

struct PlacesRead {
    std::vector<Place> places;  ///< names are unique
    Warnings warnings;
    std::size_t features = 0;  ///< number of features read
    std::size_t streetsOfAssumedWidth = 0;
    std::string attribution;  ///< of the data, if known
    /// Where layers are listed, nothing was read: the user has to choose one (PlaceSettings::listLayers).
    std::vector<UnknownLayer> layers = {};
};

/// Reads the places of a file into the frame of a city: areas (and streets) of an OpenStreetMap file by their
/// tags (place_tags.h), or every polygon of a file in any vector format that GDAL reads. There, a feature's
/// kind is that of its field `kind` (nameOf(PlaceKind)), else of columns that bear OpenStreetMap's keys, else
/// `settings.kind`; a file with such columns gives only the features that are places by them. A layer
/// `places` that Noonmark wrote is read alone, and its places keep the sources that it states. A feature that
/// cannot be used gives a warning.
///
/// Error: the file cannot be read, is damaged, states no CRS, lacks the layer or field, has several layers of
/// which none states kinds, or more than maxPlaces places; cancelled(). An OpenStreetMap file without places
/// gives none; another file without polygons (or lines, for streets) is an error. Some 20 us a feature, and
/// for OpenStreetMap the time to read its file. Backend: read_places_gdal.cpp.
Result<PlacesRead> readPlaces(const std::filesystem::path& file, const PlaceSettings& settings,
                              const Frame& frame, Progress& progress, const std::stop_token& stop);

/// The same of a file that may have no streets: none of OpenStreetMap's own files, of one without a layer of
/// lines, and of what is no map. The file is opened once.
Result<PlacesRead> readStreetLines(const std::filesystem::path& file, const PlaceSettings& settings,
                                   const Frame& frame, Progress& progress, const std::stop_token& stop);

/// Whether places can be read from the file by its tags: OpenStreetMap XML and PBF.
bool isOsmFile(const std::filesystem::path& file);

}  // namespace noonmark
