#pragma once

// The folder core/study/by_place answers how sunny places are over a period: runSunByPlace() (this file)
// measures all of them in one sweep over the union of their cells, sun_by_place_text.cpp writes the figures.

#include <limits>
#include <map>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "core/describe/figure.h"
#include "core/io/elements/write_elements.h"
#include "core/receivers/place.h"
#include "core/study/study.h"

namespace noonmark {

struct SunByPlaceSettings {
    static constexpr double maxHours = 24;
    static constexpr std::size_t maxDates = 31;

    StudySettings study;           ///< its region is replaced by the places; receivers stand on the ground
    double enoughHours = 2;        ///< hours of sun a day that are enough, 0 to 24
    std::vector<CivilDate> dates;  ///< days on which the area with less is stated; any, at most 31
};

/// The sun of one place. Hours are hours of sun a day; NaN: no cell.
struct SunOfPlace {
    static constexpr double none = std::numeric_limits<double>::quiet_NaN();

    std::size_t cells = 0;  ///< with their centre in the place
    double areaM2 = 0;      ///< of open ground, each cell by its exact share
    double meanHours = none, minHours = none, maxHours = none;  ///< over the cells, mean over the days
    double enoughShare = none;                                  ///< of the area, with enoughHours or more
    std::vector<double> monthHours;  ///< mean over the cells and the month's days; of SunByPlace::months
    std::vector<double>
        belowShare;  ///< of the area, with less than enoughHours; of SunByPlaceSettings::dates
};

struct SunByPlace {
    City city;
    SunByPlaceSettings settings;
    std::vector<Place> places;
    std::vector<SunOfPlace> sun;        ///< of each place
    std::vector<std::string> months;    ///< "2026-01"
    double possibleHours = 0;           ///< a day with the sun above the horizon, mean over the days
    ShadowField field;                  ///< gross shadow on the union of the places' cells; no longest runs
    std::optional<SampledError> error;  ///< of cells, against the ray reference
    SunSteps daylight;                  ///< the period's sun
    std::map<std::string, double> seconds;  ///< by stage, and "total"
    Warnings warnings;                      ///< places without cells among them
    Provenance provenance;                  ///< set by the caller
};

/// How much sun the places of a city get. Places without a cell on open ground are listed as warnings, with
/// NaN as figures. Error: no place, a setting out of range, an engine that sums no months; errors of
/// runStudy(). Stops with cancelled() within 0.2 s. Cost: one field with its months over the union of the
/// places, and a day for each date.
Result<SunByPlace> runSunByPlace(const City& city, std::vector<Place> places,
                                 const SunByPlaceSettings& settings, Progress& progress, std::stop_token stop,
                                 const EngineList& engines = coreEngines());

const Figures<SunOfPlace>& sunOfPlaceFigures();

/// A row for each place: name, kind, the figures, a column for each month and each date, lon_deg and lat_deg
/// of its middle, source. As CSV by toCsv(), as polygons by writePlacesGeoPackage().
ElementTable makeTable(const SunByPlace& sun);

/// Settings, figures, error, times and what it was made from.
std::string toJson(const SunByPlace& sun);

}  // namespace noonmark
