#pragma once

#include <QString>

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

}  // namespace noonmark
