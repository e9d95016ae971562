#pragma once

#include <QString>
#include <QTextStream>
#include <optional>

#include "core/units.h"

namespace noonmark {

/// The IANA zone whose principal city, by the tz database's table zone1970.tab, is nearest to a place. A
/// guess: near the border of a zone it may be the neighbour's. Nothing when the table holds no zone.
std::optional<QString> nearestZone(QTextStream& table, LonLat place);

/// The same from this machine's table; UTC where it has none.
QString zoneNear(LonLat place);

/// "+40-07410" or "+404251-0740023" (ISO 6709) in degrees.
std::optional<LonLat> placeFromIso6709(const QString& text);

}  // namespace noonmark
