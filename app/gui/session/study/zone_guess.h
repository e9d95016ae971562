#pragma once

#include <QString>
#include <QStringList>
#include <QTextStream>
#include <optional>
#include <vector>

#include "core/base/units.h"

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

}  // namespace noonmark
