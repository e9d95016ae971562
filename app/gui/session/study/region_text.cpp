#include "app/gui/session/study/region_text.h"

#include <QObject>
#include <cmath>

#include "app/gui/base/widgets/number_text.h"
#include "core/base/units.h"

namespace noonmark {

QString describeKind(PlaceKind kind) {
    switch (kind) {
        case PlaceKind::park:
            return QObject::tr("park");
        case PlaceKind::playground:
            return QObject::tr("playground");
        case PlaceKind::schoolyard:
            return QObject::tr("schoolyard");
        case PlaceKind::plaza:
            return QObject::tr("plaza");
        case PlaceKind::greenstreet:
            return QObject::tr("lawn or bed");
        case PlaceKind::cemetery:
            return QObject::tr("cemetery");
        case PlaceKind::street:
            return QObject::tr("street");
        case PlaceKind::facade:
            return QObject::tr("facade");
        case PlaceKind::stainedGlass:
            return QObject::tr("stained glass");
        case PlaceKind::other:
            return QObject::tr("other place");
    }
    return {};
}

QString describeKinds(PlaceKind kind) {
    switch (kind) {
        case PlaceKind::park:
            return QObject::tr("Parks");
        case PlaceKind::playground:
            return QObject::tr("Playgrounds");
        case PlaceKind::schoolyard:
            return QObject::tr("Schoolyards");
        case PlaceKind::plaza:
            return QObject::tr("Plazas");
        case PlaceKind::greenstreet:
            return QObject::tr("Lawns and beds");
        case PlaceKind::cemetery:
            return QObject::tr("Cemeteries");
        case PlaceKind::street:
            return QObject::tr("Streets");
        case PlaceKind::facade:
            return QObject::tr("Facades");
        case PlaceKind::stainedGlass:
            return QObject::tr("Stained glass");
        case PlaceKind::other:
            return QObject::tr("Other places");
    }
    return {};
}

QString describeRegion(const Region& region, double cellM) {
    if (region.polygons.empty()) return QObject::tr("No region yet");
    const double areaM2 = area(region);
    const Box2 box = bounds(region);
    const QString name =
        region.name.empty() ? QStringLiteral("Polygon") : QString::fromStdString(region.name);
    const double cells = areaM2 / (cellM * cellM);
    return QObject::tr("%1\n%2 × %3, %4, %5 cell(s)", "", pluralNumber(quint64(std::round(cells))))
        .arg(name.at(0).toUpper() + name.mid(1))
        .arg(describeLength(double(box.high.x - box.low.x), 0))
        .arg(describeLength(double(box.high.y - box.low.y), 0))
        .arg(describeArea(areaM2), groupDigits(cells));
}

}  // namespace noonmark
