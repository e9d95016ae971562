#pragma once

#include <QDate>
#include <QString>
#include <QTime>
#include <glm/vec3.hpp>

#include "core/sun/civil_time.h"
#include "core/sun/stated_period.h"

namespace noonmark {

// Numbers as the window's language writes them: QLocale's default. Files always have a decimal point.

QString groupDigits(double number, int decimals = 0);   ///< "61,234.50", "61.234,50"
QString formatAmount(double number, int decimals = 1);  ///< as groupDigits(), without trailing zeros
QString formatCount(quint64 number);                    ///< "176,123"
/// The number by which tr() chooses the plural form of a text that contains `count`:
/// tr("%1 point(s)", "", pluralNumber(count)).arg(formatCount(count)).
int pluralNumber(quint64 count);
QString formatShort(double number, int digits);  ///< significant digits: "0.0123"
// Metres and square metres in the units in use (app/gui/base/looks/units.h).

QString describeLength(double metres, int decimals = 1);  ///< "124.3 m", "407.8 ft"
QString describeArea(double squareMetres);                ///< "1,204 m²"; from 10 ha on "12.5 ha"
QString describeSmallArea(double squareMetres);           ///< "125,204 m²": never in hectares or acres

/// A text of core or report with its numbers, "1,204.5", written as the window's language does. Dates, times
/// and version numbers stay.
QString localiseNumbers(const QString& text);

struct City;

// Heights of buildings in the units and from the reference in use (app/gui/base/looks/units.h).

/// Elevation of a point, metres above the vertical datum of the project's data. Without terrain and ground
/// elevations in the data, local z.
double computeElevation(const City& city, glm::dvec3 local);

/// What is added to a height above ground to show it: `groundElevationM` above the datum, else 0.
double heightZeroM(double groundElevationM);

/// "35.0 m above ground", or "47.5 m above datum".
QString describeHeight(double aboveGroundM, double groundElevationM);

// Formats of dates as the language of the window writes them, for QLocale::toString() and fields.
/// A text whose lines do not break between a number and its unit.
QString keepUnits(QString text);

QString shortDay();  ///< "21 Mar"
/// A day as it is typed: "21 Dec", "December 21", "21.12.", "12-21", "2026-12-21" or "21" of the shown month;
/// names of months in the window's language or in English, at least three letters. In the year of `shown`.
/// Invalid: it is none.
QDate parseDay(const QString& text, QDate shown);
/// "14:30", "14.30", "1430", "14"; invalid: no time of a day.
QTime parseTime(const QString& text);
QString longDay();    ///< "21 March"
QString dayOfYear();  ///< "21 Mar 2026"
QString longDate();   ///< "21 March 2026"

/// The dates and hours of a period: "21 March 2026, 09:00 to 15:00",
/// "1 June 2026 to 31 August 2026, sunrise to sunset", "21 December 2026, 12:00".
QString describeWhen(const Period& period);

/// The same with its step and zone: "21 March 2026, 09:00 to 15:00, every 1 min, Europe/Berlin".
QString periodText(const Period& period);
/// The same; in English where the answer has no more than words.
QString periodText(const StatedPeriod& stated);

/// "+" before the text of a value above zero, but not where it states zero as rounded.
QString withPlus(double value, const QString& text);

/// Conversion between QDate and CivilDate.
QDate dateOf(CivilDate date);
CivilDate civilOf(QDate date);

// Columns of numbers whose heading states the unit, in the units in use (app/gui/base/looks/units.h). Where
// both are in use, feet follow in parentheses.

QString areaUnit();                             ///< "m²", "sq ft", "m² (sq ft)"
QString lengthUnit();                           ///< "m", "ft", "m (ft)"
QString areaNumber(double squareMetres);        ///< "1,204"
QString lengthNumber(double metres);            ///< "124.3"
QString signedAreaNumber(double squareMetres);  ///< "+1,204"

}  // namespace noonmark
