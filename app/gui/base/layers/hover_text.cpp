#include "app/gui/base/layers/hover_text.h"

#include <QObject>
#include <cmath>

#include "app/gui/base/looks/units.h"
#include "app/gui/base/widgets/number_text.h"
#include "app/report/maps/shadow_measure.h"
#include "app/report/sheets/study_text.h"
#include "core/city/terrain/building_ground.h"

namespace noonmark {

namespace {

QString placeText(const Pick& pick, const City& city) {
    const LonLat place = city.frame.lonLatFromLocal({pick.position.x, pick.position.y});
    return QObject::tr("%1   height %2   x %3 m, y %4 m")
        .arg(describeLatLon(place))
        .arg(describeLength(pick.position.z))
        .arg(groupDigits(pick.position.x, 1))
        .arg(groupDigits(pick.position.y, 1));
}

QString buildingText(const Building& building, const City& city) {
    const QString name = QString::fromStdString(building.name.empty() ? building.sourceId : building.name);
    const double groundM = double(findGroundUnder(building, city));
    const Box2 box = bounds(building);
    const glm::dvec2 middle = glm::dvec2(box.low + box.high) / 2.0;
    QString text =
        heightReferenceInUse() == HeightReference::datum
            ? QObject::tr("%1, top %2")
                  .arg(name, describeHeight(double(heightM(building, city)),
                                            computeElevation(city, {middle, groundM})))
            : QObject::tr("%1, %2 high").arg(name, describeLength(double(heightM(building, city))));
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
    if (std::isnan(gross)) return QObject::tr("not measured");
    if (instant) return gross > 0 ? QObject::tr("in shadow") : QObject::tr("in the sun");
    const QString text = QObject::tr("gross %1 min a day").arg(groupDigits(double(gross), 1));
    if (std::isnan(continuous)) return text;
    return text + QObject::tr(", continuous %1 min").arg(groupDigits(double(continuous), 1));
}

QString formatShown(float gross, float continuous, const ShownQuantity& quantity) {
    if (!quantity.isSun() || std::isnan(gross)) return formatMinutes(gross, continuous, false);
    const auto formatted = [&](ShownAs as) {
        return groupDigits(ShownQuantity{as, quantity.sunlitMin}.of(double(gross)),
                           as == ShownAs::sun ? 2 : 1);
    };
    const QString text = QObject::tr("%1 h of sun a day (%2 % of the sunlit time)")
                             .arg(formatted(ShownAs::sun), formatted(ShownAs::share));
    if (std::isnan(continuous)) return text;
    return text + QObject::tr(", continuous shadow %1 min").arg(groupDigits(double(continuous), 1));
}

QString formatMinutes(const ShadowField& field, glm::dvec2 point, ShownAs show) {
    const auto cell = cellAt(field.grid, point);
    if (!cell) return {};
    const float gross = field.grossMin[*cell], continuous = field.continuousMin[*cell];
    if (isInstant(field)) return formatMinutes(gross, continuous, true);
    return formatShown(gross, continuous, {show, field.sunlitMinutesPerDay});
}

QString hoverText(const Pick& pick, const City& city, const QString& minutes) {
    QString text = placeText(pick, city);
    if (pick.building) text += QStringLiteral("   ") + buildingText(*city.buildings[*pick.building], city);
    return minutes.isEmpty() ? text : text + QStringLiteral("   ") + minutes;
}

}  // namespace noonmark
