#pragma once

#include <QString>
#include <QStringList>
#include <QTextStream>
#include <optional>
#include <vector>

#include "app/input/load_city.h"
#include "core/base/units.h"
#include "render/scene/city_arrays.h"
#include "render/view/scene_picker.h"

namespace noonmark {

/// A city with a known time zone.
struct ZoneCity {
    LonLat place;
    QString country;  ///< ISO 3166 code: "MC"
    QString zone;     ///< IANA: "Europe/Monaco"
};

/// The principal cities of the tz database's zone.tab, one per zone and country. Lines without a valid entry
/// are skipped.
std::vector<ZoneCity> zoneCities(QTextStream& table);

struct ZoneGuess {
    QString zone = QStringLiteral("UTC");
    /// Zones of cities nearly as near whose clock differs on some day of the year.
    QStringList others;
    bool operator==(const ZoneGuess&) const = default;
};

/// Guesses the time zone of a place. It is the zone of the nearest city of both lists; but within 30 km of a
/// principal city of the same country, it is the principal city's zone, since the tz database is the first to
/// know clock changes. It is a guess, because neither list has the zones' boundaries. `others` are zones of
/// cities up to 30 km farther away. UTC if both lists are empty. `principal`: from zoneCities(); `cities`:
/// from a gazetteer, may be empty.
ZoneGuess guessZone(const std::vector<ZoneCity>& principal, const std::vector<ZoneCity>& cities,
                    LonLat place);

/// The same with the system's zone.tab and the gazetteer. Takes about 0.1 s: call it from a job.
ZoneGuess findNearestZone(LonLat place);

/// "+40-07410" or "+404251-0740023" (ISO 6709) in degrees.
std::optional<LonLat> parseIso6709(const QString& text);

struct CrownRays;

/// A city ready for display: read, meshed and prepared for picking.
struct OpenCity {
    LoadedCity loaded;
    /// Arrays for the view: of this city, or of another that shares most of its buildings (differenceOf).
    std::shared_ptr<const CityArrays> arrays;
    ScenePicker picker;
    std::shared_ptr<const CrownRays> crowns;  ///< null: no trees, or the view draws no rays
    [[nodiscard]] const City& city() const { return loaded.read.city; }
};

/// Meshes a city and builds its picker; use it in a job. `drawn`: arrays of a city that shares most of its
/// buildings, such as the one before an edit, which are then reused, and `crowns`, where they are of the same
/// trees. Null: none.
Result<OpenCity> shownCity(LoadedCity loaded, std::shared_ptr<const CityArrays> drawn,
                           std::shared_ptr<const CrownRays> crowns, Progress& progress,
                           const std::stop_token& stop);
/// The crowns of a city for the shade of a moment; null: it has none, or the view draws no rays.
Result<std::shared_ptr<const CrownRays>> findCrownRays(const City& city,
                                                       std::shared_ptr<const CrownRays> known,
                                                       const std::stop_token& stop);

/// Initial settings: the first region, the guessed time zone, cells of 2 m, the automatic engine.
StudySettings firstSettings(const LoadedCity& loaded, const ZoneGuess& zone);

/// Runs a study of a city read from files, and adds the files' hashes and warnings.
Result<Study> studyOf(const LoadedCity& loaded, const StudySettings& settings, Progress& progress,
                      std::stop_token stop);

}  // namespace noonmark
