#pragma once

#include <QString>
#include <QStringList>
#include <QTextStream>
#include <optional>
#include <vector>

#include "core/base/units.h"

namespace noonmark {

/// A city whose clock is known.
struct ZoneCity {
    LonLat place;
    QString country;  ///< ISO 3166 code: "MC"
    QString zone;     ///< IANA: "Europe/Monaco"
};

/// The principal cities of the tz database's zone.tab, one a zone and country. Lines that are none are left
/// out.
std::vector<ZoneCity> zoneCities(QTextStream& table);

struct ZoneGuess {
    QString zone = QStringLiteral("UTC");
    QStringList others;  ///< nearly as near, and their clock shows another time on some day of the year
    bool operator==(const ZoneGuess&) const = default;
};

/// The zone of a place: that of the nearest city of both lists; but within 30 km of a principal city of the
/// same country the principal city's, since the tz database knows a change of clocks first. A guess: the
/// boundaries of zones are in neither list. `others` are zones of cities up to 30 km farther. UTC where both
/// lists are empty. `principal`: zoneCities(); `cities`: of a gazetteer, may be empty.
ZoneGuess guessZone(const std::vector<ZoneCity>& principal, const std::vector<ZoneCity>& cities,
                    LonLat place);

/// The same from this machine's zone.tab and gazetteer. Some 0.1 s: for a job.
ZoneGuess findNearestZone(LonLat place);

/// "+40-07410" or "+404251-0740023" (ISO 6709) in degrees.
std::optional<LonLat> parseIso6709(const QString& text);

}  // namespace noonmark
