#include "app/window/zone_guess.h"

#include <QFile>
#include <QRegularExpression>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec3.hpp>

namespace noonmark {

namespace {

glm::dvec3 onSphere(LonLat place) {
    const double lon = glm::radians(place.lonDeg);
    const double lat = glm::radians(place.latDeg);
    return {std::cos(lat) * std::cos(lon), std::cos(lat) * std::sin(lon), std::sin(lat)};
}

// Digits are dd, ddmm or ddmmss; longitudes have one digit of degrees more.
double degreesOf(QStringView digits, int degreeDigits) {
    double degrees = digits.left(degreeDigits).toInt();
    degrees += digits.mid(degreeDigits, 2).toInt() / 60.0;
    return degrees + digits.mid(degreeDigits + 2, 2).toInt() / 3600.0;
}

}  // namespace

std::optional<LonLat> placeFromIso6709(const QString& text) {
    static const QRegularExpression form(QStringLiteral("^([+-])(\\d{4}|\\d{6})([+-])(\\d{5}|\\d{7})$"));
    const QRegularExpressionMatch match = form.match(text);
    if (!match.hasMatch()) return std::nullopt;
    const auto sign = [&match](int group) {
        return match.captured(group) == QLatin1String("-") ? -1.0 : 1.0;
    };
    return LonLat{sign(3) * degreesOf(match.captured(4), 3), sign(1) * degreesOf(match.captured(2), 2)};
}

std::optional<QString> nearestZone(QTextStream& table, LonLat place) {
    std::optional<QString> nearest;
    double best = -2;
    for (QString line; table.readLineInto(&line);) {
        const QStringList fields = line.split(QLatin1Char('\t'));
        if (line.startsWith(QLatin1Char('#')) || fields.size() < 3) continue;
        const auto city = placeFromIso6709(fields[1]);
        const double closeness = city ? glm::dot(onSphere(*city), onSphere(place)) : -2;
        if (closeness <= best) continue;
        best = closeness;
        nearest = fields[2];
    }
    return nearest;
}

QString zoneNear(LonLat place) {
    QFile file(QStringLiteral("/usr/share/zoneinfo/zone1970.tab"));
    if (!file.open(QIODevice::ReadOnly | QIODevice::Text)) return QStringLiteral("UTC");
    QTextStream table(&file);
    return nearestZone(table, place).value_or(QStringLiteral("UTC"));
}

}  // namespace noonmark
