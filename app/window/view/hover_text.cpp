#include "app/window/view/hover_text.h"

#include <cmath>

#include "app/report/maps/shadow_measure.h"
#include "core/city/terrain/building_ground.h"

namespace noonmark {

namespace {

QString placeText(const Pick& pick, const City& city) {
    const LonLat place = city.frame.lonLatFromLocal({pick.position.x, pick.position.y});
    return QStringLiteral("%1°, %2°   x %3 m, y %4 m, z %5 m")
        .arg(place.lonDeg, 0, 'f', 6)
        .arg(place.latDeg, 0, 'f', 6)
        .arg(pick.position.x, 0, 'f', 1)
        .arg(pick.position.y, 0, 'f', 1)
        .arg(pick.position.z, 0, 'f', 1);
}

QString buildingText(const Building& building, const City& city) {
    const QString name = QString::fromStdString(building.name.empty() ? building.sourceId : building.name);
    QString text = QStringLiteral("%1, %2 m high").arg(name).arg(double(heightM(building, city)), 0, 'f', 1);
    if (!building.status.empty())
        text += QStringLiteral(" (%1)").arg(QString::fromStdString(building.status));
    return text;
}

}  // namespace

std::optional<std::size_t> cellAt(const Grid& grid, glm::dvec2 point) {
    const double column = std::floor((point.x - grid.westM) / grid.cellM);
    const double row = std::floor((point.y - grid.southM) / grid.cellM);
    if (!(column >= 0 && column < grid.columns && row >= 0 && row < grid.rows)) return std::nullopt;
    return grid.index(int(column), int(row));
}

QString formatMinutes(float gross, float continuous, bool instant) {
    if (std::isnan(gross)) return QStringLiteral("not measured");
    if (instant) return gross > 0 ? QStringLiteral("in shadow") : QStringLiteral("in the sun");
    const QString text = QStringLiteral("gross %1 min a day").arg(double(gross), 0, 'f', 1);
    if (std::isnan(continuous)) return text;
    return text + QStringLiteral(", continuous %1 min").arg(double(continuous), 0, 'f', 1);
}

QString formatMinutes(const ShadowField& field, glm::dvec2 point) {
    const auto cell = cellAt(field.grid, point);
    if (!cell) return {};
    return formatMinutes(field.grossMin[*cell], field.continuousMin[*cell], isInstant(field));
}

QString hoverText(const Pick& pick, const City& city, const QString& minutes) {
    QString text = placeText(pick, city);
    if (pick.building) text += QStringLiteral("   ") + buildingText(*city.buildings[*pick.building], city);
    return minutes.isEmpty() ? text : text + QStringLiteral("   ") + minutes;
}

}  // namespace noonmark
