#include "app/gui/session/study/region_text.h"

#include <QObject>
#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "app/gui/base/widgets/error_text.h"
#include "app/gui/base/widgets/number_text.h"
#include "core/base/units.h"
#include "core/receivers/made_names.h"

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

namespace {

// "park (OSM way 12)": the name of a place that the data does not name.
std::optional<QString> nameOfUnnamed(const std::string& name) {
    const auto open = name.find(" (");
    if (open == name.npos || !name.ends_with(')')) return std::nullopt;
    const auto kind = parsePlaceKind(name.substr(0, open));
    if (!kind) return std::nullopt;
    const std::string source = name.substr(open + 2, name.size() - open - 3);
    return QObject::tr("%1 (%2)").arg(describeKind(*kind), placeName(source));
}

// "Community Garden (2)": the second of this name.
std::optional<QString> nameOfNumbered(const std::string& name) {
    const auto numbered = splitNumber(name);
    if (!numbered) return std::nullopt;
    return placeName(std::string(numbered->name)) + QString::fromStdString(std::string(numbered->number));
}

}  // namespace

QString placeName(const std::string& name) {
    if (const auto unnamed = nameOfUnnamed(name)) return *unnamed;
    if (const auto numbered = nameOfNumbered(name)) return *numbered;
    const auto made = findMadeName(name);
    if (!made) return QString::fromStdString(name);
    std::vector<std::string> parts;
    for (const Sentence::Argument& part : made->arguments)
        parts.push_back(placeName(std::get<std::string>(part)).toStdString());
    return QString::fromStdString(fillIn(translated(made->source).toStdString(), parts));
}

QString describeRegion(const Region& region, double cellM) {
    if (region.polygons.empty()) return QObject::tr("No region yet");
    const double areaM2 = area(region);
    const Box2 box = bounds(region);
    const QString name = region.name.empty() ? QObject::tr("Polygon") : placeName(region.name);
    const double cells = areaM2 / (cellM * cellM);
    return QObject::tr("%1\n%2 × %3, %4, %5 cell(s)", "", pluralNumber(quint64(std::round(cells))))
        .arg(name.at(0).toUpper() + name.mid(1))
        .arg(describeLength(double(box.high.x - box.low.x), 0))
        .arg(describeLength(double(box.high.y - box.low.y), 0))
        .arg(describeArea(areaM2), groupDigits(cells));
}

}  // namespace noonmark
